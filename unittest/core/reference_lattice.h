// SPDX-License-Identifier: GPL-2.0-only
// Lattices and vectors of the plain solver in reference.h.

#ifndef LBM_TEST_REFERENCE_LATTICE_H
#define LBM_TEST_REFERENCE_LATTICE_H

#include <array>
#include <cstddef>
#include <vector>

namespace reference {

// Populations are whole, not deviations from rest: with the digits to spare, both solvers round a
// density excess to single precision alike.
using Real = long double;
using Node = std::array<int, 3>;
using Vec = std::array<Real, 3>;

struct Direction {
  Node c;
  Real w;
  int opposite;
};

// D3Q19 or D2Q9, in the order in which three nested loops meet them
inline std::vector<Direction> directions(int dimension)
{
  std::vector<Direction> list;
  const int depth = dimension == 3 ? 1 : 0;
  for (int z = -depth; z <= depth; z++)
    for (int y = -1; y <= 1; y++)
      for (int x = -1; x <= 1; x++) {
        const int square = x * x + y * y + z * z;
        const Real w3[] = {1.L / 3, 1.L / 18, 1.L / 36}, w2[] = {4.L / 9, 1.L / 9, 1.L / 36};
        if (square < 3) list.push_back({{x, y, z}, dimension == 3 ? w3[square] : w2[square], -1});
      }
  for (std::size_t i = 0; i < list.size(); i++) list[i].opposite = int(list.size() - 1 - i);
  return list;
}

inline Real dot(const Node &a, const Vec &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Real dot(const Vec &a, const Vec &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec whole(const std::array<double, 3> &a)
{
  return {a[0], a[1], a[2]};
}

inline Vec cross(const Vec &a, const Vec &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}    // namespace reference
#endif
