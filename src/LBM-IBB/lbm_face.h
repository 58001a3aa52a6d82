// SPDX-License-Identifier: GPL-2.0-only
// Faces of the box: half-way walls on the face itself, pressure and velocity planes on the first
// nodes, half a spacing inside. Written once over a face descriptor. Lattice units.
//
// Order in a step: sweep, halo, walls, links, open faces; each needs what the former wrote.

#ifndef LBM_FACE_H
#define LBM_FACE_H

#include "lbm_cover.h"

namespace lbm {

enum class FaceKind { PERIODIC, WALL, PRESSURE, VELOCITY };

struct Face {
  FaceKind kind = FaceKind::PERIODIC;
  Vec3 u{};             // of a wall (tangential), or of the fluid at a velocity face
  double drho = 0.0;    // density excess at a pressure face, 3 p
  // of a velocity face: a parabola between walls that meet it, of which u is the largest; across are
  // the nodes between these walls, 0 where there are none
  bool parabolic = false;
  Int3 across{};
  bool open() const { return kind == FaceKind::PRESSURE || kind == FaceKind::VELOCITY; }
};

// [d][0] is the lower face along d, [d][1] the upper one
using Faces = std::array<std::array<Face, 2>, 3>;

// [d][side]: does the block reach this face of the box, and is it not periodic?
using AtEnd = std::array<std::array<bool, 2>, 3>;
AtEnd ends(const Layout &at, const Int3 &global, const Faces &faces);
bool any_open(const Faces &faces);

// Half-way bounce-back with wall velocity (Ladd 1994): f_o(x_f) = f*_i(x_f) - 6 w_i e_i.u_w for all
// directions i through a wall; a direction through the edge of two walls feels the velocity of
// both, whatever their order. f are the slots of step t + 1.
template <class L>
void bounce_at_walls(const Layout &at, const Slots<L> &f, const Faces &faces, const AtEnd &at_end);

// Zou & He 1997 in three dimensions: bounce-back of the non-equilibrium part, with the corrections
// of Mansouri et al. 2016, appendix A (eq. A.7), closed by the density or the velocity at the face.
// Covered nodes are left alone. force is the force density on the fluid. Returns the mass that came
// in, less what went out.
template <class L>
double open_face(const Layout &at, const Slots<L> &f, int d, int side, const Face &face,
                 const Faces &faces, const AtEnd &at_end, const int32_t *owner, const Vec3 &force);

}    // namespace lbm
#endif
