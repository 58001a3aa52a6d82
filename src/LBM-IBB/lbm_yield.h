// SPDX-License-Identifier: GPL-2.0-only
// Spheres that yield: light ones, whose velocity answers to the fluid within a step.
//
// A surface that moves by du faster than what was handed in would have got back, along a link,
//     f_o - a e.du,    a = 3 w c4    (lbm_bounce_back.h)
// so that with g = (e, arm x e) the sphere's load, force and torque, would have been
//     F - zeta (du, dspin),    zeta = sum of a g g^T    (links of gaps left out)
// Whoever moves the sphere uses this load, implicitly, and says afterwards by how much the velocity
// was larger in the mean: correct() then takes zeta du from the fluid, to round-off, along the same
// links. Rest density is good enough for zeta, and terms of second order in velocity are left out
// of it; F has both. Lattice units.

#ifndef LBM_YIELD_H
#define LBM_YIELD_H

#include "lbm_block.h"
#include "lbm_link.h"

namespace lbm {

struct Response {
  static constexpr int SIZE = 21;
  std::array<double, SIZE> zeta{};      // lower triangle by rows: force before torque
  std::array<double, 6> swallowed{};    // what Load::swallowed gains with (du, dspin)
};

// velocity and spin beyond what was handed in, mean over a step
struct Gain {
  Vec3 velocity{}, spin{};
};

// mass that the fluid lost to faster surfaces, as Load has it
struct Taken {
  double displaced = 0.0, swallowed = 0.0;
};

// the links of spheres that yield, of a list that may have others as well
template <class L, class Rule>
void add_responses(const Layout &at, const Cover &cover, const Links &links,
                   std::vector<Response> &responses);
// in the slots that the links wrote; gains by sphere
template <class L, class Rule>
Taken correct(const Layout &at, const Slots<L> &f, const Cover &cover, const Links &links,
              const std::vector<Gain> &gains);

}    // namespace lbm
#endif
