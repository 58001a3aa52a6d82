// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_link.h"

#include <algorithm>

namespace lbm {

void Links::clear()
{
  groups.clear();
  gaps.clear();
  hidden.clear();
  size = at_open_faces = 0;
}

void Links::trim()
{
  auto fit = [this](auto &list) {
    list.resize(size);
    list.shrink_to_fit();
  };
  fit(node);
  fit(q);
  for (auto &component : arm) fit(component);
  gaps.shrink_to_fit();
}

double Links::bytes() const
{
  return double(node.capacity() * sizeof(uint32_t) + q.capacity() * sizeof(double) +
                3 * arm[0].capacity() * sizeof(int16_t) + gaps.capacity() * sizeof(Gap) +
                groups.capacity() * sizeof(LinkGroup) + hidden.capacity() * sizeof(Hidden));
}

namespace {

  // the links of one sphere along one direction
  template <class L> class Finder {
   public:
    Finder(const Layout &at, const Cover &cover, std::size_t s, Links &links) :
        at(at), cover(cover), s(s), rows(cover.rows(s)), owner(cover.owner()), c(cover.centre(s)),
        origin(anchor(c)), links(links), first_hidden(links.hidden.size())
    {
    }

    void along(int direction)
    {
      i = direction;
      const int(&e)[3] = L::e[i];
      shift = at.offset(e);
      const std::size_t begin = links.size;
      for (int z = std::max(rows.z0, e[2]); z <= std::min(rows.z1, at.n[2] - 1 + e[2]); z++)
        for (int y = std::max(rows.y0, e[1]); y <= std::min(rows.y1, at.n[1] - 1 + e[1]); y++) {
          const Run solid = cover.run(rows, y, z);
          if (solid.xa > solid.xb) continue;
          // fluid nodes of the row the links come from: candidates not under the same sphere
          const int yf = y - e[1], zf = z - e[2];
          Run shadow{1, 0};
          if (rows.contains(yf, zf)) shadow = cover.run(rows, yf, zf);
          const int a = solid.xa - e[0], b = solid.xb - e[0];
          if (shadow.xa > shadow.xb) {
            candidates(a, b, yf, zf);
          } else {
            candidates(a, std::min(b, shadow.xa - 1), yf, zf);
            candidates(std::max(a, shadow.xb + 1), b, yf, zf);
          }
        }
      if (links.size == begin) return;
      set_fractions(begin);
      links.groups.push_back({int32_t(s), int32_t(i), begin, links.size});
    }

   private:
    const Layout &at;
    const Cover &cover;
    const std::size_t s;
    const Rows rows;
    const int32_t *owner;
    const Vec3 c;
    const Int3 origin;
    Links &links;
    const std::size_t first_hidden;
    int i = 0;
    Index shift = 0;

    void candidates(int a, int b, int y, int z)
    {
      a = std::max(a, 0);
      b = std::min(b, at.n[0] - 1);
      if (a > b) return;
      if (links.node.size() < links.size + (b - a + 1)) {
        const std::size_t room = std::max<std::size_t>(2 * links.node.size(), 1024 + b - a);
        links.node.resize(room);
        for (auto &component : links.arm) component.resize(room);
        links.q.resize(room);
      }
      Index n = at.index(a, y, z);
      for (int x = a; x <= b; x++, n++) {
        if (owner[n + shift] != int32_t(s)) continue;
        if (owner[n] >= 0) {
          hide(owner[n], x, y, z);
          continue;
        }
        const int32_t behind = owner[n - shift];
        if (behind >= 0) {
          if (i <= L::P) add_gap(n, x, y, z, behind);
          continue;
        }
        links.node[links.size] = uint32_t(n);
        links.arm[0][links.size] = int16_t(x - origin[0]);
        links.arm[1][links.size] = int16_t(y - origin[1]);
        links.arm[2][links.size] = int16_t(z - origin[2]);
        if (behind == OUTSIDE) open_face.push_back(links.size);
        links.size++;
      }
    }

    void hide(int32_t t, int x, int y, int z)
    {
      auto h = std::find_if(links.hidden.begin() + first_hidden, links.hidden.end(),
                            [&](const Hidden &other) {
                              return other.t == t;
                            });
      if (h == links.hidden.end()) h = links.hidden.insert(h, {int32_t(s), t});
      const int(&e)[3] = L::e[i];
      const double w = L::w[i];
      const Vec3 we{w * e[0], w * e[1], w * e[2]};
      const Vec3 wxe = cross({x + 0.5 * e[0], y + 0.5 * e[1], z + 0.5 * e[2]}, we);
      for (int d = 0; d < 3; d++) {
        h->we[d] += we[d];
        h->wxe[d] += wxe[d];
      }
    }

    std::vector<std::size_t> open_face;

    void set_fractions(std::size_t begin)
    {
      const double r = cover.spheres()[s].radius;
      const Vec3 f{origin[0] - c[0], origin[1] - c[1], origin[2] - c[2]};
      for (std::size_t k = begin; k < links.size; k++)
        links.q[k] = cut({links.arm[0][k] + f[0], links.arm[1][k] + f[1], links.arm[2][k] + f[2]},
                         L::e[i], r);
      for (std::size_t k : open_face) links.q[k] = 0.5;
      links.at_open_faces += open_face.size();
      open_face.clear();
    }

    void add_gap(Index n, int x, int y, int z, int32_t behind)
    {
      const Vec3 b = cover.centre(behind);
      links.gaps.push_back({uint32_t(n), int32_t(i), int32_t(s), behind,
                            cut({x - c[0], y - c[1], z - c[2]}, L::e[i], cover.spheres()[s].radius),
                            cut({x - b[0], y - b[1], z - b[2]}, L::e[opposite<L>(i)],
                                cover.spheres()[behind].radius)});
    }
  };

}    // namespace

template <class L>
void find_links(const Layout &at, const Cover &cover, std::size_t s, Links &links)
{
  Finder<L> finder(at, cover, s, links);
  for (int i = 1; i < L::Q; i++) finder.along(i);
}

template void find_links<D3Q19>(const Layout &, const Cover &, std::size_t, Links &);
template void find_links<D2Q9>(const Layout &, const Cover &, std::size_t, Links &);

}    // namespace lbm
