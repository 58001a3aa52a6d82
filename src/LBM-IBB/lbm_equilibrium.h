// SPDX-License-Identifier: GPL-2.0-only
// Equilibrium and moments, lattice units, in deviations from rest (f - w).
//
// Equilibrium: Mansouri et al. 2016, eq. 10, with c = 1:
//     f_i = rho w_i [1 + 3 e.u + 4.5 (e.u)^2 - 1.5 u^2]

#ifndef LBM_EQUILIBRIUM_H
#define LBM_EQUILIBRIUM_H

#include "lbm_block.h"

namespace lbm {

// Density excess rho - 1 and velocity of one node; the velocity includes half the force of the step
struct Moments {
  double drho;
  Vec3 u;
};

template <class E> constexpr double dot(const E &a, const Vec3 &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 cross(const Vec3 &a, const Vec3 &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// f_i^eq - w_i
template <class L> double equilibrium(int i, const Moments &m)
{
  const double eu = dot(L::e[i], m.u);
  return L::w[i] * (m.drho + (1.0 + m.drho) * (3.0 * eu + 4.5 * eu * eu - 1.5 * dot(m.u, m.u)));
}

// The same for populations before collision, which carry the bare momentum rho u - F/2
template <class L> double bare_equilibrium(int i, const Moments &m, const Vec3 &force)
{
  return equilibrium<L>(i, m) - 1.5 * L::w[i] * dot(L::e[i], force);
}

// moments of the populations that arrive at node n (eq. 12; half-force correction after Guo et al.
// 2002); force is the force density on the fluid
template <class L> Moments moments(const Slots<L> &f, Index n, const Vec3 &force)
{
  Moments m{};
  for (int i = 0; i < L::Q; i++) {
    const double fi = f[i][n];
    m.drho += fi;
    for (int d = 0; d < L::D; d++) m.u[d] += L::e[i][d] * fi;
  }
  for (int d = 0; d < L::D; d++) m.u[d] = (m.u[d] + 0.5 * force[d]) / (1.0 + m.drho);
  return m;
}

}    // namespace lbm
#endif
