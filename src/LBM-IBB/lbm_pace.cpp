// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_pace.h"

#include "lbm_solver.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

namespace lbm {
namespace {

  constexpr double BUDGET = 0.1;    // seconds for one of the two measurements
  constexpr int PARTS = 5;
  constexpr double MOST = 400000.0;    // nodes of a block: 58 MiB, beyond the cache of a core
  constexpr double SPEED = 0.01;       // of the grains; links are found anew however slow they are

  // of a step, the slowest rank's; all ranks make as many
  template <class Step> double seconds_of(const Step &step, Neighbours &neighbours)
  {
    using Clock = std::chrono::steady_clock;
    auto timed = [&](int times) {
      const auto start = Clock::now();
      for (int k = 0; k < times; k++) step();
      double seconds = std::chrono::duration<double>(Clock::now() - start).count() / times;
      neighbours.max(&seconds, 1);
      return seconds;
    };
    timed(2);    // memory is touched for the first time, by steps of both parities
    std::array<double, PARTS> parts{};    // the median, as others may use the machine for a moment
    const int times = int(std::clamp(BUDGET / PARTS / timed(1), 1.0, 400.0));
    for (double &part : parts) part = timed(times);
    std::sort(parts.begin(), parts.end());
    return parts[PARTS / 2];
  }

  // Spheres of a cell of the array, in its lengths: simple, body-centred, face-centred; in two
  // dimensions simple and centred
  using Basis = std::vector<Vec3>;
  const std::array<std::vector<Basis>, 2> BASES = {
      {{{{0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}}},
       {{{0.0, 0.0, 0.0}},
        {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}},
        {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}}}}};

  // shortest distance between spheres of an array of such cells
  double nearest(const Basis &basis, const Vec3 &cell, int dimension)
  {
    double least = *std::min_element(cell.begin(), cell.begin() + dimension);
    for (std::size_t k = 1; k < basis.size(); k++) {
      Vec3 x{};
      for (int d = 0; d < dimension; d++) x[d] = basis[k][d] * cell[d];
      least = std::min(least, std::sqrt(dot(x, x)));
    }
    return least;
  }

  struct Array {
    Basis basis;
    Int3 count{1, 1, 1};    // of cells
  };

  // as many spheres as the fraction of solid asks for, as nearly as they can be had out of touch: in
  // a small block one kind of cell misses it by half, and with it the narrow gaps of a bed
  Array choose_array(const PaceSample &sample, const Int3 &n)
  {
    const int D = sample.dimension;
    const double r = sample.radius, volume = D == 2 ? M_PI * r * r : 4.0 / 3.0 * M_PI * r * r * r,
                 wanted = sample.fraction * n[0] * n[1] * n[2] / volume;
    Array best{BASES[D - 2][0]};
    double misses = std::abs(wanted - 1.0);
    for (const Basis &basis : BASES[D - 2]) {
      const double length = std::pow(volume * double(basis.size()) / sample.fraction, 1.0 / D);
      Int3 least{1, 1, 1}, most{1, 1, 1};
      for (int d = 0; d < D; d++) {
        least[d] = std::max(1, int(n[d] / length) - 1);
        most[d] = int(n[d] / length) + 2;
      }
      Int3 c;
      for (c[2] = least[2]; c[2] <= most[2]; c[2]++)
        for (c[1] = least[1]; c[1] <= most[1]; c[1]++)
          for (c[0] = least[0]; c[0] <= most[0]; c[0]++) {
            Vec3 cell;
            for (int d = 0; d < 3; d++) cell[d] = double(n[d]) / c[d];
            const double off = std::abs(wanted - double(basis.size()) * c[0] * c[1] * c[2]);
            if (off < misses && nearest(basis, cell, D) >= 2.01 * r) {
              misses = off;
              best = {basis, c};
            }
          }
    }
    return best;
  }

  // An array that is the same in every block and goes on over its faces: those of its spheres that
  // reach the nodes or ghosts of this block.
  std::vector<Sphere> array_of_spheres(const PaceSample &sample, const Int3 &lo, const Int3 &n)
  {
    const int D = sample.dimension;
    const double r = sample.radius, spin = sample.moving ? SPEED / r : 0.0;
    const Array array = choose_array(sample, n);
    Int3 from{}, to{};
    for (int d = 0; d < D; d++) {
      from[d] = -1;
      to[d] = array.count[d];
    }
    std::vector<Sphere> list;
    for (int z = from[2]; z <= to[2]; z++)
      for (int y = from[1]; y <= to[1]; y++)
        for (int x = from[0]; x <= to[0]; x++)
          for (const Vec3 &in_cell : array.basis) {
            const Int3 at{x, y, z};
            Vec3 centre{};
            bool here = true;
            for (int d = 0; d < D; d++) {
              const double inside = (at[d] + in_cell[d] + 0.37) * n[d] / array.count[d];
              here = here && inside + r > -2.0 && inside - r < n[d] + 2.0;
              centre[d] = snap(lo[d] + inside);
            }
            // which of two spheres owns a node hangs on the number only at equal depth
            if (here) list.push_back({std::int64_t(list.size()), centre, r, {}, {0.0, 0.0, spin}});
          }
    return list;
  }

  Vec3 snapped_middle(const Int3 &lo, const Int3 &n, int dimension)
  {
    Vec3 x{};
    for (int d = 0; d < dimension; d++) x[d] = snap(lo[d] + 0.5 * n[d] + 0.13);
    return x;
  }

}    // namespace

