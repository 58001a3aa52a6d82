// SPDX-License-Identifier: GPL-2.0-only
// A second solver to compare with: two lattices, full populations, one node and one direction at a
// time, no halo, no lists, every question asked again at every node. Slow, and written from the
// published formulas, not from the solver it checks. It shares with that only the structs that
// describe a scene.

#ifndef LBM_TEST_REFERENCE_H
#define LBM_TEST_REFERENCE_H

#include "lbm_solver.h"
#include "reference_lattice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace reference {

class Solver {
 public:
  lbm::Settings settings;
  Node n;
  Vec force{};
  std::vector<lbm::Load> loads;
  long links = 0, gaps = 0, refilled_grad = 0, refilled_equilibrium = 0, refilled_deep = 0;

  Solver(const lbm::Settings &settings, const Node &n) :
      settings(settings), n(n), dirs(directions(settings.dimension)),
      f(std::size_t(n[0]) * n[1] * n[2] * dirs.size())
  {
    owner.assign(nodes(), Owner{});
    for (std::size_t x = 0; x < nodes(); x++) set_equilibrium(x, 1.0, {});
  }

  std::size_t nodes() const { return std::size_t(n[0]) * n[1] * n[2]; }
  std::size_t index(const Node &p) const
  {
    return p[0] + std::size_t(n[0]) * (p[1] + std::size_t(n[1]) * p[2]);
  }
  Node node(std::size_t x) const
  {
    return {int(x % n[0]), int(x / n[0] % n[1]), int(x / n[0] / n[1])};
  }
  bool solid(std::size_t x) const { return owner[x].sphere >= 0; }

  Real density(std::size_t x) const
  {
    Real rho = 0.0;
    for (std::size_t i = 0; i < dirs.size(); i++) rho += at(f, x, i);
    return rho;
  }
  Vec velocity(std::size_t x) const
  {
    Vec u{0.5 * force[0], 0.5 * force[1], 0.5 * force[2]};
    for (std::size_t i = 0; i < dirs.size(); i++)
      for (int d = 0; d < 3; d++) u[d] += dirs[i].c[d] * at(f, x, i);
    for (Real &component : u) component /= density(x);
    return u;
  }
  // populations before collision carry the momentum rho u - F/2
  void set_equilibrium(std::size_t x, Real rho, const Vec &u)
  {
    for (std::size_t i = 0; i < dirs.size(); i++)
      at(f, x, i) = equilibrium(i, rho, u) - 3.0 * dirs[i].w * 0.5 * dot(dirs[i].c, force);
  }

  // spheres without their images: all of those are tried
  void follow(const std::vector<lbm::Sphere> &list)
  {
    const std::vector<Owner> before = owner;
    const std::vector<lbm::Sphere> spheres_before = spheres;
    spheres = list;
    for (lbm::Sphere &s : spheres) s.drho = excess[s.id];
    for (std::size_t x = 0; x < nodes(); x++) owner[x] = owner_of(node(x));
    refill(before, spheres_before);
  }

  void step()
  {
    loads.assign(spheres.size(), lbm::Load{});
    links = gaps = 0;
    post = f;
    for (std::size_t x = 0; x < nodes(); x++)
      if (!solid(x)) collide(x);
    std::vector<Real> next = f;
    for (std::size_t x = 0; x < nodes(); x++)
      for (std::size_t i = 0; i < dirs.size(); i++) at(next, x, i) = arriving(x, int(i));
    press_apart();
    for (std::size_t s = 0; s < spheres.size(); s++) excess[spheres[s].id] = loads[s].drho();
    f = next;
    for (std::size_t x = 0; x < nodes(); x++)
      if (!solid(x)) fill_if_pocket(x);
    for (int d = 0; d < settings.dimension; d++)
      for (int side = 0; side < 2; side++)
        if (settings.faces[d][side].open()) open_face(d, side);
  }

 private:
  enum Place { FLUID, SOLID, WALL, OPEN };
  struct Owner {
    int sphere = -1;
    Vec arm{};    // node - centre of the image that covers it
  };

  std::vector<Direction> dirs;
  std::vector<Real> f, post;
  std::vector<Owner> owner;
  std::vector<lbm::Sphere> spheres;
  std::map<std::int64_t, Real> excess;    // density excess around each grain

  Real &at(std::vector<Real> &a, std::size_t x, std::size_t i) const
  {
    return a[x * dirs.size() + i];
  }
  Real at(const std::vector<Real> &a, std::size_t x, std::size_t i) const
  {
    return a[x * dirs.size() + i];
  }

