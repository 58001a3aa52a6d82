// SPDX-License-Identifier: GPL-2.0-only
// Obstacles among the spheres of a step: bodies after the last of them, with what they got in the
// steps before, which all ranks know. Lattice units. Nothing of this exists without obstacles.

#ifndef LBM_BODIES_H
#define LBM_BODIES_H

#include "lbm_obstacle.h"

namespace lbm {

class Bodies {
 public:
  explicit Bodies(Obstacles obstacles) :
      obstacles_(std::move(obstacles)), states_(obstacles_.count())
  {
  }
  const Obstacles &obstacles() const { return obstacles_; }
  const std::vector<ObstacleState> &states() const { return states_; }
  void resume(const std::vector<ObstacleState> &states) { states_ = states; }
  double bytes() const { return obstacles_.bytes(); }

  // the list with the obstacles at its end; refunds: they give back what their links swallowed
  std::vector<Sphere> after(std::vector<Sphere> spheres, bool refunds) const;
  // takes what the obstacles got here off the end of the list, and sums it over all blocks
  void take(std::vector<Load> &loads, Neighbours &neighbours);

 private:
  Obstacles obstacles_;
  std::vector<ObstacleState> states_;    // the same on all ranks
};

}    // namespace lbm
#endif
