// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_cover.h"

#include <algorithm>

namespace lbm {

Cover::Cover(const Layout &layout, int dimension, const Sides &sides,
             const Obstacles *obstacles) :
    at_(layout), dimension_(dimension), sides_(sides), obstacles_(obstacles),
    map_(layout.size + READ_PAST, FLUID), open_(false)
{
  for (int d = 0; d < 3; d++) {
    lo_[d] = sides[d][0] == NEIGHBOUR ? -at_.ghost[d] : 0;
    hi_[d] = at_.n[d] - 1 + (sides[d][1] == NEIGHBOUR ? at_.ghost[d] : 0);
  }
  // ghosts behind an open face; where a wall meets it the wall wins
  auto behind = [&](const Int3 &p, Side side) {
    for (int d = 0; d < 3; d++)
      if ((p[d] < 0 && sides[d][0] == side) || (p[d] >= at_.n[d] && sides[d][1] == side))
        return true;
    return false;
  };
  for (Index i = 0; i < at_.size; i++) {
    const Int3 p = at_.node(i);
    if (!behind(p, OPEN) || behind(p, WALL)) continue;
    map_[i] = OUTSIDE;
    open_ = true;
  }
}

// runs of all rows of the sphere: the estimate by square root is corrected by the exact test that
// every other part of the solver would make
void Cover::find_rows(const Sphere &sphere, const Vec3 &c)
{
  const double r = sphere.radius, rsq = r * r;
  auto reach = [&](int d, int &a, int &b) {
    const double lo = std::max(std::floor(c[d] - r), double(-at_.ghost[d]));
    const double hi = std::min(std::ceil(c[d] + r), double(at_.n[d] - 1 + at_.ghost[d]));
    a = int(std::min(lo, double(at_.n[d] + 1)));
    b = int(std::max(hi, -2.0));
  };
  Rows rows{0, 0, 0, 0, runs_.size()};
  reach(1, rows.y0, rows.y1);
  reach(2, rows.z0, rows.z1);
  const bool out = c[0] + r < -2.0 || c[0] - r > at_.n[0] + 1;    // no row of the block is met
  if (out || rows.y0 > rows.y1 || rows.z0 > rows.z1) {
    rows.y0 = rows.z0 = 0;
    rows.y1 = rows.z1 = -1;
  }
  for (int z = rows.z0; z <= rows.z1; z++)
    for (int y = rows.y0; y <= rows.y1; y++) {
      const double dy = y - c[1], dz = z - c[2], rest = dy * dy + dz * dz;
      Run run{1, 0};
      if (rest < rsq) {
        const double half = std::sqrt(rsq - rest);
        auto inside = [&](int x) {
          return (x - c[0]) * (x - c[0]) + rest < rsq;
        };
        run.xa = int(std::ceil(c[0] - half));
        run.xb = int(std::floor(c[0] + half));
        if (inside(run.xa - 1)) run.xa--;
        while (run.xa <= run.xb && !inside(run.xa)) run.xa++;
        if (inside(run.xb + 1)) run.xb++;
        while (run.xa <= run.xb && !inside(run.xb)) run.xb--;
      }
      runs_.push_back(run);
    }
  rows_.push_back(rows);
}

// f(first node of the row, xa, xb), clipped to the nodes that may be covered
template <class F> void Cover::for_each_row(std::size_t s, F &&f) const
{
  const Rows &r = rows_[s];
  for (int z = std::max(r.z0, lo_[2]); z <= std::min(r.z1, hi_[2]); z++)
    for (int y = std::max(r.y0, lo_[1]); y <= std::min(r.y1, hi_[1]); y++) {
      const Run u = run(r, y, z);
      f(y, z, std::max(u.xa, lo_[0]), std::min(u.xb, hi_[0]));
    }
}

void Cover::clear()
{
  for (std::size_t s = 0; s < spheres_.size(); s++)
    for_each_row(s, [&](int y, int z, int xa, int xb) {
      if (xa <= xb) std::fill_n(&map_[at_.index(xa, y, z)], xb - xa + 1, FLUID);
    });
}

bool Cover::deeper(const Sphere &a, const Vec3 &ca, const Sphere &b, const Vec3 &cb, int x, int y,
                   int z) const
{
  auto depth = [&](const Sphere &s, const Vec3 &c) {
    const double d[3] = {x - c[0], y - c[1], z - c[2]};
    return s.radius - std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  };
  const double da = depth(a, ca), db = depth(b, cb);
  if (da != db) return da > db;
  return a.id != b.id ? a.id < b.id : a.centre < b.centre;    // images of one sphere
}

void Cover::fill(std::size_t s)
{
  for_each_row(s, [&](int y, int z, int xa, int xb) {
    int32_t *row = &map_[at_.index(0, y, z)];
    for (int x = xa; x <= xb; x++) {
      const int32_t other = row[x];
      if (other < 0 ||
          (!is_obstacle(other) &&
           deeper(spheres_[s], centre(s), spheres_[other], centre(other), x, y, z)))
        row[x] = int32_t(s);
    }
  });
}

// their numbers change with that of the spheres, and what spheres overlapped of them is clear
void Cover::fill_obstacles()
{
  obstacles_->for_each_stretch([&](Index first, int n, int k) {
    std::fill_n(&map_[first], n, int32_t(first_obstacle_) + k);
  });
}

void Cover::place(const std::vector<Sphere> &list)
{
  clear();
  spheres_ = list;
  rows_.clear();
  runs_.clear();
  centres_.clear();
  for (const Sphere &s : spheres_) {
    Vec3 c;
    for (int d = 0; d < 3; d++) c[d] = s.centre[d] - 0.5 - at_.lo[d];
    if (dimension_ == 2) c[2] = 0.0;
    centres_.push_back(c);
  }
  first_obstacle_ = spheres_.size() - (obstacles_ ? obstacles_->count() : 0);
  if (obstacles_) fill_obstacles();
  for (std::size_t s = 0; s < first_obstacle_; s++) {
    find_rows(spheres_[s], centre(s));
    fill(s);
  }
  rows_.resize(spheres_.size(), {0, -1, 0, -1, runs_.size()});
}

bool Cover::same_places(const std::vector<Sphere> &list) const
{
  return std::equal(list.begin(), list.end(), spheres_.begin(), spheres_.end(),
                    [](const Sphere &a, const Sphere &b) {
                      return a.id == b.id && a.centre == b.centre && a.radius == b.radius;
                    });
}

double Cover::bytes() const
{
  return double(map_.size() * sizeof(int32_t) + runs_.size() * sizeof(Run) +
                rows_.size() * sizeof(Rows) + spheres_.size() * (sizeof(Sphere) + sizeof(Vec3)));
}

}    // namespace lbm