  Real equilibrium(std::size_t i, Real rho, const Vec &u) const
  {
    const Real cu = dot(dirs[i].c, u);
    return rho * dirs[i].w * (1.0 + 3.0 * cu + 4.5 * cu * cu - 1.5 * dot(u, u));
  }

  // what is at p; a node beyond a periodic face is replaced by its image inside
  Place place(Node &p) const
  {
    bool wall = false, open = false;
    for (int d = 0; d < 3; d++) {
      if (p[d] >= 0 && p[d] < n[d]) continue;
      const lbm::Face &face = settings.faces[d][p[d] < 0 ? 0 : 1];
      if (face.kind == lbm::FaceKind::WALL) wall = true;
      if (face.open()) open = true;
      if (face.kind == lbm::FaceKind::PERIODIC) p[d] = (p[d] + n[d]) % n[d];
    }
    if (wall) return WALL;
    if (open) return OPEN;
    return solid(index(p)) ? SOLID : FLUID;
  }

  // strictly inside; deepest; then smallest id; of images the one with the smallest centre
  Owner owner_of(const Node &p) const
  {
    Owner best;
    Real depth = 0.0;
    for (std::size_t s = 0; s < spheres.size(); s++) {
      Node reach{};
      for (int d = 0; d < settings.dimension; d++)
        if (settings.faces[d][0].kind == lbm::FaceKind::PERIODIC) reach[d] = 2;
      for (int z = -reach[2]; z <= reach[2]; z++)
        for (int y = -reach[1]; y <= reach[1]; y++)
          for (int x = -reach[0]; x <= reach[0]; x++) {
            const Node shift{x, y, z};
            Vec arm{};
            for (int d = 0; d < settings.dimension; d++)
              arm[d] = p[d] + 0.5 - (spheres[s].centre[d] + shift[d] * n[d]);
            const Real r = spheres[s].radius;
            if (!(dot(arm, arm) < r * r)) continue;
            const Real deep = r - std::sqrt(dot(arm, arm));
            const bool same = best.sphere == int(s);    // smaller centre: larger arm
            if (best.sphere < 0 || deep > depth ||
                (deep == depth &&
                 (same ? arm > best.arm : spheres[s].id < spheres[best.sphere].id))) {
              best = {int(s), arm};
              depth = deep;
            }
          }
    }
    return best;
  }

  void collide(std::size_t x)
  {
    const Real tau = settings.tau,
                 tau_odd = settings.bgk ? tau : 0.5 + settings.magic / (tau - 0.5);
    const Real rho = density(x);
    const Vec u = velocity(x);
    auto forcing =
        [&](std::size_t i) {    // Guo, Zheng & Shi 2002, without the factor 1 - 1/(2 tau)
          const Real cu = dot(dirs[i].c, u), cF = dot(dirs[i].c, force);
          return dirs[i].w * (3.0 * (cF - dot(u, force)) + 9.0 * cu * cF);
        };
    for (std::size_t i = 0; i < dirs.size(); i++) {
      const std::size_t o = dirs[i].opposite;
      const Real fi = at(f, x, i), fo = at(f, x, o);
      const Real ei = equilibrium(i, rho, u), eo = equilibrium(o, rho, u);
      const Real Fi = forcing(i), Fo = forcing(o);
      at(post, x, i) = fi - ((fi + fo) / 2 - (ei + eo) / 2) / tau -
          ((fi - fo) / 2 - (ei - eo) / 2) / tau_odd + (1 - 1 / (2 * tau)) * (Fi + Fo) / 2 +
          (1 - 1 / (2 * tau_odd)) * (Fi - Fo) / 2;
    }
  }

  // f_i(x, t + 1); what comes through open faces is found later; solids get what fluid sends them
  Real arriving(std::size_t x, int i)
  {
    Node from = node(x);
    for (int d = 0; d < 3; d++) from[d] -= dirs[i].c[d];
    switch (place(from)) {
      case FLUID:
        return at(post, index(from), i);
      case WALL:
        return solid(x) ? 0.0 : from_wall(x, i);
      case SOLID:
        return solid(x) ? 0.0 : from_sphere(x, i);
      case OPEN:
        break;
    }
    return 0.0;
  }

