// SPDX-License-Identifier: GPL-2.0-only
// Collision rules and forces, as policies of the sweep. Lattice units, deviations from rest.
//
// A collision rule is called with the Q populations of one pack of nodes and turns them into the
// post-collision ones; it returns the density excess. To add one: write a struct like Trt.

#ifndef LBM_COLLIDE_H
#define LBM_COLLIDE_H

#include "lbm_lattice.h"
#include "lbm_simd.h"

#include <array>

namespace lbm {

// no force on the fluid: costs nothing
struct NoForce {
  static constexpr bool present = false;
};

// the same force density everywhere: a body acceleration or a uniform pressure gradient
struct UniformForce {
  static constexpr bool present = true;
  std::array<double, 3> F;
};

// e.v summed over the nonzero components of e only, known at compile time
template <class L, int I, class V> LBM_INLINE inline V along(const V (&v)[3])
{
  constexpr const int(&e)[3] = L::e[I];
  constexpr int first = e[0] ? 0 : (e[1] ? 1 : 2);
  V s = e[first] > 0 ? v[first] : -v[first];
  unroll<3>([&](auto d) LBM_INLINE {
    if constexpr (d > first && e[d] > 0) s = s + v[d];
    if constexpr (d > first && e[d] < 0) s = s - v[d];
  });
  return s;
}

// Two-relaxation-time rule (Ginzburg, Verhaeghe & d'Humieres 2008) with Guo's forcing (2002),
// split into its even and odd parts. BGK (eq. 9) is the same with both rates equal.
template <class L> struct Trt {
  using Real = typename L::Real;
  Real even, odd;    // relaxation rates 1/tau+ and 1/tau-

  static Trt bgk(double tau) { return {Real(1.0 / tau), Real(1.0 / tau)}; }
  static Trt trt(double tau, double magic)
  {
    return {Real(1.0 / tau), Real(1.0 / (0.5 + magic / (tau - 0.5)))};
  }

  template <class V, class Force>
  LBM_INLINE inline V operator()(V (&f)[L::Q], const Force &force) const
  {
    V drho = f[0], u[3] = {V{}, V{}, V{}}, j[3], usq = V{}, uF = V{};
    unroll<L::P>([&](auto p) LBM_INLINE {
      constexpr int i = p + 1, o = i + L::P;
      const V odd_part = f[i] - f[o];
      drho = drho + (f[i] + f[o]);
      unroll<3>([&](auto d) LBM_INLINE {
        if constexpr (L::e[i][d] > 0) u[d] = u[d] + odd_part;
        if constexpr (L::e[i][d] < 0) u[d] = u[d] - odd_part;
      });
    });
    const V rho = drho + Real(1.0);
    const V per_rho = Real(1.0) / rho;
    unroll<3>([&](auto d) LBM_INLINE {
      if constexpr (d < L::D) {
        if constexpr (Force::present) u[d] = u[d] + Real(0.5 * force.F[d]);
        j[d] = u[d];
        u[d] = u[d] * per_rho;
        usq = usq + j[d] * u[d];
        if constexpr (Force::present) uF = uF + Real(force.F[d]) * u[d];
      }
    });
    const Real Fe = Real(1.0) - Real(0.5) * even, Fo = Real(1.0) - Real(0.5) * odd;

    // part of the even equilibrium that all directions share, per weight
    const V base = drho - Real(1.5) * usq;
    V rest = even * (Real(L::w[0]) * base - f[0]);
    if constexpr (Force::present) rest = rest - (Fe * Real(L::w[0] * 3.0)) * uF;
    f[0] = f[0] + rest;

    unroll<L::P>([&](auto p) LBM_INLINE {
      constexpr int i = p + 1, o = i + L::P;
      constexpr Real w = Real(L::w[i]);
      const V ej = along<L, i>(j), eu = along<L, i>(u);
      const V even_eq = w * (base + Real(4.5) * (ej * eu));
      const V odd_eq = Real(3.0 * L::w[i]) * ej;
      V de = even * (even_eq - Real(0.5) * (f[i] + f[o]));
      V dod = odd * (odd_eq - Real(0.5) * (f[i] - f[o]));
      if constexpr (Force::present) {
        const Real eF =
            Real(L::e[i][0] * force.F[0] + L::e[i][1] * force.F[1] + L::e[i][2] * force.F[2]);
        de = de + (Fe * w) * (Real(9.0) * eF * eu - Real(3.0) * uF);
        dod = dod + Fo * w * Real(3.0) * eF;
      }
      f[i] = f[i] + (de + dod);
      f[o] = f[o] + (de - dod);
    });
    return drho;
  }
};

// Regularised rule (Latt & Chopard 2006): of what is beyond equilibrium the stress alone is kept.
// In the terms above the odd rate is 1 and even parts that are no stress vanish: nothing but the
// stress can ring, and flows stay finite at whatever tau; walls are where Lambda = (tau - 1/2)/2
// puts them.
template <class L> struct Regularised {
  using Real = typename L::Real;
  Real even;    // 1/tau

  static Regularised with(double tau) { return {Real(1.0 / tau)}; }

  template <class V, class Force>
  LBM_INLINE inline V operator()(V (&f)[L::Q], const Force &force) const
  {
    V drho = f[0], u[3] = {V{}, V{}, V{}}, j[3], usq = V{}, uF = V{};
    V stress[3][3] = {};    // upper triangle: of all, then of what is beyond equilibrium
    unroll<L::P>([&](auto p) LBM_INLINE {
      constexpr int i = p + 1, o = i + L::P;
      const V odd_part = f[i] - f[o], even_part = f[i] + f[o];
      drho = drho + even_part;
      unroll<3>([&](auto a) LBM_INLINE {
        if constexpr (L::e[i][a] > 0) u[a] = u[a] + odd_part;
        if constexpr (L::e[i][a] < 0) u[a] = u[a] - odd_part;
        unroll<3>([&](auto b) LBM_INLINE {
          if constexpr (a <= b && L::e[i][a] * L::e[i][b] > 0)
            stress[a][b] = stress[a][b] + even_part;
          if constexpr (a <= b && L::e[i][a] * L::e[i][b] < 0)
            stress[a][b] = stress[a][b] - even_part;
        });
      });
    });
    const V per_rho = Real(1.0) / (drho + Real(1.0));
    unroll<L::D>([&](auto d) LBM_INLINE {
      if constexpr (Force::present) u[d] = u[d] + Real(0.5 * force.F[d]);
      j[d] = u[d];
      u[d] = u[d] * per_rho;
      usq = usq + j[d] * u[d];
      if constexpr (Force::present) uF = uF + Real(force.F[d]) * u[d];
    });
    for (int d = L::D; d < 3; d++) j[d] = V{};
    V trace = V{};
    unroll<L::D>([&](auto a) LBM_INLINE {
      stress[a][a] = stress[a][a] - Real(1.0 / 3.0) * drho;
      unroll<L::D>([&](auto b) LBM_INLINE {
        if constexpr (a <= b) stress[a][b] = stress[a][b] - j[a] * u[b];
      });
      trace = trace + stress[a][a];
    });

    // 4.5 w (ee - I/3):stress (1 - 1/tau), the part along no direction apart
    const Real keep = Real(4.5) * (Real(1.0) - even), Fe = Real(1.0) - Real(0.5) * even;
    const V base = drho - Real(1.5) * usq - keep * Real(1.0 / 3.0) * trace;
    f[0] = Real(L::w[0]) * base;
    if constexpr (Force::present) f[0] = f[0] - (Fe * Real(L::w[0] * 3.0)) * uF;
    unroll<L::P>([&](auto p) LBM_INLINE {
      constexpr int i = p + 1, o = i + L::P;
      constexpr Real w = Real(L::w[i]);
      const V ej = along<L, i>(j), eu = along<L, i>(u);
      V along_stress = V{};
      unroll<3>([&](auto a) LBM_INLINE {
        unroll<3>([&](auto b) LBM_INLINE {
          constexpr int times = (a == b ? 1 : 2) * L::e[i][a] * L::e[i][b];
          if constexpr (a <= b && times != 0)
            along_stress = along_stress + Real(times) * stress[a][b];
        });
      });
      V even_new = w * (base + Real(4.5) * (ej * eu) + keep * along_stress);
      V odd_new = Real(3.0 * L::w[i]) * ej;
      if constexpr (Force::present) {
        const Real eF =
            Real(L::e[i][0] * force.F[0] + L::e[i][1] * force.F[1] + L::e[i][2] * force.F[2]);
        even_new = even_new + (Fe * w) * (Real(9.0) * eF * eu - Real(3.0) * uF);
        odd_new = odd_new + Real(1.5) * w * eF;
      }
      f[i] = even_new + odd_new;
      f[o] = even_new - odd_new;
    });
    return drho;
  }
};

}    // namespace lbm
#endif
