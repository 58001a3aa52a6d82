// SPDX-License-Identifier: GPL-2.0-only
// Scenes for the tests: a box, its spheres with all periodic images, and the solver that runs them.

#ifndef LBM_TEST_SCENE_H
#define LBM_TEST_SCENE_H

#include "lbm_solver.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace scene {

using lbm::Int3;
using lbm::Vec3;

inline Vec3 snapped(const Vec3 &x)
{
  return {lbm::snap(x[0]), lbm::snap(x[1]), lbm::snap(x[2])};
}

inline lbm::Sphere sphere(std::int64_t id, const Vec3 &centre, double radius,
                          const Vec3 &velocity = {}, const Vec3 &spin = {})
{
  return {id, snapped(centre), radius, velocity, spin};
}

// where spheres are after t steps of steady motion
inline std::vector<lbm::Sphere> drifted(std::vector<lbm::Sphere> list, int t)
{
  for (lbm::Sphere &s : list) {
    for (int d = 0; d < 3; d++) s.centre[d] += t * s.velocity[d];
    s.centre = snapped(s.centre);
  }
  return list;
}

inline std::array<bool, 3> periodic(const lbm::Settings &settings)
{
  std::array<bool, 3> p;
  for (int d = 0; d < 3; d++) p[d] = settings.faces[d][0].kind == lbm::FaceKind::PERIODIC;
  return p;
}

// spheres and images that reach the nodes lo .. lo + n - 1 or their ghosts; grain[k] tells which
// sphere of the list is number k
struct Images {
  std::vector<lbm::Sphere> spheres;
  std::vector<std::size_t> grain;
};

inline Images images(const std::vector<lbm::Sphere> &list, const lbm::Settings &settings,
                     const Int3 &lo, const Int3 &n, const Int3 &global)
{
  Images all;
  Int3 reach{};
  for (int d = 0; d < settings.dimension; d++)
    if (periodic(settings)[d]) reach[d] = 2;
  for (std::size_t s = 0; s < list.size(); s++) {
    Int3 home{};    // the period the grain has drifted to
    for (int d = 0; d < settings.dimension; d++)
      if (periodic(settings)[d]) home[d] = int(std::floor(list[s].centre[d] / global[d]));
    for (int z = -reach[2]; z <= reach[2]; z++)
      for (int y = -reach[1]; y <= reach[1]; y++)
        for (int x = -reach[0]; x <= reach[0]; x++) {
          const Int3 shift{x, y, z};
          lbm::Sphere image = list[s];
          bool here = true;
          for (int d = 0; d < settings.dimension; d++) {
            image.centre[d] += double(shift[d] - home[d]) * global[d];
            here = here && image.centre[d] + image.radius > lo[d] - 1 &&
                image.centre[d] - image.radius < lo[d] + n[d] + 1;
          }
          if (!here) continue;
          all.spheres.push_back(image);
          all.grain.push_back(s);
        }
  }
  return all;
}

// one box on one process
class Box {
 public:
  lbm::Settings settings;
  Int3 n;
  std::unique_ptr<lbm::Alone> neighbours;
  std::unique_ptr<lbm::Fluid> fluid;
  std::vector<lbm::Load> loads;    // by grain, images summed
  bool conserve = false;
  Images now;    // of the last follow()

  Box(const lbm::Settings &settings, const Int3 &n, const Vec3 &force = {}) :
      settings(settings), n(n), neighbours(std::make_unique<lbm::Alone>(periodic(settings))),
      fluid(lbm::Fluid::create(settings, {0, 0, 0}, n, n, *neighbours))
  {
    fluid->set_force(force);
    fluid->fill(0.0);
  }

  void follow(const std::vector<lbm::Sphere> &list)
  {
    grains = list;
    for (lbm::Sphere &grain : grains) {
      grain.drho = drho[grain.id];
      if (conserve) grain.refund = refund[grain.id];
    }
    now = images(grains, settings, {0, 0, 0}, n, n);
    fluid->follow(now.spheres);
    loads.assign(list.size(), {});
  }
  void advance()
  {
    std::vector<lbm::Load> parts;
    fluid->advance(parts);
    loads.assign(loads.size(), {});
    for (std::size_t k = 0; k < parts.size(); k++)
      for (int d = 0; d < 3; d++) {
        loads[now.grain[k]].force[d] += parts[k].force[d];
        loads[now.grain[k]].torque[d] += parts[k].torque[d];
      }
    for (std::size_t k = 0; k < parts.size(); k++) {
      loads[now.grain[k]].pressing += parts[k].pressing;
      loads[now.grain[k]].area += parts[k].area;
      loads[now.grain[k]].swallowed += parts[k].swallowed;
    }
    for (std::size_t s = 0; s < grains.size(); s++) {
      const std::int64_t id = grains[s].id;
      drho[id] = loads[s].drho();
      refund[id] = lbm::refund(loads[s].swallowed, swallowed[id], loads[s].area);
      swallowed[id] = loads[s].swallowed;
    }
  }
  void step(const std::vector<lbm::Sphere> &list)
  {
    follow(list);
    advance();
  }

  // what grains of another box remember of its fluid
  void remember(const Box &other)
  {
    drho = other.drho;
    refund = other.refund;
    swallowed = other.swallowed;
  }

  lbm::Moments at(int x, int y, int z) const { return fluid->moments(x, y, z); }
  template <class F> void for_each_node(F &&f) const
  {
    for (int z = 0; z < n[2]; z++)
      for (int y = 0; y < n[1]; y++)
        for (int x = 0; x < n[0]; x++) f(x, y, z);
  }
  template <class F> void for_each_fluid_node(F &&f) const
  {
    for_each_node([&](int x, int y, int z) {
      if (!fluid->solid(x, y, z)) f(x, y, z);
    });
  }

 private:
  std::vector<lbm::Sphere> grains;
  std::map<std::int64_t, double> drho, refund, swallowed;    // of each grain, of the last step
};

// a smooth flow that is nowhere trivial; repeats after n nodes
inline lbm::Moments some_flow(const Int3 &p, const Int3 &n, int dimension)
{
  double a[3];
  for (int d = 0; d < 3; d++) a[d] = 2.0 * M_PI * (p[d] + 0.3) / n[d];
  lbm::Moments m;
  m.drho = 0.01 * std::sin(a[0] + 0.4) * std::cos(a[1]) + 0.004 * std::sin(a[2]);
  m.u = {0.03 * std::sin(a[1]) + 0.01 * std::cos(a[2]), 0.02 * std::cos(a[0] + a[2]),
         dimension == 3 ? 0.025 * std::sin(a[0]) : 0.0};
  return m;
}

inline double norm(const Vec3 &v)
{
  return std::sqrt(lbm::dot(v, v));
}

}    // namespace scene
#endif