  // half-way bounce-back; a direction that crosses an edge crosses both walls
  Real from_wall(std::size_t x, int i) const
  {
    const Node p = node(x);
    Real value = at(post, x, dirs[i].opposite);
    for (int d = 0; d < 3; d++) {
      const int from = p[d] - dirs[i].c[d];
      if (from >= 0 && from < n[d]) continue;
      const lbm::Face &face = settings.faces[d][from < 0 ? 0 : 1];
      if (face.kind == lbm::FaceKind::WALL) value += 6.0 * dirs[i].w * dot(dirs[i].c, whole(face.u));
    }
    return value;
  }

  // of spheres: reference_spheres.h

  // one end of a link: i from wall to fluid
  struct Cut {
    int sphere;
    Real q;
    Vec arm, u;    // of x_w: from the centre, and its velocity
  };
  Cut cut(int i, const Owner &inside) const;
  void move_to_wall(Cut &cut, int i) const;
  // f_i = known + unknown * (f_o that arrives from x_f')
  struct Rule {
    Real known, unknown;
  };
  Cut approach(const Cut &one, const Cut &other) const;
  Real push(std::size_t x, int i, const Cut &cut) const;
  Rule rule(std::size_t x, int i, const Cut &cut, Real m) const;
  Real from_sphere(std::size_t x, int i);
  void add_load(const Cut &cut, int i, Real out, Real back);
  void press_apart();
  void press_from_face(const Owner &mine, const Direction &outwards);
  void add_beyond_equilibrium(std::size_t x, const std::vector<Owner> &before);
  void refill(const std::vector<Owner> &before, const std::vector<lbm::Sphere> &spheres_before);
  void fill_if_pocket(std::size_t x);
  Real arriving_excess(std::size_t x, const Vec &u, const std::vector<Owner> &before,
                       Real deep);

  // Zou & He 1997: non-equilibrium bounce-back, then the tangential momentum put right by equal and
  // opposite changes. Density and momentum follow from the populations that are known.
  void open_face(int d, int side)
  {
    const lbm::Face &face = settings.faces[d][side];
    const int inward = side == 0 ? 1 : -1;
    for (std::size_t x = 0; x < nodes(); x++) {
      const Node p = node(x);
      if (p[d] != (side == 0 ? 0 : n[d] - 1) || solid(x)) continue;
      Real in_plane = 0.0, outgoing = 0.0;
      for (std::size_t i = 0; i < dirs.size(); i++) {
        const int along = dirs[i].c[d] * inward;
        if (along == 0) in_plane += at(f, x, i);
        if (along < 0) outgoing += at(f, x, i);
      }
      // rho = in_plane + outgoing + incoming; rho u_n - F_n / 2 = incoming - outgoing
      Real rho;
      Vec j;
      if (face.kind == lbm::FaceKind::PRESSURE) {
        rho = 1.0 + face.drho;
        for (int t = 0; t < 3; t++) j[t] = -0.5 * force[t];
        j[d] = inward * (rho - in_plane - 2 * outgoing);
      } else {
        rho = (in_plane + 2 * outgoing - 0.5 * force[d] * inward) / (1 - face.u[d] * inward);
        for (int t = 0; t < 3; t++) j[t] = rho * face.u[t] - 0.5 * force[t];
      }
      std::vector<Real> node_f(&at(f, x, 0), &at(f, x, 0) + dirs.size());
      Vec momentum{}, share{};
      for (std::size_t i = 0; i < dirs.size(); i++)
        if (dirs[i].c[d] == inward)
          node_f[i] = node_f[dirs[i].opposite] + 6.0 * dirs[i].w * dot(dirs[i].c, j);
      for (std::size_t i = 0; i < dirs.size(); i++)
        for (int t = 0; t < 3; t++) {
          momentum[t] += dirs[i].c[t] * node_f[i];
          if (dirs[i].c[d] == inward) share[t] += dirs[i].c[t] * dirs[i].c[t];
        }
      for (std::size_t i = 0; i < dirs.size(); i++) {
        if (dirs[i].c[d] != inward) continue;
        for (int t = 0; t < 3; t++)
          if (t != d && share[t] > 0) node_f[i] += dirs[i].c[t] * (j[t] - momentum[t]) / share[t];
        Node from = p;
        for (int t = 0; t < 3; t++) from[t] -= dirs[i].c[t];
        if (place(from) == OPEN) at(f, x, i) = node_f[i];    // not where a wall gave it
      }
    }
  }
};

}    // namespace reference

#include "reference_spheres.h"

#endif
