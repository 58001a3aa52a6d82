// SPDX-License-Identifier: GPL-2.0-only
// What spheres do to the fluid of the plain solver in reference.h, which includes this file: links,
// loads, refill.

#ifndef LBM_TEST_REFERENCE_SPHERES_H
#define LBM_TEST_REFERENCE_SPHERES_H

#include "reference.h"

namespace reference {

inline Solver::Cut Solver::cut(int i, const Owner &inside) const
{
  // |arm_f - s c_i| = r with arm_f = arm_s + c_i; s = q is the smaller root
  const lbm::Sphere &sphere = spheres[inside.sphere];
  Vec arm;
  for (int d = 0; d < 3; d++) arm[d] = inside.arm[d] + dirs[i].c[d];
  const Real a = dot(dirs[i].c, Vec{Real(dirs[i].c[0]), Real(dirs[i].c[1]), Real(dirs[i].c[2])});
  const Real b = dot(dirs[i].c, arm), c = dot(arm, arm) - sphere.radius * sphere.radius;
  // (b - sqrt(b b - a c)) / a, without the cancellation
  const Real q = c / (b + std::sqrt(b * b - a * c));
  return {inside.sphere, std::min<Real>(std::max<Real>(q, 1e-6), 1.0), arm, {}};
}

inline void Solver::move_to_wall(Cut &cut, int i) const
{
  for (int d = 0; d < 3; d++) cut.arm[d] -= cut.q * dirs[i].c[d];
  const lbm::Sphere &sphere = spheres[cut.sphere];
  cut.u = cross(whole(sphere.spin), cut.arm);
  for (int d = 0; d < 3; d++) cut.u[d] += sphere.velocity[d];
}

// what the wall's motion adds to a link, up to the rule's factor
inline Real Solver::push(std::size_t x, int i, const Cut &cut) const
{
  // the solver keeps the density excess at single precision
  const Real rho = 1.0 + Real(float(density(x) - 1.0));
  return 3.0 * dirs[i].w * rho * dot(dirs[i].c, cut.u);
}

// a wall that moves as the one moves towards the other, along the mean of their normals
inline Solver::Cut Solver::approach(const Cut &one, const Cut &other) const
{
  Cut both = one;
  Vec n;
  for (int d = 0; d < 3; d++)
    n[d] = one.arm[d] / std::sqrt(dot(one.arm, one.arm)) -
        other.arm[d] / std::sqrt(dot(other.arm, other.arm));
  const Real along = dot(n, one.u) - dot(n, other.u);
  for (int d = 0; d < 3; d++) both.u[d] = dot(n, n) > 0.0 ? n[d] * along / dot(n, n) : 0.0;
  return both;
}

inline Solver::Rule Solver::rule(std::size_t x, int i, const Cut &cut, Real m) const
{
  const int o = dirs[i].opposite;
  const Real back = at(post, x, o), ahead = at(post, x, i), q = cut.q;
  switch (settings.link) {
    case lbm::LinkRule::HALFWAY:
      return {back + 2 * m, 0.0};
    case lbm::LinkRule::BOUZIDI:
      if (q < 0.5) return {2 * q * back + 2 * m, 1 - 2 * q};
      return {back / (2 * q) + (2 * q - 1) / (2 * q) * ahead + m / q, 0.0};
    case lbm::LinkRule::CLI: {
      const Real kappa = (1 - 2 * q) / (1 + 2 * q);
      return {back - kappa * ahead + 4 * m / (1 + 2 * q), kappa};
    }
    case lbm::LinkRule::ZHAO:
      return {(q * back + q * ahead + 2 * m) / (1 + q), (1 - q) / (1 + q)};
  }
  return {};
}

inline Real Solver::from_sphere(std::size_t x, int i)
{
  const int o = dirs[i].opposite;
  Node inside = node(x), behind = node(x);
  for (int d = 0; d < 3; d++) {
    inside[d] -= dirs[i].c[d];
    behind[d] += dirs[i].c[d];
  }
  place(inside);
  Cut mine = cut(i, owner[index(inside)]);
  Real value = 0.0;
  const Place there = place(behind);
  if (there == SOLID) {
    Cut other = cut(o, owner[index(behind)]);
    const Real room = mine.q + other.q;
    if (room < 0.2) {
      mine.q *= 0.2 / room;
      other.q *= 0.2 / room;
    }
    move_to_wall(mine, i);
    move_to_wall(other, o);
    // walls that move as one, or shear; what they squeeze out is added as by half-way walls
    const Real squeezed = push(x, i, approach(mine, other)) / 2;
    const Rule a = rule(x, i, mine, push(x, i, mine) - squeezed);
    const Rule b = rule(x, o, other, push(x, o, other) - squeezed);
    // a.known = f_i - a.unknown f_o, b.known = f_o - b.unknown f_i, by Cramer's rule
    value = (a.known + a.unknown * b.known) / (1.0 - a.unknown * b.unknown) + 2 * squeezed;
    gaps++;
  } else {
    if (there == OPEN) mine.q = 0.5;
    move_to_wall(mine, i);
    const Rule r = rule(x, i, mine, push(x, i, mine));
    value = r.known;
    if (there == FLUID) value += r.unknown * at(post, index(behind), o);
    if (there == WALL) value += r.unknown * from_wall(x, o);
  }
  links++;
  add_load(mine, i, at(post, x, o), value);
  return value;
}

// Wen et al. 2014, minus the same at the equilibrium with rest density and wall velocity
inline void Solver::add_load(const Cut &cut, int i, Real out, Real back)
{
  const int o = dirs[i].opposite;
  const Real eq_out = equilibrium(o, 1.0, cut.u), eq_back = equilibrium(i, 1.0, cut.u);
  Vec F;
  for (int d = 0; d < 3; d++) {
    F[d] = -dirs[i].c[d] * (out + back) - cut.u[d] * (out - back);
    F[d] -= -dirs[i].c[d] * (eq_out + eq_back) - cut.u[d] * (eq_out - eq_back);
  }
  loads[cut.sphere].pressing +=
      out + back - eq_out - eq_back;    // by 2 w drho where fluid moves with the wall
  loads[cut.sphere].area += 2.0 * dirs[i].w;
  const Vec T = cross(cut.arm, F);
  for (int d = 0; d < 3; d++) {
    loads[cut.sphere].force[d] += F[d];
    loads[cut.sphere].torque[d] += T[d];
  }
}

// Two neighbouring nodes under two spheres, or images: fluid at rest between them, of the density
// around them, would press them apart in the middle. Both look at it, and each does half.
inline void Solver::press_apart()
{
  for (std::size_t x = 0; x < nodes(); x++) {
    if (!solid(x)) continue;
    const Owner &mine = owner[x];
    for (std::size_t i = 0; i < dirs.size(); i++) {
      Node there = node(x);
      for (int d = 0; d < 3; d++) there[d] += dirs[i].c[d];
      const Place what = place(there);
      if (what == WALL || what == OPEN) press_from_face(mine, dirs[i]);
      if (what != SOLID) continue;
      const Owner &other = owner[index(there)];
      bool same = mine.sphere == other.sphere;    // and not another image of it
      Vec middle;                                 // of the link, from my centre
      for (int d = 0; d < 3; d++) {
        same = same && mine.arm[d] + dirs[i].c[d] == other.arm[d];
        middle[d] = mine.arm[d] + 0.5 * dirs[i].c[d];
      }
      if (same) continue;
      const Real drho = 0.5 * (spheres[mine.sphere].drho + spheres[other.sphere].drho);
      Vec F;
      for (int d = 0; d < 3; d++) F[d] = -dirs[i].w * drho * dirs[i].c[d];
      Vec middle_other;
      for (int d = 0; d < 3; d++) middle_other[d] = other.arm[d] - 0.5 * dirs[i].c[d];
      const Vec T = cross(middle, F), T_other = cross(middle_other, F);
      for (int d = 0; d < 3; d++) {
        loads[mine.sphere].force[d] += F[d];
        loads[mine.sphere].torque[d] += T[d];
        loads[other.sphere].force[d] -= F[d];
        loads[other.sphere].torque[d] -= T_other[d];
      }
    }
  }
}

// behind a wall or an open face nothing answers: the whole of it, by the density around the sphere
inline void Solver::press_from_face(const Owner &mine, const Direction &outwards)
{
  Vec F, middle;
  for (int d = 0; d < 3; d++) {
    F[d] = -2.0 * outwards.w * spheres[mine.sphere].drho * outwards.c[d];
    middle[d] = mine.arm[d] + 0.5 * outwards.c[d];
  }
  const Vec T = cross(middle, F);
  for (int d = 0; d < 3; d++) {
    loads[mine.sphere].force[d] += F[d];
    loads[mine.sphere].torque[d] += T[d];
  }
}

// A node with one fluid neighbour at most: mean density and velocity of the spheres on its other sides;
// with one, the mass that it held and has exchanged with that
inline void Solver::fill_if_pocket(std::size_t x)
{
  std::vector<std::size_t> fluid;    // populations that come from fluid neighbours
  Real drho = 0.0, around = 0.0;
  Vec u{};
  for (std::size_t i = 0; i < dirs.size(); i++) {
    if (dirs[i].c == Node{}) continue;
    Node from = node(x);
    for (int d = 0; d < 3; d++) from[d] -= dirs[i].c[d];
    const Place there = place(from);
    if (there == OPEN) return;
    if (there == FLUID) fluid.push_back(i);
    if (there != SOLID) continue;
    const Owner &o = owner[index(from)];
    const lbm::Sphere &sphere = spheres[o.sphere];
    Vec arm;
    for (int d = 0; d < 3; d++) arm[d] = o.arm[d] + dirs[i].c[d];
    const Vec turning = cross(whole(sphere.spin), arm);
    for (int d = 0; d < 3; d++) u[d] += sphere.velocity[d] + turning[d];
    drho += sphere.drho;
    around++;
  }
  if (fluid.size() > 1 || around == 0.0) return;
  for (Real &component : u) component /= around;
  Real rho = 1.0 + drho / around;
  if (!fluid.empty()) {
    rho = at(f, x, fluid[0]) - at(post, x, dirs[fluid[0]].opposite);
    for (std::size_t i = 0; i < dirs.size(); i++) rho += at(post, x, i);
  }
  set_equilibrium(x, rho, u);
}

inline void Solver::refill(const std::vector<Owner> &before,
                           const std::vector<lbm::Sphere> &spheres_before)
{
  const int D = settings.dimension;
  Real mean = 0.0;
  long count = 0;
  for (std::size_t x = 0; x < nodes(); x++)
    if (before[x].sphere < 0) {
      mean += density(x) - 1.0;
      count++;
    }
  if (count) mean /= Real(count);

  for (std::size_t x = 0; x < nodes(); x++) {
    if (before[x].sphere < 0 || solid(x)) continue;
    const lbm::Sphere &sphere = spheres_before[before[x].sphere];
    Vec u = cross(whole(sphere.spin), before[x].arm);
    for (int d = 0; d < 3; d++) u[d] += sphere.velocity[d];
    if (settings.refill == lbm::RefillRule::EQUILIBRIUM) {
      set_equilibrium(x, 1.0 + mean, u);
      refilled_equilibrium++;
      continue;
    }
    // of neighbours that were fluid already: none of those is refilled
    Real rho = 0.0, grad[3][3] = {};
    int known = 0;
    for (int b = 0; b < D; b++) {
      Vec v[2] = {u, u};
      int found = 0;
      for (int side = 0; side < 2; side++) {
        Node p = node(x);
        p[b] += side == 0 ? -1 : 1;
        if (place(p) != FLUID || before[index(p)].sphere >= 0) continue;
        v[side] = velocity(index(p));
        rho += density(index(p)) - 1.0;
        found++;
      }
      for (int a = 0; a < D; a++) grad[a][b] = (v[1][a] - v[0][a]) / (found == 2 ? 2 : 1);
      known += found;
    }
    if (known) {
      rho = 1.0 + rho / known;
      refilled_grad++;
    } else {
      rho = 1.0 + arriving_excess(x, u, before, sphere.drho);
    }
    Real shear[3][3], trace = 0.0;
    for (int a = 0; a < 3; a++)
      for (int b = 0; b < 3; b++) shear[a][b] = -settings.tau / 3.0 * (grad[a][b] + grad[b][a]);
    for (int a = 0; a < 3; a++) trace += shear[a][a];
    set_equilibrium(x, rho, u);
    if (settings.refill == lbm::RefillRule::NORMAL) add_beyond_equilibrium(x, before);
    if (settings.refill != lbm::RefillRule::GRAD) continue;
    for (std::size_t i = 0; i < dirs.size(); i++) {
      Real sum = -trace / 3.0;
      for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) sum += dirs[i].c[a] * dirs[i].c[b] * shear[a][b];
      at(f, x, i) += 4.5 * dirs[i].w * rho * sum;
    }
  }
}

