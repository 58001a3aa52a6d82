// SPDX-License-Identifier: GPL-2.0-only
// What two spheres that nearly touch do to each other through the film between them, where the film
// is thinner than the lattice resolves. Any consistent units.
//
// Leading terms in the gap of Jeffrey & Onishi, J. Fluid Mech. 139, 261 (1984) (Kim & Karrila,
// Microhydrodynamics, table 11.2: 1/gap of X^A, ln(1/gap) of Y^A, Y^B, Y^C), from which their value
// at the cut-off is taken away, so that nothing jumps there and what the lattice resolves is not
// counted twice (Nguyen & Ladd, Phys. Rev. E 66, 046708 (2002)). With s1 = a1/(a1+a2) and s2 =
// a2/(a1+a2) they are polynomials, and a wall is the limit s1 = 0, s2 = 1.

#ifndef LBM_LUBRICATION_H
#define LBM_LUBRICATION_H

#include "lbm_equilibrium.h"

#include <algorithm>
#include <cmath>

namespace lbm {

// lengths; the forces of thinner films than "least" are those of that one
struct Film {
  double viscosity;        // dynamic
  double normal, shear;    // gaps from which on there is none: squeezed, sheared
  double least;
  double reach() const { return std::max(normal, shear); }
};

// of sphere 1, and of what it nearly touches: the force on that is the opposite
struct FilmLoad {
  Vec3 force{}, torque1{}, torque2{};
};

namespace detail {

  constexpr double PI = 3.14159265358979323846;

  // n points from sphere 1 to the other, w is the velocity of the other's centre relative to that of
  // sphere 1; turning2: a2^2 s1 (4 s2 + s1), torque12: a1^2 a2 s2, torque22: a2^3 s1, none of a wall
  struct Shape {
    double a1, s1, s2, turning2, torque12, torque22;
  };

  inline FilmLoad film(const Film &f, const Shape &shape, const Vec3 &n, double gap, const Vec3 &w,
                       const Vec3 &spin1, const Vec3 &spin2)
  {
    FilmLoad load;
    const auto &[a1, s1, s2, turning2, torque12, torque22] = shape;
    const double h = std::max(gap, f.least), approach = dot(n, w), mu = PI * f.viscosity;
    if (h < f.normal) {
      const double push = 6.0 * mu * a1 * a1 * s2 * s2 * (1.0 / h - 1.0 / f.normal) * approach;
      for (int d = 0; d < 3; d++) load.force[d] += push * n[d];
    }
    if (h < f.shear) {
      const double c = mu * std::log(f.shear / h);
      const double slide = 1.6 * c * a1 * s2 * (2.0 * s1 * s1 + s1 * s2 + 2.0 * s2 * s2);
      const double turn1 = 0.8 * c * a1 * a1 * s2 * (4.0 * s1 + s2), turn2 = 0.8 * c * turning2;
      const double own1 = 3.2 * c * a1 * a1 * a1 * s2, own2 = 3.2 * c * torque22;
      const double other = 0.8 * c * torque12;
      const Vec3 n_w = cross(n, w), n_1 = cross(n, spin1), n_2 = cross(n, spin2);
      const double along1 = dot(n, spin1), along2 = dot(n, spin2);
      for (int d = 0; d < 3; d++) {
        const double rolls1 = spin1[d] - along1 * n[d], rolls2 = spin2[d] - along2 * n[d];
        load.force[d] += slide * (w[d] - approach * n[d]) + turn1 * n_1[d] + turn2 * n_2[d];
        load.torque1[d] = turn1 * n_w[d] - own1 * rolls1 - other * rolls2;
        load.torque2[d] = turn2 * n_w[d] - own2 * rolls2 - other * rolls1;
      }
    }
    return load;
  }

}    // namespace detail

// n: from sphere 1 to sphere 2; w: velocity of the centre of 2 less that of 1
inline FilmLoad film_of_spheres(const Film &f, double a1, double a2, const Vec3 &n, double gap,
                                const Vec3 &w, const Vec3 &spin1, const Vec3 &spin2)
{
  const double s1 = a1 / (a1 + a2), s2 = a2 / (a1 + a2);
  return detail::film(
      f, {a1, s1, s2, a2 * a2 * s1 * (4.0 * s2 + s1), a1 * a1 * a2 * s2, a2 * a2 * a2 * s1}, n, gap,
      w, spin1, spin2);
}

// n: from the sphere to the wall; w: velocity of the wall less that of the centre
inline FilmLoad film_at_wall(const Film &f, double a, const Vec3 &n, double gap, const Vec3 &w,
                             const Vec3 &spin)
{
  return detail::film(f, {a, 0.0, 1.0, 0.0, 0.0, 0.0}, n, gap, w, spin, {});
}

// rate at which the thinnest film stops a sphere of this mass at a wall: the fastest there is
inline double film_rate(const Film &f, double a, double mass)
{
  return 6.0 * detail::PI * f.viscosity * a * a * std::max(0.0, 1.0 / f.least - 1.0 / f.normal) /
      mass;
}

}    // namespace lbm
#endif
