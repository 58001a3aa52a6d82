// SPDX-License-Identifier: GPL-2.0-only
// A second solver to compare with: two lattices, full populations, one node and one direction at a
// time, no halo, no lists, every question asked again at every node. Slow, and written from the
// published formulas, not from the solver it checks. It shares with that only the structs that
// describe a scene.

#ifndef LBM_TEST_REFERENCE_H
#define LBM_TEST_REFERENCE_H

#include "lbm_solver.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace reference {

using Node = std::array<int, 3>;
using Vec = std::array<double, 3>;

struct Direction {
  Node c;
  double w;
  int opposite;
};

// D3Q19 or D2Q9, in the order in which three nested loops meet them
inline std::vector<Direction> directions(int dimension)
{
  std::vector<Direction> list;
  const int depth = dimension == 3 ? 1 : 0;
  for (int z = -depth; z <= depth; z++)
    for (int y = -1; y <= 1; y++)
      for (int x = -1; x <= 1; x++) {
        const int square = x * x + y * y + z * z;
        const double w3[] = {1. / 3, 1. / 18, 1. / 36}, w2[] = {4. / 9, 1. / 9, 1. / 36};
        if (square < 3) list.push_back({{x, y, z}, dimension == 3 ? w3[square] : w2[square], -1});
      }
  for (std::size_t i = 0; i < list.size(); i++) list[i].opposite = int(list.size() - 1 - i);
  return list;
}

