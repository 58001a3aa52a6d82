// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_monitor.h"

#include "lbm_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lbm {

namespace {

  constexpr double INF = std::numeric_limits<double>::infinity();

  // sums and extremes over the nodes that took the same lane of W
  template <int W> struct Lanes {
    using V = Pack<W>;
    V nodes{}, drho{}, momentum[3]{}, velocity[3]{};
    V speed2{}, low = V{} + INF, high = V{} - INF;

    template <class L, bool SOLIDS>
    LBM_INLINE void add(const Slots<L> &f, Index n, const int32_t *owner, const Vec3 &force)
    {
      const V one = V{} + 1.0;
      V rho1{}, j[3]{}, squared{}, fluid = one, lowest, highest;
      unroll<L::Q>([&](auto i) LBM_INLINE {
        const V fi = convert<V>(load<Pack<W, typename L::Real>>(f[i] + n));
        rho1 = rho1 + fi;
        unroll<L::D>([&](auto d) LBM_INLINE {
          if constexpr (L::e[i][d] > 0) j[d] = j[d] + fi;
          if constexpr (L::e[i][d] < 0) j[d] = j[d] - fi;
        });
      });
      for (int d = 0; d < L::D; d++) j[d] = j[d] + 0.5 * force[d];
      lowest = highest = rho1;
      if constexpr (SOLIDS) {
        const auto solid = load<PackInt<W>>(owner + n);
        fluid = where_fluid<W>(solid, one);
        lowest = where_fluid<W>(solid, rho1, V{} + INF);
        highest = where_fluid<W>(solid, rho1, V{} - INF);
        rho1 = where_fluid<W>(solid, rho1);
        for (int d = 0; d < L::D; d++) j[d] = where_fluid<W>(solid, j[d]);
      }
      const V volume = 1.0 / (1.0 + rho1);
      for (int d = 0; d < L::D; d++) {
        const V u = j[d] * volume;
        momentum[d] = momentum[d] + j[d];
        velocity[d] = velocity[d] + u;
        squared = squared + u * u;
      }
      nodes = nodes + fluid;
      drho = drho + rho1;
      speed2 = speed2 < squared ? squared : speed2;
      low = lowest < low ? lowest : low;
      high = high < highest ? highest : high;
    }
  };

  double lane(double v, int)
  {
    return v;
  }
  template <class V> double lane(const V &v, int k)
  {
    return v[k];
  }

  // the same in plain numbers
  struct Part : Lanes<1> {
    template <int W> void add(const Lanes<W> &other)
    {
      for (int k = 0; k < W; k++) {
        nodes += lane(other.nodes, k);
        drho += lane(other.drho, k);
        for (int d = 0; d < 3; d++) {
          momentum[d] += lane(other.momentum[d], k);
          velocity[d] += lane(other.velocity[d], k);
        }
        speed2 = std::max(speed2, lane(other.speed2, k));
        low = std::min(low, lane(other.low, k));
        high = std::max(high, lane(other.high, k));
      }
    }
    // what is not a number is in the sums, though not in the extremes
    bool sound() const
    {
      const double all = velocity[0] + velocity[1] + velocity[2] + drho + speed2;
      return std::isfinite(all) && low > -1.0 && high < INF;
    }
  };

