// SPDX-License-Identifier: GPL-2.0-only
// Solids of any shape that stay where they are. Lattice units.
//
// A shape is known by one question alone: does this point lie inside? Which nodes it covers, and at
// which fraction q of each link to them its surface lies, is found once for a block; from then on
// an obstacle is one more body of a Cover, after the last of its spheres, whose nodes and fractions
// are looked up here. Where a sphere overlaps an obstacle its nodes stay the obstacle's.

#ifndef LBM_OBSTACLE_H
#define LBM_OBSTACLE_H

#include "lbm_neighbours.h"
#include "lbm_sphere.h"

#include <functional>
#include <vector>

namespace lbm {

struct Shape {
  // of a point of the whole lattice, see Sphere; asked for points of the box, and up to a cell
  // outside where it is not periodic
  std::function<bool(const Vec3 &)> inside;
  // rigid motion of the surface, along itself; torque is taken about the same point
  Vec3 velocity{}, spin{}, about{};
};

// What was found of a shape, summed over blocks
struct ShapeReview {
  double covered = 0.0, links = 0.0;    // nodes; links to them from others
  double surface = 0.0,
         thin = 0.0;             // nodes with links, and of these in parts of less than 2 cells
  double missed = 0.0;           // links between fluid nodes that meet a part with no node
  double leaving = 0.0;          // links whose point of the surface the motion takes off it
  double speed = 0.0;            // largest of the surface
  std::uint64_t checksum = 0;    // of nodes and links, however the lattice is cut
};

// of the last two steps, summed over blocks
struct ObstacleState {
  Load last{}, before{};
  double steps = 0.0;
};

// where a block lies
struct Place {
  Int3 global;
  std::array<bool, 3> periodic;
  Int3 lo, hi;    // nodes of the block that may be covered, see Cover::inside()
};

class Obstacles {
 public:
  // where shapes overlap a node belongs to the first
  template <class L>
  static Obstacles find(const Layout &at, const Place &place, const std::vector<Shape> &shapes);

  int count() const { return int(shapes_.size()); }
  // as the spheres of a Cover know it; its identifiers are below zero
  Sphere body(int k) const;

  // f(index of the first, number, obstacle) of nodes in a row
  template <class F> void for_each_stretch(F &&f) const
  {
    for (const Stretch &s : stretches_) f(s.first, s.n, s.obstacle);
  }
  const Region &nodes_with_links(int k) const { return near_[k]; }
  // of links along i from nodes that follow each other in memory
  void fractions(const int32_t *node, std::size_t n, int i, double *q) const;
  double fraction(int32_t node, int i) const;

  // of this block; the checksum is to be added modulo 2^64
  const std::vector<ShapeReview> &reviews() const { return reviews_; }
  double bytes() const;

 private:
  struct Stretch {
    Index first;
    int n, obstacle;
  };
  template <class L> class Search;

  std::vector<Shape> shapes_;
  std::vector<Stretch> stretches_;
  std::vector<Region> near_;
  // cut links by node and direction, ascending
  std::vector<std::uint64_t> link_;
  std::vector<double> q_;
  std::vector<ShapeReview> reviews_;

  static std::uint64_t name(int32_t node, int i)
  {
    return (std::uint64_t(uint32_t(node)) << 5) | unsigned(i);
  }
};

// over all blocks
void reduce(std::vector<ShapeReview> &reviews, Neighbours &neighbours);

}    // namespace lbm
#endif
