// SPDX-License-Identifier: GPL-2.0-only
// The fluid by planes of nodes across an axis, and by layers of whole planes. One pass over the
// block, made only when somebody asks. Lattice units.

#ifndef LBM_PROFILE_H
#define LBM_PROFILE_H

#include "lbm_block.h"
#include "lbm_equilibrium.h"
#include "lbm_neighbours.h"

#include <vector>

namespace lbm {

// sums over the fluid nodes of each plane, by node of the whole lattice along the axis
struct Planes {
  explicit Planes(int n) : fluid(n, 0.0), drho(n, 0.0), velocity(n, 0.0) {}
  std::vector<double> fluid;       // number of fluid nodes
  std::vector<double> drho;        // density excess
  std::vector<double> velocity;    // along the axis
};

// of this block; n is the number of nodes of the whole lattice along the axis; owner may be null
template <class L>
Planes planes(const Layout &at, const Slots<L> &f, const int32_t *owner, const Vec3 &force,
              int axis, int n);

// over all blocks
void reduce(Planes &sums, Neighbours &neighbours);

struct Layer {
  double porosity;    // fluid nodes over all nodes
  double pressure;    // gauge: mean over planes of the mean over the fluid of a plane
  double flux;        // superficial velocity: sum of u over all nodes
  double gradient;    // what drives the fluid, -dp/dx + force density, mean over length
  double length;      // over which it is taken: width, but half a node less at an end of the box
};

// Layers of width planes, which must divide their number. The pressure at the border of two layers
// is the mean of the planes at either side of it, that at an end of the box the plane next to it:
// the sum of (gradient - force) * length is the difference of pressure between the outermost planes
// of the box, and a uniform gradient is exact whatever the porosity. In a periodic direction the
// first layer follows the last.
std::vector<Layer> layers(const Planes &sums, double nodes_per_plane, int width, bool periodic,
                          double force);

// part of a sphere (disc in two dimensions) of radius r below a plane at height z above its centre
double volume_below(double z, double r, int dimension);

}    // namespace lbm
#endif