inline double dot(const Node &a, const Vec &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double dot(const Vec &a, const Vec &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec cross(const Vec &a, const Vec &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class Solver {
 public:
  lbm::Settings settings;
  Node n;
  Vec force{};
  std::vector<lbm::Load> loads;
  long links = 0, gaps = 0, refilled_grad = 0, refilled_equilibrium = 0, refilled_rest = 0;

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

  double density(std::size_t x) const
  {
    double rho = 0.0;
    for (std::size_t i = 0; i < dirs.size(); i++) rho += at(f, x, i);
    return rho;
  }
  Vec velocity(std::size_t x) const
  {
    Vec u{0.5 * force[0], 0.5 * force[1], 0.5 * force[2]};
    for (std::size_t i = 0; i < dirs.size(); i++)
      for (int d = 0; d < 3; d++) u[d] += dirs[i].c[d] * at(f, x, i);
    for (double &component : u) component /= density(x);
    return u;
  }
  // populations before collision carry the momentum rho u - F/2
  void set_equilibrium(std::size_t x, double rho, const Vec &u)
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
    std::vector<double> next = f;
    for (std::size_t x = 0; x < nodes(); x++)
      for (std::size_t i = 0; i < dirs.size(); i++) at(next, x, i) = arriving(x, int(i));
    press_apart();
    for (std::size_t s = 0; s < spheres.size(); s++) excess[spheres[s].id] = loads[s].drho();
    f = next;
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
  std::vector<double> f, post;
  std::vector<Owner> owner;
  std::vector<lbm::Sphere> spheres;
  std::map<std::int64_t, double> excess;    // density excess around each grain

  double &at(std::vector<double> &a, std::size_t x, std::size_t i) const
  {
    return a[x * dirs.size() + i];
  }
  double at(const std::vector<double> &a, std::size_t x, std::size_t i) const
  {
    return a[x * dirs.size() + i];
  }

  double equilibrium(std::size_t i, double rho, const Vec &u) const
  {
    const double cu = dot(dirs[i].c, u);
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

  // strictly inside; deepest; then smallest id
  Owner owner_of(const Node &p) const
  {
    Owner best;
    double depth = 0.0;
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
            const double r = spheres[s].radius;
            if (!(dot(arm, arm) < r * r)) continue;
            const double deep = r - std::sqrt(dot(arm, arm));
            if (best.sphere < 0 || deep > depth ||
                (deep == depth && spheres[s].id < spheres[best.sphere].id)) {
              best = {int(s), arm};
              depth = deep;
            }
          }
    }
    return best;
  }

  void collide(std::size_t x)
  {
    const double tau = settings.tau,
                 tau_odd = settings.bgk ? tau : 0.5 + settings.magic / (tau - 0.5);
    const double rho = density(x);
    const Vec u = velocity(x);
    auto forcing =
        [&](std::size_t i) {    // Guo, Zheng & Shi 2002, without the factor 1 - 1/(2 tau)
          const double cu = dot(dirs[i].c, u), cF = dot(dirs[i].c, force);
          return dirs[i].w * (3.0 * (cF - dot(u, force)) + 9.0 * cu * cF);
        };
    for (std::size_t i = 0; i < dirs.size(); i++) {
      const std::size_t o = dirs[i].opposite;
      const double fi = at(f, x, i), fo = at(f, x, o);
      const double ei = equilibrium(i, rho, u), eo = equilibrium(o, rho, u);
      const double Fi = forcing(i), Fo = forcing(o);
      at(post, x, i) = fi - ((fi + fo) / 2 - (ei + eo) / 2) / tau -
          ((fi - fo) / 2 - (ei - eo) / 2) / tau_odd + (1 - 1 / (2 * tau)) * (Fi + Fo) / 2 +
          (1 - 1 / (2 * tau_odd)) * (Fi - Fo) / 2;
    }
  }

  // f_i(x, t + 1); what comes through open faces is found later; solids get what fluid sends them
  double arriving(std::size_t x, int i)
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
  double from_wall(std::size_t x, int i) const
  {
    const Node p = node(x);
    double value = at(post, x, dirs[i].opposite);
    for (int d = 0; d < 3; d++) {
      const int from = p[d] - dirs[i].c[d];
      if (from >= 0 && from < n[d]) continue;
      const lbm::Face &face = settings.faces[d][from < 0 ? 0 : 1];
      if (face.kind == lbm::FaceKind::WALL) value += 6.0 * dirs[i].w * dot(dirs[i].c, face.u);
    }
    return value;
  }

  // one end of a link: i from wall to fluid
  struct Cut {
    int sphere;
    double q;
    Vec arm, u;    // of x_w: from the centre, and its velocity
  };
  Cut cut(int i, const Owner &inside) const
  {
    // |arm_f - s c_i| = r with arm_f = arm_s + c_i; s = q is the smaller root
    const lbm::Sphere &sphere = spheres[inside.sphere];
    Vec arm;
    for (int d = 0; d < 3; d++) arm[d] = inside.arm[d] + dirs[i].c[d];
    const double a =
        dot(dirs[i].c, Vec{double(dirs[i].c[0]), double(dirs[i].c[1]), double(dirs[i].c[2])});
    const double b = dot(dirs[i].c, arm), c = dot(arm, arm) - sphere.radius * sphere.radius;
    // (b - sqrt(b b - a c)) / a, without the cancellation
    const double q = c / (b + std::sqrt(b * b - a * c));
    return {inside.sphere, std::min(std::max(q, 1e-6), 1.0), arm, {}};
  }
  void move_to_wall(Cut &cut, int i) const
  {
    for (int d = 0; d < 3; d++) cut.arm[d] -= cut.q * dirs[i].c[d];
    const lbm::Sphere &sphere = spheres[cut.sphere];
    cut.u = cross(sphere.spin, cut.arm);
    for (int d = 0; d < 3; d++) cut.u[d] += sphere.velocity[d];
  }

  // f_i = known + unknown * (f_o that arrives from x_f')
  struct Rule {
    double known, unknown;
  };
  Rule rule(std::size_t x, int i, const Cut &cut) const
  {
    const int o = dirs[i].opposite;
    // the solver keeps the density excess at single precision
    const double rho = 1.0 + double(float(density(x) - 1.0));
    const double m = 3.0 * dirs[i].w * rho * dot(dirs[i].c, cut.u);
    const double back = at(post, x, o), ahead = at(post, x, i), q = cut.q;
    switch (settings.link) {
      case lbm::LinkRule::HALFWAY:
        return {back + 2 * m, 0.0};
      case lbm::LinkRule::BOUZIDI:
        if (q < 0.5) return {2 * q * back + 2 * m, 1 - 2 * q};
        return {back / (2 * q) + (2 * q - 1) / (2 * q) * ahead + m / q, 0.0};
      case lbm::LinkRule::CLI: {
        const double kappa = (1 - 2 * q) / (1 + 2 * q);
        return {back - kappa * ahead + 4 * m / (1 + 2 * q), kappa};
      }
    }
    return {};
  }

  double from_sphere(std::size_t x, int i)
  {
    const int o = dirs[i].opposite;
    Node inside = node(x), behind = node(x);
    for (int d = 0; d < 3; d++) {
      inside[d] -= dirs[i].c[d];
      behind[d] += dirs[i].c[d];
    }
    place(inside);
    Cut mine = cut(i, owner[index(inside)]);
    double value = 0.0;
    const Place there = place(behind);
    if (there == SOLID) {
      Cut other = cut(o, owner[index(behind)]);
      const double room = mine.q + other.q;
      if (room < 0.2) {
        mine.q *= 0.2 / room;
        other.q *= 0.2 / room;
      }
      move_to_wall(mine, i);
      move_to_wall(other, o);
      const Rule a = rule(x, i, mine), b = rule(x, o, other);
      // a.known = f_i - a.unknown f_o, b.known = f_o - b.unknown f_i, by Cramer's rule
      value = (a.known + a.unknown * b.known) / (1.0 - a.unknown * b.unknown);
      gaps++;
    } else {
      if (there == OPEN) mine.q = 0.5;
      move_to_wall(mine, i);
      const Rule r = rule(x, i, mine);
      value = r.known;
      if (there == FLUID) value += r.unknown * at(post, index(behind), o);
      if (there == WALL) value += r.unknown * from_wall(x, o);
    }
    links++;
    add_load(mine, i, at(post, x, o), value);
    return value;
  }

  // Wen et al. 2014, minus the same at the equilibrium with rest density and wall velocity
  void add_load(const Cut &cut, int i, double out, double back)
  {
    const int o = dirs[i].opposite;
    const double eq_out = equilibrium(o, 1.0, cut.u), eq_back = equilibrium(i, 1.0, cut.u);
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
  void press_apart()
  {
    for (std::size_t x = 0; x < nodes(); x++) {
      if (!solid(x)) continue;
      const Owner &mine = owner[x];
      for (std::size_t i = 0; i < dirs.size(); i++) {
        Node there = node(x);
        for (int d = 0; d < 3; d++) there[d] += dirs[i].c[d];
        if (place(there) != SOLID) continue;
        const Owner &other = owner[index(there)];
        bool same = mine.sphere == other.sphere;    // and not another image of it
        Vec middle;                                 // of the link, from my centre
        for (int d = 0; d < 3; d++) {
          same = same && mine.arm[d] + dirs[i].c[d] == other.arm[d];
          middle[d] = mine.arm[d] + 0.5 * dirs[i].c[d];
        }
        if (same) continue;
        const double drho = 0.5 * (spheres[mine.sphere].drho + spheres[other.sphere].drho);
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

  // Zou & He 1997: non-equilibrium bounce-back, then the tangential momentum put right by equal and
  // opposite changes. Density and momentum follow from the populations that are known.
  void open_face(int d, int side)
  {
    const lbm::Face &face = settings.faces[d][side];
    const int inward = side == 0 ? 1 : -1;
    for (std::size_t x = 0; x < nodes(); x++) {
      const Node p = node(x);
      if (p[d] != (side == 0 ? 0 : n[d] - 1) || solid(x)) continue;
      double in_plane = 0.0, outgoing = 0.0;
      for (std::size_t i = 0; i < dirs.size(); i++) {
        const int along = dirs[i].c[d] * inward;
        if (along == 0) in_plane += at(f, x, i);
        if (along < 0) outgoing += at(f, x, i);
      }
      // rho = in_plane + outgoing + incoming; rho u_n - F_n / 2 = incoming - outgoing
      double rho;
      Vec j;
      if (face.kind == lbm::FaceKind::PRESSURE) {
        rho = 1.0 + face.drho;
        for (int t = 0; t < 3; t++) j[t] = -0.5 * force[t];
        j[d] = inward * (rho - in_plane - 2 * outgoing);
      } else {
        rho = (in_plane + 2 * outgoing - 0.5 * force[d] * inward) / (1 - face.u[d] * inward);
        for (int t = 0; t < 3; t++) j[t] = rho * face.u[t] - 0.5 * force[t];
      }
      std::vector<double> node_f(&at(f, x, 0), &at(f, x, 0) + dirs.size());
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

  void refill(const std::vector<Owner> &before, const std::vector<lbm::Sphere> &spheres_before)
  {
    const int D = settings.dimension;
    double mean = 0.0;
    long count = 0;
    for (std::size_t x = 0; x < nodes(); x++)
      if (before[x].sphere < 0) {
        mean += density(x) - 1.0;
        count++;
      }
    if (count) mean /= double(count);

    for (std::size_t x = 0; x < nodes(); x++) {
      if (before[x].sphere < 0 || solid(x)) continue;
      const lbm::Sphere &sphere = spheres_before[before[x].sphere];
      Vec u = cross(sphere.spin, before[x].arm);
      for (int d = 0; d < 3; d++) u[d] += sphere.velocity[d];
      if (settings.refill == lbm::RefillRule::EQUILIBRIUM) {
        set_equilibrium(x, 1.0 + mean, u);
        refilled_equilibrium++;
        continue;
      }
      // of neighbours that were fluid already: none of those is refilled
      double rho = 0.0, grad[3][3] = {};
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
        rho = 1.0 + arriving_excess(x, u, before);
      }
      double shear[3][3], trace = 0.0;
      for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) shear[a][b] = -settings.tau / 3.0 * (grad[a][b] + grad[b][a]);
      for (int a = 0; a < 3; a++) trace += shear[a][a];
      set_equilibrium(x, rho, u);
      for (std::size_t i = 0; i < dirs.size(); i++) {
        double sum = -trace / 3.0;
        for (int a = 0; a < 3; a++)
          for (int b = 0; b < 3; b++) sum += dirs[i].c[a] * dirs[i].c[b] * shear[a][b];
        at(f, x, i) += 4.5 * dirs[i].w * rho * sum;
      }
    }
  }

  // density excess with which fluid neighbours would have sent what arrives here, to first order
  double arriving_excess(std::size_t x, const Vec &u, const std::vector<Owner> &before)
  {
    double sum = 0.0, weight = 0.0;
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
      refilled_rest++;
    return weight > 0.0 ? sum / weight : 0.0;
  }
};

}    // namespace reference
#endif
