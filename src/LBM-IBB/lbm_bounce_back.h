// SPDX-License-Identifier: GPL-2.0-only
// Wall rules: the value that comes back along a cut link. Lattice units.
//
// i points from the fluid node x_f to the wall, o is its opposite, f* are post-collision values:
//     r1 = f*_i(x_f)    r2 = f*_i(x_f')    r3 = f*_o(x_f)
//     f_o(x_f, t+1) = c1 r1 + c2 r2 + c3 r3 - c4 (3 w_i rho e_i.u_w)
// c1 + c2 + c3 = 1 in every rule, so deviations f - w need no correction. To add a rule: write a
// struct like these, instantiate it in lbm_exchange.cpp and in lbm_yield.cpp, choose it in
// lbm_link_pass.cpp.

#ifndef LBM_BOUNCE_BACK_H
#define LBM_BOUNCE_BACK_H

namespace lbm {

template <class V> struct Coefficients {
  V c1, c2, c3, c4;
};

// half-way bounce-back (Ladd 1994): the wall is taken half-way along the link
struct Halfway {
  static constexpr bool interpolated = false;
  template <class V> static Coefficients<V> at(const V &q)
  {
    return {1.0 + 0.0 * q, 0.0 * q, 0.0 * q, 2.0 + 0.0 * q};
  }
};

// linear interpolation of Bouzidi, Firdaouss & Lallemand 2001: Mansouri et al. 2016, eq. 15, where
// line 2 needs the outgoing opposite population at x_f
struct Bouzidi {
  static constexpr bool interpolated = true;
  template <class V> static Coefficients<V> at(const V &q)
  {
    const V half = 0.5 + 0.0 * q, one = 1.0 + 0.0 * q, zero = 0.0 * q;
    const V near = q < half ? half : q;    // so that no lane divides by zero
    const V r = 0.5 / near;
    return {q < half ? 2.0 * q : r,             // q < 1/2: 2q; q >= 1/2: 1/(2q)
            q < half ? one - 2.0 * q : zero,    //          1 - 2q
            q < half ? zero : one - r,          //                       (2q - 1)/(2q)
            q < half ? 2.0 * one : 2.0 * r};    //          2;           1/q
  }
};

// central linear interpolation, Ginzburg, Verhaeghe & d'Humieres 2008: its error does not depend on
// viscosity with the two-relaxation-time rule
struct Cli {
  static constexpr bool interpolated = true;
  template <class V> static Coefficients<V> at(const V &q)
  {
    const V r = 1.0 / (1.0 + 2.0 * q), kappa = (1.0 - 2.0 * q) * r;
    return {1.0 + 0.0 * q, kappa, -kappa, 4.0 * r};
  }
};

// Zhao & Yong 2017, their l = q: a convex combination of three populations of x_f alone. The one
// they take from before the collision is in one node with r2, a step later: with it the steady
// state is the same, nothing lags behind, and the rule becomes that of Yu, Mei & Shyy 2003.
struct Zhao {
  static constexpr bool interpolated = true;
  template <class V> static Coefficients<V> at(const V &q)
  {
    const V r = 1.0 / (1.0 + q);
    return {q * r, (1.0 - q) * r, q * r, 2.0 * r};
  }
};

}    // namespace lbm
#endif
