// SPDX-License-Identifier: GPL-2.0-only
// What covers the nodes of a block now, and covered them in the last step: the spheres of a list,
// and obstacles behind them. Nothing of a cover exists before something comes. Lattice units.

#ifndef LBM_COVERS_H
#define LBM_COVERS_H

#include "lbm_bodies.h"
#include "lbm_cover.h"
#include "lbm_face.h"

#include <memory>

namespace lbm {

// owned nodes covered before and not now
struct Uncovered {
  Int3 p;
  Index n;
  int32_t sphere;    // in before.spheres()
};

// what lies behind the faces of a block
Cover::Sides sides(const AtEnd &at_end, const Faces &faces);

class Covers {
 public:
  // refunds: of obstacles, see Bodies
  Covers(const Layout &layout, int dimension, const Cover::Sides &sides, bool refunds) :
      at_(layout), dimension_(dimension), sides_(sides), refunds_(refunds)
  {
  }

  void set_obstacles(Obstacles obstacles);            // before the first sphere
  Bodies *bodies() const { return bodies_.get(); }    // null without obstacles
  const std::vector<ObstacleState> &obstacles() const;

  // These spheres now, what was before; place() has no before. first: of all steps, in which
  // another order of a list that was taken over is no motion.
  void follow(const std::vector<Sphere> &spheres, bool first);
  void place(const std::vector<Sphere> &spheres);

  bool moved() const { return moved_; }                              // since before
  bool has_moved() const { return moved_ && before_ != nullptr; }    // and was not just put there
  Motion motion() const { return motion_; }
  bool any() const { return now_ && !now_->spheres().empty(); }
  const Cover &now() { return provide(now_); }
  const Cover &before() { return provide(before_); }

  const int32_t *owner() const { return now_ ? now_->owner() : nullptr; }    // null: all is fluid
  const std::vector<Sphere> &spheres() const;    // obstacles behind them
  std::vector<Sphere> grains() const;            // without them
  std::vector<Index> covered() const;            // nodes now; a look at all of them

  // nodes that became solid and fluid, in their order: sums over them must not hang on the order of
  // the spheres, which a restart may change
  struct Change {
    std::vector<Index> covered;
    std::vector<Uncovered> uncovered;
  };
  Change change() const;
  double bytes() const;

 private:
  Layout at_;
  int dimension_;
  Cover::Sides sides_;
  bool refunds_;
  std::unique_ptr<Bodies> bodies_;
  std::unique_ptr<Cover> now_, before_;
  bool moved_ = false;
  Motion motion_ = Motion::REST;

  Cover &provide(std::unique_ptr<Cover> &cover) const;
  void follow_bodies(const std::vector<Sphere> &list, bool first);
};

}    // namespace lbm
#endif
