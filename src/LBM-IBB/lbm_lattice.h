// SPDX-License-Identifier: GPL-2.0-only
// Velocity sets. Everything else in the solver is written once over such a descriptor.
//
// Lattice units throughout: spacing 1, time step 1, c_s^2 = 1/3. Real is what populations are
// stored and collide in; everything else is computed in double precision. Numbering of Mansouri et
// al. 2016: eq. 23 (D3Q19) and section 3.1 (D2Q9), arranged so that the opposite of i = 1..P is i +
// P, with P the number of opposite pairs.

#ifndef LBM_LATTICE_H
#define LBM_LATTICE_H

namespace lbm {

struct D3Q19 {
  using Real = double;
  static constexpr int D = 3, Q = 19, P = 9;
  static constexpr int e[Q][3] = {{0, 0, 0},  {-1, 0, 0},  {0, -1, 0}, {0, 0, -1},  {-1, -1, 0},
                                  {-1, 1, 0}, {-1, 0, -1}, {-1, 0, 1}, {0, -1, -1}, {0, -1, 1},
                                  {1, 0, 0},  {0, 1, 0},   {0, 0, 1},  {1, 1, 0},   {1, -1, 0},
                                  {1, 0, 1},  {1, 0, -1},  {0, 1, 1},  {0, 1, -1}};
  // eq. 24
  static constexpr double w[Q] = {1. / 3,  1. / 18, 1. / 18, 1. / 18, 1. / 36, 1. / 36, 1. / 36,
                                  1. / 36, 1. / 36, 1. / 36, 1. / 18, 1. / 18, 1. / 18, 1. / 36,
                                  1. / 36, 1. / 36, 1. / 36, 1. / 36, 1. / 36};
};

struct D2Q9 {
  using Real = double;
  static constexpr int D = 2, Q = 9, P = 4;
  static constexpr int e[Q][3] = {{0, 0, 0},  {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0},
                                  {1, -1, 0}, {1, 0, 0},  {1, 1, 0},  {0, 1, 0}};
  static constexpr double w[Q] = {4. / 9,  1. / 36, 1. / 9,  1. / 36, 1. / 9,
                                  1. / 36, 1. / 9,  1. / 36, 1. / 9};
};

// the same with half the memory and traffic
template <class L> struct InSingle : L {
  using Real = float;
};

#define LBM_FOR_EACH_LATTICE(F) F(D3Q19) F(D2Q9) F(InSingle<D3Q19>) F(InSingle<D2Q9>)

template <class L> constexpr int opposite(int i)
{
  return i == 0 ? 0 : (i <= L::P ? i + L::P : i - L::P);
}

}    // namespace lbm
#endif