double links_of_sphere(double r, int dimension)
{
  const double diagonal = std::sqrt(2.0);
  if (dimension == 2) return 2.0 * M_PI * r * (4.0 + 4.0 * diagonal) / M_PI;
  return 4.0 * M_PI * r * r * (6.0 + 12.0 * diagonal) / 4.0;
}

Pace measure_pace(const PaceSample &sample, int rank, int ranks, Neighbours &neighbours)
{
  const int D = sample.dimension, last = D - 1;
  Int3 n = sample.n, lo{}, global;
  const bool grains = sample.radius > 0.0;
  if (grains)
    for (int d = 0; d < D; d++) n[d] = std::max(n[d], int(std::ceil(2.0 * sample.radius)) + 4);
  for (int d = last; d >= 0; d--) {    // fewer planes first: rows stay as long as they are
    const double area = double(n[0]) * n[1] * n[2] / n[d];
    const int least = grains ? int(std::ceil(2.0 * sample.radius)) + 4 : 4;
    n[d] = std::min(n[d], std::max(least, int(MOST / area)));
  }
  global = n;
  global[last] = n[last] * ranks;
  lo[last] = n[last] * rank;

  Settings settings;
  settings.dimension = D;
  settings.single = sample.single;
  settings.tau = sample.tau;
  const auto fluid = Fluid::create(settings, lo, n, global, neighbours);
  fluid->set_force({1e-9, 0.0, 0.0});    // most scenes have one, at some cost in every node
  fluid->fill(0.0);
  std::vector<Load> loads;
  std::vector<Sphere> spheres;
  int steps = 0;
  auto step = [&] {
    const double sign = steps++ / 50 % 2 ? -1.0 : 1.0;    // to and fro: all stay where they are
    for (Sphere &s : spheres) {
      s.velocity[0] = sample.moving ? sign * SPEED : 0.0;
      s.centre[0] = snap(s.centre[0] + s.velocity[0]);
    }
    fluid->follow(spheres);
    fluid->advance(loads);
  };
  // seconds of a step and links of it: few, then many. Where grains move all nodes have a little more
  // to do, so that one grain moves from the beginning.
  struct Found {
    double seconds, links;
  };
  auto found = [&](std::vector<Sphere> list) {
    spheres = std::move(list);
    Found f{seconds_of(step, neighbours), fluid->links()};
    neighbours.max(&f.links, 1);
    return f;
  };
  const double nodes = double(fluid->layout().nodes());
  std::vector<Sphere> few;
  if (grains && sample.moving) few.push_back({0, snapped_middle(lo, n, D), sample.radius, {}, {}});
  const Found one = found(few);
  Pace pace;
  pace.node = one.seconds / nodes;
  if (grains) {
    const Found all = found(array_of_spheres(sample, lo, n));
    // no more can be saved than the sweep of the solid nodes
    const double least = -sample.fraction * nodes * pace.node;
    if (all.links > one.links) {
      pace.link =
          std::max(least / all.links, (all.seconds - one.seconds) / (all.links - one.links));
      // of one grain; a machine that got busy in between would make it more than all there is
      pace.node -= std::min(0.5 * pace.node, pace.link * one.links / nodes);
    }
  }
  pace.bytes = fluid->bytes() / double(fluid->layout().size);
  neighbours.max(&pace.bytes, 1);
  return pace;
}

}    // namespace lbm
