// SPDX-License-Identifier: GPL-2.0-only
// The link rules at plane walls, where the flow is known: links laid by hand along two parallel
// planes, inclined or not, at any distance from the nodes.

#include "lbm_bounce_back.h"
#include "lbm_exchange.h"
#include "lbm_halo.h"
#include "lbm_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace lbm;

namespace {

// A channel in a periodic box: fluid where 0 < s < height, s = (x_across - slope x_along - offset),
// modulo the box; solid, at least two nodes thick, elsewhere.
struct Shape {
  int along = 0, across = 1;
  double slope = 0.0;     // 0 or 1/2
  int n = 8;              // nodes across, and along if inclined twice as many
  double height = 6.0;    // along "across", not along the normal
  double offset = 0.0;

  double cosine() const { return 1.0 / std::sqrt(1.0 + slope * slope); }
  template <class P> double s(const P &p) const
  {
    const double v = p[across] - slope * p[along] - offset;
    return v - n * std::floor(v / n);
  }
};

template <class L, class Rule> class Channel {
 public:
  const Shape shape;
  const double tau;
  const Trt<L> collide;
  Layout at;
  Block<L> block;
  std::vector<Vec3> velocity, load;    // what settle() found, by node and by wall
  Links links;
  double u_low = 0.0, u_high = 0.0;    // of the walls, along the flow
  double accel = 0.0;

  Channel(const Shape &shape, double tau, bool bgk) :
      shape(shape), tau(tau), collide(bgk ? Trt<L>::bgk(tau) : Trt<L>::trt(tau, 3.0 / 16.0)),
      at(make_layout(shape)), block(at), neighbours({true, true, true}), halo(at, neighbours),
      cover(at, L::D, Cover::Sides{}),
      owner(at.size + at.stride_y + AHEAD<L>, FLUID),    // sweeps read ahead
      drho(at.size, 0.0F)
  {
    lay_links();
  }

  double nu() const { return (tau - 0.5) / 3.0; }
  double width() const { return shape.height * shape.cosine(); }
  Vec3 tangent() const
  {
    Vec3 t{};
    t[shape.along] = shape.cosine();
    t[shape.across] = shape.slope * shape.cosine();
    return t;
  }
  double exact(const Int3 &p) const
  {
    const double h = shape.s(p) * shape.cosine(), H = width();
    return u_low + (u_high - u_low) * h / H + accel / (2 * nu()) * h * (H - h);
  }

  Vec3 force() const
  {
    Vec3 F = tangent();
    for (double &component : F) component *= accel;
    return F;
  }

  // From the exact velocity on until nothing changes any more, then the mean of two steps: of the
  // start there remains a staggered momentum, (-1)^(x + t), which no collision damps.
  void settle()
  {
    for_each_node([&](const Int3 &p, Index n) {
      Moments m{0.0, tangent()};
      for (double &u : m.u) u *= exact(p);
      for (int i = 0; i < L::Q; i++)
        block.slots()[i][n] = equilibrium<L>(i, m) - 1.5 * L::w[i] * dot(L::e[i], force());
    });
    const double H = std::max(width(), 4.0), time = H * H / (M_PI * M_PI * nu());    // slowest mode
    for (int step = 0; step < 26.0 * time; step++) advance();
    velocity.assign(at.size, Vec3{});
    load.assign(2, Vec3{});
    for (int k = 0; k < 2; k++) {
      advance();
      for_each_node([&](const Int3 &, Index n) {
        const Vec3 u = moments<L>(block.slots(), n, force()).u;
        for (int d = 0; d < 3; d++) velocity[n][d] += 0.5 * u[d];
      });
      for (int wall = 0; wall < 2; wall++)
        for (int d = 0; d < 3; d++) load[wall][d] += 0.5 * loads[wall].force[d];
    }
  }

  // largest and root-mean-square error in terms of the largest and of the mean square velocity
  std::array<double, 2> errors() const
  {
    double most = 0.0, sum = 0.0, norm = 0.0, top = 0.0;
    for_each_node([&](const Int3 &p, Index n) {
      const double e = exact(p);
      for (int d = 0; d < 3; d++) {
        const double diff = velocity[n][d] - e * tangent()[d];
        most = std::max(most, std::abs(diff));
        sum += diff * diff;
      }
      norm += e * e;
      top = std::max(top, std::abs(e));
    });
    return {most / top, std::sqrt(sum / norm)};
  }

  template <class F> void for_each_node(F &&f) const
  {
    for (int z = 0; z < at.n[2]; z++)
      for (int y = 0; y < at.n[1]; y++)
        for (int x = 0; x < at.n[0]; x++)
          if (owner[at.index(x, y, z)] < 0) f(Int3{x, y, z}, at.index(x, y, z));
  }

 private:
  Alone neighbours;
  Halo<L> halo;
  Cover cover;
  std::vector<int32_t> owner;
  std::vector<float> drho;
  std::vector<Load> loads;

  static Layout make_layout(const Shape &shape)
  {
    Int3 n{1, 1, 1};
    n[shape.across] = shape.n;
    n[shape.along] = shape.slope == 0.0 ? 2 : 2 * shape.n;
    return Layout({0, 0, 0}, n, L::D);
  }

  void lay_links()
  {
    for (int z = 0; z < at.n[2]; z++)
      for (int y = 0; y < at.n[1]; y++)
        for (int x = 0; x < at.n[0]; x++) {
          const double s = shape.s(Int3{x, y, z});
          if (!(s > 0.0 && s < shape.height)) owner[at.index(x, y, z)] = 0;
        }
    // q of the link along i, and which wall it meets: 0 the low one, 1 the high one
    auto cut_at = [&](const Int3 &p, int i, int &wall) {
      const double s = shape.s(p), ds = L::e[i][shape.across] - shape.slope * L::e[i][shape.along];
      wall = ds < 0.0 ? 0 : 1;
      if (ds == 0.0) return 2.0;
      return (wall == 0 ? s : shape.height - s) / std::abs(ds);
    };
    for (int wall = 0; wall < 2; wall++)
      for (int i = 1; i < L::Q; i++) {
        const std::size_t begin = links.size, first_gap = links.gaps.size;
        for_each_node([&](const Int3 &p, Index n) {
          int meets = 0, other = 0;
          const double q = cut_at(p, i, meets), behind = cut_at(p, opposite<L>(i), other);
          if (meets != wall || q > 1.0) return;
          if (behind <= 1.0) {
            if (i > L::P) return;
            const std::size_t gap = links.gaps.size;
            links.gaps.add(int32_t(n), other);
            links.gaps.q_ahead[gap] = q;
            links.gaps.q_behind[gap] = behind;
            return;
          }
          links.q.push_back(q);
          links.node.push_back(int32_t(n));
          links.size++;
        });
        links.gaps.close(wall, i, first_gap);
        if (links.size > begin)
          links.groups.push_back({wall, i, uint32_t(begin), uint32_t(links.size)});
      }
    links.trim();    // whole packs are read
  }

  void advance()
  {
    // the walls' velocities are carried by two spheres that touch nothing, far behind the walls
    std::vector<Sphere> walls(2);
    for (int k = 0; k < 2; k++) {
      const double far = k == 0 ? -1e10 : 1e10;
      Vec3 centre{};
      centre[shape.across] = far;
      centre[shape.along] = -far * shape.slope;
      walls[k] = {k, centre, 1.0, tangent(), {}};
      for (double &u : walls[k].velocity) u *= k == 0 ? u_low : u_high;
    }
    if (!cover.same_places(walls)) cover.place(walls);
    cover.set_velocities(walls);
    sweep(block, collide, UniformForce{force()}, MovingSolids{owner.data(), drho.data()});
    halo.exchange(block);
    block.advance();
    loads.assign(2, {});
    Yields none;
    bounce_back<L, Rule, Motion::TURN, true, false>(at, block.slots(), cover, links, drho.data(),
                                                    loads, none);
  }
};

// Velocities of 1e-9, so that products of them are of no account; populations are deviations from
// rest, so that round-off is relative to them.
constexpr double TINY = 1e-9;

template <class L, class Rule> void couette(Shape shape, double tau, bool bgk)
{
  Channel<L, Rule> channel(shape, tau, bgk);
  channel.u_low = -0.3 * TINY;
  channel.u_high = TINY;
  channel.settle();
  EXPECT_LT(channel.errors()[0], 1e-8)
      << "slope " << shape.slope << " offset " << shape.offset << " tau " << tau << " bgk " << bgk;
  // shear stress on the walls: nu du/dh over their length
  const Int3 &n = channel.at.n;
  const double length = n[shape.along] / shape.cosine(),
               stress = channel.nu() * 1.3 * TINY / channel.width() * length;
  for (int k = 0; k < 2; k++)
    EXPECT_NEAR(dot(channel.tangent(), channel.load[k]), k == 0 ? stress : -stress, 1e-7 * stress);
}

template <class Rule> void couette_everywhere()
{
  for (double tau : {0.6, 1.3})
    for (bool bgk : {false, true}) {
      for (double offset : {0.05, 0.3, 0.5, 0.93})
        for (double height : {4.4, 5.7}) {
          couette<D2Q9, Rule>({0, 1, 0.0, 8, height, offset}, tau, bgk);
          couette<D2Q9, Rule>({1, 0, 0.0, 8, height, offset}, tau, bgk);
          couette<D3Q19, Rule>({0, 2, 0.0, 8, height, offset}, tau, bgk);
          couette<D3Q19, Rule>({2, 1, 0.0, 8, height, offset}, tau, bgk);
        }
      couette<D2Q9, Rule>({0, 1, 0.5, 8, 5.3, 0.21}, tau, bgk);
      couette<D3Q19, Rule>({0, 2, 0.5, 8, 5.3, 0.21}, tau, bgk);
    }
}

TEST(Planes, CouetteIsExactWithBouzidi)
{
  couette_everywhere<Bouzidi>();
}

TEST(Planes, CouetteIsExactWithZhao)
{
  couette_everywhere<Zhao>();
}

TEST(Planes, CouetteIsExactWithCli)
{
  couette_everywhere<Cli>();
}

// A channel one node wide: the pair of links closed together is exact, whatever the distances
TEST(Planes, CouetteInAGapOfOneNodeIsExact)
{
  auto both = [](double low, double height) {
    const Shape flat{0, 1, 0.0, 4, height, 1.0 - low};
    couette<D2Q9, Cli>(flat, 0.8, false);
    couette<D2Q9, Bouzidi>(flat, 0.8, false);
    couette<D2Q9, Zhao>(flat, 0.8, false);
    couette<D3Q19, Zhao>({0, 1, 0.0, 4, height, 1.0 - low}, 0.7, true);
    couette<D2Q9, Bouzidi>(flat, 0.7, true);
    couette<D3Q19, Cli>({0, 2, 0.0, 4, height, 1.0 - low}, 0.8, false);
    couette<D3Q19, Bouzidi>({2, 0, 0.0, 4, height, 1.0 - low}, 0.8, false);
  };
  both(0.1, 0.6);
  both(0.3, 0.45);
  both(0.5, 1.0);
  both(0.9, 1.5);
}

template <class L, class Rule> double poiseuille(int n, double height, double tau, double slope)
{
  Channel<L, Rule> channel({0, L::D - 1, slope, n, height, 0.3}, tau, false);
  channel.accel = 8.0 * channel.nu() * TINY / (channel.width() * channel.width());
  channel.settle();
  // all that drives the fluid arrives at the walls
  double fluid = 0.0;
  channel.for_each_node([&](const Int3 &, Index) {
    fluid += 1.0;
  });
  const Vec3 t = channel.tangent();
  EXPECT_NEAR(dot(t, channel.load[0]) + dot(t, channel.load[1]), channel.accel * fluid,
              1e-9 * channel.accel * fluid);
  return channel.errors()[1];
}

// Planes of slope 1/2, cut alike at all resolutions; the half-way rule sees stairs instead
TEST(Planes, TiltedPoiseuilleIsOfSecondOrder)
{
  auto order = [](auto rule, double tau) {
    using Rule = decltype(rule);
    const double coarse = poiseuille<D2Q9, Rule>(12, 9.4, tau, 0.5),
                 fine = poiseuille<D2Q9, Rule>(36, 27.4, tau, 0.5);
    return std::log(coarse / fine) / std::log(27.4 / 9.4);
  };
  EXPECT_GT(order(Cli{}, 0.8), 1.8);
  EXPECT_GT(order(Bouzidi{}, 0.8), 1.8);
  EXPECT_GT(order(Zhao{}, 0.8), 1.8);
  EXPECT_LT(order(Halfway{}, 0.8), 1.5);
}

// with CLI and two rates the velocity over accel / nu depends on their product Lambda alone
template <class L> void does_not_depend_on_viscosity(double slope)
{
  const double e = poiseuille<L, Cli>(10, 7.7, 0.6, slope);
  for (double tau : {0.8, 1.5}) {
    const double other = poiseuille<L, Cli>(10, 7.7, tau, slope);
    EXPECT_NEAR(other / e, 1.0, 1e-6);
  }
}

TEST(Planes, CliDoesNotDependOnViscosity)
{
  for (double slope : {0.0, 0.5}) {
    does_not_depend_on_viscosity<D2Q9>(slope);
    does_not_depend_on_viscosity<D3Q19>(slope);
  }
  // the test can tell: Bouzidi's error changes by more than a tenth
  const double thin = poiseuille<D2Q9, Bouzidi>(10, 7.7, 0.6, 0.5),
               thick = poiseuille<D2Q9, Bouzidi>(10, 7.7, 1.5, 0.5);
  EXPECT_GT(std::abs(thick / thin - 1.0), 0.1);
}

}    // namespace