// of the neighbour along an axis that lies farthest out along the normal, if there is one
inline void Solver::add_beyond_equilibrium(std::size_t x, const std::vector<Owner> &before)
{
  std::size_t from = x;
  Real farthest = -1e30;
  for (int d = 0; d < settings.dimension; d++)
    for (int step : {-1, 1}) {
      Node p = node(x);
      p[d] += step;
      if (place(p) != FLUID || before[index(p)].sphere >= 0) continue;
      if (step * before[x].arm[d] <= farthest) continue;
      farthest = step * before[x].arm[d];
      from = index(p);
    }
  if (from == x) return;
  const Real rho = density(from);
  const Vec u = velocity(from);
  for (std::size_t i = 0; i < dirs.size(); i++)
    at(f, x, i) +=
        at(f, from, i) - (equilibrium(i, rho, u) - 1.5 * dirs[i].w * dot(dirs[i].c, force));
}

// density excess with which fluid neighbours would have sent what arrives here, to first order
inline Real Solver::arriving_excess(std::size_t x, const Vec &u, const std::vector<Owner> &before,
                                    Real deep)
{
  Real sum = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < dirs.size(); i++) {
    Node from = node(x);
    for (int d = 0; d < 3; d++) from[d] -= dirs[i].c[d];
    const Place there = place(from);
    if (there == WALL || there == OPEN || before[index(from)].sphere >= 0) continue;
    sum += at(f, x, i) - (equilibrium(i, 1.0, u) - 1.5 * dirs[i].w * dot(dirs[i].c, force));
    weight += dirs[i].w;
  }
  if (weight > 0.0)
    refilled_equilibrium++;
  else
    refilled_deep++;
  return weight > 0.0 ? sum / weight : deep;
}

}    // namespace reference
#endif
