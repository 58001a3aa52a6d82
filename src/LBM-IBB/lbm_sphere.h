// SPDX-License-Identifier: GPL-2.0-only
// What the solver knows of a grain, and what it gives back. Lattice units.

#ifndef LBM_SPHERE_H
#define LBM_SPHERE_H

#include "lbm_equilibrium.h"

#include <cmath>

namespace lbm {

// A sphere (a disc in two dimensions) or one periodic image of it. Node (i, j, k) of the whole
// lattice sits at (i + 1/2, j + 1/2, k + 1/2): cell centres, origin at the corner of the box.
struct Sphere {
  std::int64_t id = 0;    // the same for all images of a grain
  Vec3 centre{};          // snapped by snap(), so that all images cover exactly the same nodes
  double radius = 0.0;
  Vec3 velocity{};
  Vec3 spin{};    // angular velocity
  // mean density excess around it: of its Load in the former step, summed over ranks and images
  double drho = 0.0;
  // mass to give back, shared by its links as their weights: see refund()
  double refund = 0.0;
  // its velocity will answer to the fluid before the next step, see lbm_yield.h
  bool yields = false;

  Vec3 velocity_at(const Vec3 &arm) const
  {
    const Vec3 s = cross(spin, arm);
    return {velocity[0] + s[0], velocity[1] + s[1], velocity[2] + s[2]};
  }
};

// what spheres do at most in a step: the link pass is made for each, so that none pays for another
enum class Motion { REST, SHIFT, TURN };

// Round a coordinate to 2^-32 of a cell. Adding whole periods to it is then exact: an image of a
// grain, on whatever rank, meets the lattice bit for bit as the grain itself does.
inline double snap(double x)
{
  return std::ldexp(std::nearbyint(std::ldexp(x, 32)), -32);
}

// momentum per step given to a sphere by the fluid: force, and torque about its centre
struct Load {
  Vec3 force{}, torque{};
  double pressing = 0.0, area = 0.0;    // sums over links whose ratio is the mean density excess
  // mass that came to the links and was not given back, but for what fluid at rest with the moving
  // surface would leave there; that adds up to what the sphere displaces
  double swallowed = 0.0;
  // mass that such fluid got from the links, negative behind a sphere: what will be covered in front,
  // less what will be uncovered behind
  double displaced = 0.0;

  Load &operator+=(const Load &more)
  {
    for (int d = 0; d < 3; d++) {
      force[d] += more.force[d];
      torque[d] += more.torque[d];
    }
    pressing += more.pressing;
    area += more.area;
    swallowed += more.swallowed;
    displaced += more.displaced;
    return *this;
  }
  double drho() const { return area > 0.0 ? pressing / area : 0.0; }
};

// Interpolated links do not return all the mass they get, or more: what a sphere swallowed in the
// last two steps, half of each, is spread evenly over its links in the next. Evenly, so that no
// force comes of it; two, because links ring from step to step. What is lost is thus at most what
// one step loses.
inline double refund(double swallowed, double swallowed_before, double area)
{
  return area > 0.0 ? (swallowed + swallowed_before) / area : 0.0;
}

}    // namespace lbm
#endif
