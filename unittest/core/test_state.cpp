// SPDX-License-Identifier: GPL-2.0-only
// The state of the fluid given to another one, which goes on as the first would have.

#include "scene.h"

#include <gtest/gtest.h>

#include <cstring>

namespace {

using lbm::Int3;
using lbm::Part;
using lbm::Sphere;
using lbm::Vec3;

const Int3 N{12, 11, 10};
const lbm::Lattice PERIODIC{N, {true, true, true}};

std::vector<Sphere> spheres()
{
  return {scene::sphere(1, {0.3, 10.9, 4.9}, 3.3, {4e-2, -3e-2, 1e-2}, {1e-2, 0, 2e-2}),
          scene::sphere(2, {6.1, 4.2, 5.3}, 2.7, {-3e-2, 1e-2, 0})};
}

template <class Real> std::vector<Real> populations(const lbm::Fluid &fluid)
{
  std::vector<Real> all(std::size_t(fluid.directions()) * N[0] * N[1] * N[2]);
  fluid.give({{0, 0, 0}, N}, all.data());
  return all;
}

// in parts, as other cuts of the lattice would ask for them
void hand_over(const lbm::Fluid &from, lbm::Fluid &to)
{
  for (const Part &part : {Part{{0, 0, 0}, {5, 11, 10}}, Part{{5, 0, 0}, {7, 4, 10}},
                           Part{{5, 4, 0}, {7, 7, 9}}, Part{{5, 4, 9}, {7, 7, 1}}}) {
    std::vector<char> data(part.nodes() * from.directions() * from.bytes_of_population());
    from.give(part, data.data());
    to.take(part, data.data());
  }
  lbm::Counts counts;
  counts.ledger = from.ledger();
  counts.mean = from.mean_density();
  to.resume(from.own_spheres(), counts);
}

template <class Real> void goes_on(bool single, const std::vector<int> &steps)
{
  for (const int before : steps) {
    lbm::Settings settings;
    settings.single = single;
    settings.hold_mean = true;
    const Vec3 force{1e-4, 0, -2e-4};
    scene::Box box(settings, N, force), other(settings, N, force);
    box.conserve = other.conserve = true;
    for (int t = 0; t < before; t++) {
      box.follow(scene::drifted(spheres(), t));
      box.advance();
    }
    hand_over(*box.fluid, *other.fluid);
    ASSERT_EQ(populations<Real>(*other.fluid), populations<Real>(*box.fluid));
    EXPECT_EQ(other.fluid->checksum(), box.fluid->checksum());
    other.remember(box);
    for (int t = before; t < before + 12; t++)
      for (scene::Box *b : {&box, &other}) {
        b->follow(scene::drifted(spheres(), t));
        b->advance();
      }
    EXPECT_EQ(populations<Real>(*other.fluid), populations<Real>(*box.fluid)) << before;
    EXPECT_EQ(other.fluid->ledger().numbers(), box.fluid->ledger().numbers());
    EXPECT_NE(box.fluid->ledger().gain(lbm::Ledger::RESTORED), 0.0);
    EXPECT_GT(box.fluid->refilled().grad, 0);
    EXPECT_NE(other.fluid->survey().speed.value, 0.0);
    for (std::size_t k = 0; k < box.loads.size(); k++)
      EXPECT_EQ(other.loads[k].force, box.loads[k].force);
  }
}

TEST(State, GoesOnWhateverTheParity)
{
  goes_on<double>(false, {14, 15});
}

TEST(State, GoesOnInSinglePrecision)
{
  goes_on<float>(true, {14, 15});
}

// a bit that is turned anywhere, or two values exchanged
TEST(State, ChecksumSeesEveryChange)
{
  scene::Box box({}, N);
  std::mt19937 random(4711);
  const Part all{{0, 0, 0}, N};
  std::vector<double> f = populations<double>(*box.fluid);
  std::uniform_real_distribution<double> any(-0.1, 0.1);
  for (double &value : f) value = any(random);
  box.fluid->take(all, f.data());
  const auto sum = box.fluid->checksum();
  std::uniform_int_distribution<std::size_t> place(0, f.size() - 1);
  for (int k = 0; k < 500; k++) {
    auto changed = f;
    const std::size_t a = place(random), b = place(random);
    if (k % 2 && a != b) {
      std::swap(changed[a], changed[b]);
    } else {
      std::uint64_t bits;
      std::memcpy(&bits, &changed[a], 8);
      bits ^= std::uint64_t(1) << (k / 2 % 64);
      std::memcpy(&changed[a], &bits, 8);
    }
    box.fluid->take(all, changed.data());
    ASSERT_NE(box.fluid->checksum(), sum) << a << " " << b;
  }
  box.fluid->take(all, f.data());
  EXPECT_EQ(box.fluid->checksum(), sum);
}

// of all blocks together each grain is centred in one, and its images are those of the scene
TEST(State, GrainsAndTheirImages)
{
  lbm::Settings settings;
  std::vector<Sphere> grains;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int id = 1; id <= 40; id++)
    grains.push_back(scene::sphere(id, {12 * unit(random), 11 * unit(random), 10 * unit(random)},
                                   2.0 + 5.0 * unit(random)));
  grains.push_back(scene::sphere(41, {0, 11, 5}, 2.5));    // on cuts
  auto key = [](const Sphere &a) {
    return std::make_pair(a.id, a.centre);
  };
  std::vector<Sphere> centred;
  for (const Part &part :
       {Part{{0, 0, 0}, {5, 11, 10}}, Part{{5, 0, 0}, {7, 4, 10}}, Part{{5, 4, 0}, {7, 7, 10}}}) {
    const lbm::Layout at(part.lo, part.n, 3);
    auto expected = scene::images(grains, settings, part.lo, part.n, N).spheres;
    auto found = lbm::reaching_here(grains, at, PERIODIC);
    EXPECT_TRUE(lbm::same_but_for_order(found, expected));
    const auto here = lbm::centred_here(found, at, PERIODIC);
    centred.insert(centred.end(), here.begin(), here.end());
  }
  std::sort(centred.begin(), centred.end(), [&](const Sphere &a, const Sphere &b) {
    return key(a) < key(b);
  });
  ASSERT_EQ(centred.size(), grains.size());
  for (std::size_t k = 0; k + 1 < grains.size(); k++) {
    EXPECT_EQ(centred[k].id, grains[k].id);
    EXPECT_EQ(centred[k].centre, grains[k].centre);
  }
}

// beyond a wall a grain belongs to the nearest node
TEST(State, GrainBeyondTheEnd)
{
  const lbm::Lattice closed{N, {false, true, true}};
  const auto grain = scene::sphere(7, {-0.6, 3.1, 4.2}, 2.5);
  const lbm::Layout low({0, 0, 0}, {5, 11, 10}, 3), high({5, 0, 0}, {7, 11, 10}, 3);
  EXPECT_EQ(lbm::centred_here(lbm::reaching_here({grain}, low, closed), low, closed).size(), 1u);
  EXPECT_EQ(lbm::reaching_here({grain}, high, closed).size(), 0u);
}

}    // namespace
