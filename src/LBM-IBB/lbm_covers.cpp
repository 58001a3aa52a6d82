// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_covers.h"

#include "lbm_state.h"

#include <algorithm>

namespace lbm {
namespace {

  Motion most(const std::vector<Sphere> &spheres)
  {
    Motion most = Motion::REST;
    for (const Sphere &s : spheres) {
      if (s.spin != Vec3{} || s.yields) return Motion::TURN;
      if (s.velocity != Vec3{}) most = Motion::SHIFT;
    }
    return most;
  }

  // f(s, node, n): the owned nodes that sphere s covers in a, and none in b, which may be null
  template <class F>
  void for_each_in_first_alone(const Layout &at, const Cover &a, const Cover *b, F &&f)
  {
    for (std::size_t s = 0; s < a.spheres().size(); s++) {
      const Rows &rows = a.rows(s);
      // most likely the same sphere, and in any case one whose nodes need no look
      const Rows *same = b && s < b->spheres().size() ? &b->rows(s) : nullptr;
      for (int z = std::max(rows.z0, 0); z <= std::min(rows.z1, at.n[2] - 1); z++)
        for (int y = std::max(rows.y0, 0); y <= std::min(rows.y1, at.n[1] - 1); y++) {
          const Run run = a.run(rows, y, z);
          const Index row = at.index(0, y, z);
          const auto look = [&](int xa, int xb) {
            for (int x = std::max(xa, 0); x <= std::min(xb, at.n[0] - 1); x++)
              if (a.owner()[row + x] == int32_t(s) && (!b || b->owner()[row + x] < 0))
                f(s, Int3{x, y, z}, row + x);
          };
          Run both{1, 0};
          if (same && same->contains(y, z)) both = b->run(*same, y, z);
          if (run.xa >= both.xa && run.xb <= both.xb) continue;    // most rows
          if (both.xa > both.xb) {
            look(run.xa, run.xb);
          } else {
            look(run.xa, std::min(run.xb, both.xa - 1));
            look(std::max(run.xa, both.xb + 1), run.xb);
          }
        }
    }
  }

}    // namespace

Cover::Sides sides(const AtEnd &at_end, const Faces &faces)
{
  Cover::Sides s{};
  for (int d = 0; d < 3; d++)
    for (int side = 0; side < 2; side++)
      s[d][side] = !at_end[d][side] ? Cover::NEIGHBOUR
          : faces[d][side].open()   ? Cover::OPEN
                                    : Cover::WALL;
  return s;
}

Cover &Covers::provide(std::unique_ptr<Cover> &cover) const
{
  if (!cover)
    cover =
        std::make_unique<Cover>(at_, dimension_, sides_, bodies_ ? &bodies_->obstacles() : nullptr);
  return *cover;
}

void Covers::set_obstacles(Obstacles obstacles)
{
  bodies_ = std::make_unique<Bodies>(std::move(obstacles));
  now_ = nullptr;
  place({});
}

const std::vector<ObstacleState> &Covers::obstacles() const
{
  static const std::vector<ObstacleState> none;
  return bodies_ ? bodies_->states() : none;
}

void Covers::place(const std::vector<Sphere> &spheres)
{
  provide(now_).place(bodies_ ? bodies_->after(spheres, refunds_) : spheres);
}

void Covers::follow(const std::vector<Sphere> &spheres, bool first)
{
  if (bodies_)
    follow_bodies(bodies_->after(spheres, refunds_), first);
  else if (now_ || !spheres.empty())
    follow_bodies(spheres, first);
}

void Covers::follow_bodies(const std::vector<Sphere> &list, bool first)
{
  Cover &last = provide(now_);
  if (first && same_but_for_order(last.spheres(), list)) last.place(list);
  moved_ = !last.same_places(list);
  if (moved_) {
    // a scene at rest, but for obstacles, needs no former cover
    if (before_ || last.spheres().size() > obstacles().size()) {
      provide(before_);
      std::swap(before_, now_);
    }
    now_->place(list);
  } else {
    last.set_velocities(list);
  }
  motion_ = most(list);
}

const std::vector<Sphere> &Covers::spheres() const
{
  static const std::vector<Sphere> none;
  return now_ ? now_->spheres() : none;
}

std::vector<Sphere> Covers::grains() const
{
  auto list = spheres();
  if (now_) list.resize(list.size() - obstacles().size());
  return list;
}

std::vector<Index> Covers::covered() const
{
  std::vector<Index> list;
  if (!now_) return list;
  for (int z = 0; z < at_.n[2]; z++)
    for (int y = 0; y < at_.n[1]; y++)
      for (int x = 0; x < at_.n[0]; x++)
        if (owner()[at_.index(x, y, z)] >= 0) list.push_back(at_.index(x, y, z));
  return list;
}

Covers::Change Covers::change() const
{
  Change change;
  if (!moved_) return change;
  for_each_in_first_alone(at_, *now_, before_.get(), [&](std::size_t, const Int3 &, Index n) {
    change.covered.push_back(n);
  });
  std::sort(change.covered.begin(), change.covered.end());
  if (!before_) return change;
  for_each_in_first_alone(at_, *before_, now_.get(), [&](std::size_t s, const Int3 &p, Index n) {
    change.uncovered.push_back({p, n, int32_t(s)});
  });
  auto &list = change.uncovered;
  std::sort(list.begin(), list.end(), [](const Uncovered &a, const Uncovered &b) {
    return a.n < b.n;
  });
  return change;
}

double Covers::bytes() const
{
  return (now_ ? now_->bytes() : 0.0) + (before_ ? before_->bytes() : 0.0) +
      (bodies_ ? bodies_->bytes() : 0.0);
}

}    // namespace lbm
