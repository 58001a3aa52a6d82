// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_face.h"

namespace lbm {
namespace {

  // f(n, x, y, z) for the owned nodes next to a face
  template <class F> void for_each_node(const Layout &at, int d, int side, F &&f)
  {
    Int3 lo{0, 0, 0}, hi{at.n[0] - 1, at.n[1] - 1, at.n[2] - 1};
    lo[d] = hi[d] = side == 0 ? 0 : at.n[d] - 1;
    for (int z = lo[2]; z <= hi[2]; z++)
      for (int y = lo[1]; y <= hi[1]; y++)
        for (int x = lo[0]; x <= hi[0]; x++) f(at.index(x, y, z), Int3{x, y, z});
  }

}    // namespace

AtEnd ends(const Layout &at, const Int3 &global, const Faces &faces)
{
  AtEnd end{};
  for (int d = 0; d < 3; d++) {
    end[d][0] = at.lo[d] == 0 && faces[d][0].kind != FaceKind::PERIODIC;
    end[d][1] = at.lo[d] + at.n[d] == global[d] && faces[d][1].kind != FaceKind::PERIODIC;
  }
  return end;
}

bool any_open(const Faces &faces)
{
  for (const auto &pair : faces)
    for (const Face &face : pair)
      if (face.open()) return true;
  return false;
}

template <class L>
void bounce_at_walls(const Layout &at, const Slots<L> &f, const Faces &faces, const AtEnd &at_end)
{
  // g(i, d, side) for all directions i through walls
  auto for_each_direction = [&](auto &&g) {
    for (int d = 0; d < L::D; d++)
      for (int side = 0; side < 2; side++)
        if (at_end[d][side] && faces[d][side].kind == FaceKind::WALL)
          for (int i = 1; i < L::Q; i++)
            if (L::e[i][d] == (side == 0 ? -1 : 1)) g(i, d, side);
  };
  for_each_direction([&](int i, int d, int side) {
    const auto *out = f[i] + at.offset(L::e[i]);
    auto *back = f[opposite<L>(i)];
    for_each_node(at, d, side, [&](Index n, const Int3 &) {
      back[n] = out[n];
    });
  });
  for_each_direction([&](int i, int d, int side) {
    const double wall = 6.0 * L::w[i] * dot(L::e[i], faces[d][side].u);
    auto *back = f[opposite<L>(i)];
    if (wall != 0.0)
      for_each_node(at, d, side, [&](Index n, const Int3 &) {
        back[n] = typename L::Real(back[n] - wall);
      });
  });
}

template <class L>
double open_face(const Layout &at, const Slots<L> &f, int d, int side, const Face &face,
                 const Faces &faces, const AtEnd &at_end, const int32_t *owner, const Vec3 &force)
{
  double gain = 0.0;
  const int inward = side == 0 ? 1 : -1;
  // does the population that arrives along e come from beyond a wall that meets this face?
  auto from_wall = [&](const int(&e)[3], const Int3 &p) {
    for (int t = 0; t < L::D; t++) {
      if (t == d || e[t] == 0) continue;
      const int s = e[t] > 0 ? 0 : 1;
      if (p[t] == (s == 0 ? 0 : at.n[t] - 1) && at_end[t][s] && faces[t][s].kind == FaceKind::WALL)
        return true;
    }
    return false;
  };

  auto velocity = [&](const Int3 &p) {
    Vec3 u = face.u;
    for (int t = 0; t < L::D; t++) {
      if (!face.across[t]) continue;
      const double h = (p[t] + at.lo[t] + 0.5) / face.across[t];
      for (double &component : u) component *= 4.0 * h * (1.0 - h);
    }
    return u;
  };

  for_each_node(at, d, side, [&](Index n, const Int3 &p) {
    if (owner && owner[n] >= 0) return;
    double in_plane = 0.0, outgoing = 0.0;
    Vec3 tangential{};    // momentum of the populations in the plane
    for (int i = 0; i < L::Q; i++) {
      const int en = L::e[i][d] * inward;
      if (en < 0) outgoing += f[i][n];
      if (en != 0) continue;
      in_plane += f[i][n];
      for (int t = 0; t < L::D; t++) tangential[t] += L::e[i][t] * double(f[i][n]);
    }
    // density and bare momentum j = rho u - F/2, from: sum of f = rho and of e f = j
    const double Fn = 0.5 * force[d] * inward;
    Vec3 j;
    if (face.kind == FaceKind::PRESSURE) {
      for (int t = 0; t < 3; t++) j[t] = -0.5 * force[t];
      j[d] = inward * (face.drho - in_plane - 2.0 * outgoing);
    } else {
      const Vec3 u = velocity(p);
      const double un = u[d] * inward;
      const double drho = (in_plane + 2.0 * outgoing - Fn + un) / (1.0 - un);
      for (int t = 0; t < 3; t++) j[t] = (1.0 + drho) * u[t] - 0.5 * force[t];
    }
    for (int i = 1; i < L::Q; i++) {
      const int(&e)[3] = L::e[i];
      if (e[d] != inward || from_wall(e, p)) continue;
      double fi = f[opposite<L>(i)][n] + 6.0 * L::w[i] * dot(e, j);
      // correction of the tangential momentum, shared by the two directions along t
      for (int t = 0; t < L::D; t++)
        if (t != d) fi += 0.5 * e[t] * (2.0 / 3.0 * j[t] - tangential[t]);
      f[i][n] = typename L::Real(fi);
      const int o = opposite<L>(i);    // and what left towards where that came from
      gain += double(f[i][n]) - double(f[o][n + at.offset(L::e[o])]);
    }
  });
  return gain;
}

#define LBM_INSTANTIATE(L)                                                               \
  template void bounce_at_walls<L>(const Layout &, const Slots<L> &, const Faces &,      \
                                   const AtEnd &);                                       \
  template double open_face<L>(const Layout &, const Slots<L> &, int, int, const Face &, \
                               const Faces &, const AtEnd &, const int32_t *, const Vec3 &);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
