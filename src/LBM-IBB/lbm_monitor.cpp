// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_monitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lbm {

template <class L>
Survey survey(const Layout &at, const Slots<L> &f, const int32_t *owner, const Vec3 &force)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  Survey s;
  s.drho_min.value = inf;
  s.drho_max.value = -inf;
  double drho_sum = 0.0;
  for (int z = 0; z < at.n[2]; z++)
    for (int y = 0; y < at.n[1]; y++)
      for (int x = 0; x < at.n[0]; x++) {
        const Index n = at.index(x, y, z);
        if (owner && owner[n] >= 0) continue;
        const Moments m = moments<L>(f, n, force);
        const Int3 p{x + at.lo[0], y + at.lo[1], z + at.lo[2]};
        const double speed = std::sqrt(dot(m.u, m.u));
        s.fluid_nodes += 1.0;
        if (!std::isfinite(speed) || !(m.drho > -1.0)) {
          if (!s.bad) {
            s.bad_node = p;
            s.bad_drho = m.drho;
          }
          s.bad = true;
          continue;
        }
        drho_sum += m.drho;
        for (int d = 0; d < L::D; d++) {
          s.momentum[d] += (1.0 + m.drho) * m.u[d];
          s.velocity[d] += m.u[d];
        }
        if (speed > s.speed.value) s.speed = {speed, p};
        if (m.drho < s.drho_min.value) s.drho_min = {m.drho, p};
        if (m.drho > s.drho_max.value) s.drho_max = {m.drho, p};
      }
  s.mass = s.fluid_nodes + drho_sum;
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
