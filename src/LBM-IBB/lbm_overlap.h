// SPDX-License-Identifier: GPL-2.0-only

// How much of its volume a sphere keeps where others overlap it: those of a clump displace the
// volume of their union, shared out by depth as nodes are in lbm_cover.h.

#ifndef LBM_OVERLAP_H
#define LBM_OVERLAP_H

#include "lbm_sphere.h"

#include <vector>

namespace lbm {

// a sphere that overlaps the one looked at
struct Overlap {
  Vec3 away;    // from the centre of that one to its own
  double radius;
  bool precedes;    // gets what both lie equally deep in
};

// 0 to 1; in two dimensions of the area
double kept_share(double radius, const std::vector<Overlap> &others, int dimension);

}    // namespace lbm
#endif