  template <class L> struct Surveyor {
    const Layout &at;
    const Slots<L> &f;
    const int32_t *owner;
    const Vec3 &force;
    static constexpr int W = SIMD_WIDTH;

    template <int N> LBM_INLINE void add(Lanes<N> &lanes, Index n) const
    {
      if (owner)
        lanes.template add<L, true>(f, n, owner, force);
      else
        lanes.template add<L, false>(f, n, owner, force);
    }

    Part row(int y, int z) const
    {
      Lanes<W> packs;
      Lanes<1> rest;
      const Index begin = at.index(0, y, z), end = begin + at.n[0];
      Index n = begin;
      for (; n + W <= end; n += W) {
        if constexpr (READS_AHEAD<L>) read_ahead<L>(f, n + AHEAD<L>);
        add(packs, n);
      }
      for (; n < end; n++) add(rest, n);
      Part part;
      part.add(packs);
      part.add(rest);
      return part;
    }

    Part node(int x, int y, int z) const
    {
      Lanes<1> lane;
      add(lane, at.index(x, y, z));
      Part part;
      part.add(lane);
      return part;
    }

    // node by node, what is wrong left out
    Part careful_row(int y, int z, Survey &s) const
    {
      Part all;
      for (int x = 0; x < at.n[0]; x++) {
        const Part one = node(x, y, z);
        if (one.sound()) {
          all.add(one);
          continue;
        }
        all.nodes += 1.0;
        if (!s.bad) {
          s.bad = true;
          s.bad_node = {x + at.lo[0], y + at.lo[1], z + at.lo[2]};
          s.bad_drho = one.drho;
        }
      }
      return all;
    }

    // the node of a row where value(node) is largest
    template <class F> Extreme largest(const Int3 &row, F &&value) const
    {
      Extreme most{-INF, {}};
      for (int x = 0; x < at.n[0]; x++) {
        const Part one = node(x, row[1], row[2]);
        if (one.nodes > 0.0 && one.sound() && value(one) > most.value)
          most = {value(one), {x + at.lo[0], row[1] + at.lo[1], row[2] + at.lo[2]}};
      }
      return most;
    }
  };

}    // namespace

template <class L>
Survey survey(const Layout &at, const Slots<L> &f, const int32_t *owner, const Vec3 &force)
{
  const Surveyor<L> of{at, f, owner, force};
  Survey s;
  Part all;
  Int3 fastest{}, lightest{}, heaviest{};    // rows
  for (int z = 0; z < at.n[2]; z++)
    for (int y = 0; y < at.n[1]; y++) {
      Part row = of.row(y, z);
      if (!row.sound()) row = of.careful_row(y, z, s);
      if (row.speed2 > all.speed2) fastest = {0, y, z};
      if (row.low < all.low) lightest = {0, y, z};
      if (row.high > all.high) heaviest = {0, y, z};
      all.add(row);
    }
  s.fluid_nodes = all.nodes;
  s.mass = all.nodes + all.drho;
  std::copy_n(all.momentum, 3, s.momentum.begin());
  std::copy_n(all.velocity, 3, s.velocity.begin());
  s.drho_min.value = INF;
  s.drho_max.value = -INF;
  if (all.nodes == 0.0) return s;
  if (all.speed2 > 0.0) {
    s.speed = of.largest(fastest, [](const Part &p) {
      return p.speed2;
    });
    s.speed.value = std::sqrt(s.speed.value);
  }
  s.drho_min = of.largest(lightest, [](const Part &p) {
    return -p.low;
  });
  s.drho_min.value = -s.drho_min.value;
  s.drho_max = of.largest(heaviest, [](const Part &p) {
    return p.high;
  });
  return s;
}

void reduce(Survey &s, Neighbours &neighbours)
{
  double sums[] = {s.fluid_nodes, s.mass,        s.momentum[0], s.momentum[1],
                   s.momentum[2], s.velocity[0], s.velocity[1], s.velocity[2]};
  double most[] = {s.speed.value, -s.drho_min.value, s.drho_max.value, s.bad ? 1.0 : 0.0};
  neighbours.sum(sums, 8);
  neighbours.max(most, 4);
  s.fluid_nodes = sums[0];
  s.mass = sums[1];
  std::copy_n(sums + 2, 3, s.momentum.begin());
  std::copy_n(sums + 5, 3, s.velocity.begin());
  s.speed.value = most[0];
  s.drho_min.value = -most[1];
  s.drho_max.value = most[2];
  s.bad = most[3] > 0.0;
  if (s.fluid_nodes == 0.0) s.drho_min.value = s.drho_max.value = 0.0;
}

#define LBM_INSTANTIATE(L) \
  template Survey survey<L>(const Layout &, const Slots<L> &, const int32_t *, const Vec3 &);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
