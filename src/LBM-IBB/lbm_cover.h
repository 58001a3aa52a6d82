// SPDX-License-Identifier: GPL-2.0-only
// Which nodes the spheres cover. A node is solid if it lies strictly inside a sphere; where spheres
// overlap it belongs to the one it lies deepest in, ties to the smaller id, of two
// images to the smaller centre: no choice depends on the order of the list or on the rank.
// Obstacles follow the spheres in the list, and keep their nodes whatever overlaps them.
//
// Cost: proportional to covered nodes, not to the box.

#ifndef LBM_COVER_H
#define LBM_COVER_H

#include "lbm_obstacle.h"

#include <vector>

namespace lbm {

constexpr int32_t FLUID = -1;      // also ghosts behind a wall, whose bounce-back the wall provides
constexpr int32_t OUTSIDE = -2;    // ghosts behind an open face: nothing is known there

// nodes xa..xb of one row that a sphere covers; empty if xa > xb. Not clipped to the block.
struct Run {
  int xa, xb;
};

// the rows (y, z) of the block and its ghosts that a sphere reaches
struct Rows {
  int y0, y1, z0, z1;
  std::size_t first;    // of its runs, y fastest
  bool contains(int y, int z) const { return y >= y0 && y <= y1 && z >= z0 && z <= z1; }
};

class Cover {
 public:
  // what lies behind each face of the block: sides[d][0] below, [1] above
  enum Side { NEIGHBOUR, WALL, OPEN };
  using Sides = std::array<std::array<Side, 2>, 3>;

  Cover(const Layout &layout, int dimension, const Sides &sides,
        const Obstacles *obstacles = nullptr);

  // cover these spheres, obstacles behind them, instead of the former ones
  void place(const std::vector<Sphere> &list);
  // the same nodes stay covered by the same spheres, which have other velocities now
  void set_velocities(const std::vector<Sphere> &list) { spheres_ = list; }
  bool same_places(const std::vector<Sphere> &list) const;

  const std::vector<Sphere> &spheres() const { return spheres_; }
  const Rows &rows(std::size_t s) const { return rows_[s]; }
  Run run(const Rows &r, int y, int z) const
  {
    return runs_[r.first + (y - r.y0) + std::size_t(z - r.z0) * (r.y1 - r.y0 + 1)];
  }
  // owned, or a ghost of a node of a neighbouring block: may be covered, and is otherwise fluid
  bool inside(int x, int y, int z) const
  {
    return x >= lo_[0] && x <= hi_[0] && y >= lo_[1] && y <= hi_[1] && z >= lo_[2] && z <= hi_[2];
  }
  // index of the covering sphere in spheres(), FLUID or OUTSIDE, by node
  const int32_t *owner() const { return map_.data(); }
  // centre of sphere s in the coordinates of the block, where node (0, 0, 0) is the origin
  const Vec3 &centre(std::size_t s) const { return centres_[s]; }
  bool is_obstacle(std::size_t s) const { return s >= first_obstacle_; }
  std::size_t first_obstacle() const { return first_obstacle_; }    // the number of spheres
  const Obstacles &obstacles() const { return *obstacles_; }
  int obstacle(std::size_t s) const { return int(s - first_obstacle_); }
  bool has_open_faces() const { return open_; }
  Side behind(int d, int side) const { return sides_[d][side]; }
  double bytes() const;

 private:
  Layout at_;
  int dimension_;
  Sides sides_;
  const Obstacles *obstacles_;
  std::size_t first_obstacle_ = 0;
  Int3 lo_{}, hi_{};    // nodes that may be covered: owned ones and ghosts with a neighbour behind
  std::vector<Sphere> spheres_;
  std::vector<Vec3> centres_;
  std::vector<Rows> rows_;
  std::vector<Run> runs_;
  // rows are read in pieces of 64, and up to 144 nodes ahead
  static constexpr int READ_PAST = 192;
  std::vector<int32_t> map_;
  bool open_;    // is any ghost behind an open face?

  void find_rows(const Sphere &sphere, const Vec3 &c);
  void clear();
  void fill(std::size_t s);
  void fill_obstacles();
  bool deeper(const Sphere &a, const Vec3 &ca, const Sphere &b, const Vec3 &cb, int x, int y,
              int z) const;
  template <class F> void for_each_row(std::size_t s, F &&f) const;
};

}    // namespace lbm
#endif
