// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_link.h"

#include <algorithm>

namespace lbm {
namespace {

  // The links of one sphere. Rows of nodes around it are turned into bits, one per node, 64 nodes
  // at a time: the links of a row along one direction are then three shifts and as many ands.
  template <class L> class Finder {
   public:
    Finder(const Layout &at, const Cover &cover, std::size_t s, const Region &region,
           Links &links) :
        at(at),
        cover(cover), decode(at), s(s), owner(cover.owner()), c(cover.centre(s)),
        obstacle(cover.is_obstacle(s)), links(links), first_hidden(links.hidden.size())
    {
      const Region near = nodes_with_links(cover, s);
      for (int d = 0; d < 3; d++) {
        lo[d] = std::max(near.lo[d], region.lo[d]);
        hi[d] = std::min(near.hi[d], region.hi[d]);
        at_wall = at_wall || at_face(d, Cover::WALL);
        at_open_face = at_open_face || at_face(d, Cover::OPEN);
      }
    }

    void find()
    {
      if (lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]) return;
      if (!obstacle) hide_at_faces();
      // bit 0 and bit 63 are neighbours of nodes looked at only
      for (x0 = lo[0] - 1; x0 < hi[0]; x0 += 62) {
        read_bits();
        find_pockets();
        for (int i = 1; i <= L::P; i++) {    // opposite directions use the same two arrays
          along(i);
          along(i + L::P);
        }
      }
    }

   private:
    bool at_face(int d, Cover::Side side) const
    {
      return (lo[d] == 0 && cover.behind(d, 0) == side) ||
          (hi[d] == at.n[d] - 1 && cover.behind(d, 1) == side);
    }

    const Layout &at;
    const Cover &cover;
    const Decoder decode;
    const std::size_t s;
    const int32_t *owner;
    const Vec3 c;
    const bool obstacle;
    bool at_wall = false, at_open_face = false;    // some of the nodes looked at
    Links &links;
    const std::size_t first_hidden;
    Int3 lo{}, hi{};
    int x0 = 0;    // node of bit 0

    // rows from one below lo to one above hi
    Bits &bits(int y, int z)
    {
      return links.bits[(y - lo[1] + 1) + std::size_t(z - lo[2] + 1) * (hi[1] - lo[1] + 3)];
    }

    // of the layer, within the rows looked at
    Links::Span span(int z, int shift) const
    {
      const Links::Span &all = links.spans[z - lo[2] + 1];
      return {std::max(all.first + shift, lo[1]), std::min(all.last + shift, hi[1])};
    }

    void read_bits()
    {
      links.bits.resize(std::size_t(hi[1] - lo[1] + 3) * (hi[2] - lo[2] + 3));
      links.spans.resize(hi[2] - lo[2] + 3);
      const int gz = L::D == 3 ? 1 : 0, looked_at = std::min(hi[0] - x0 + 2, 64);
      for (int z = lo[2] - gz; z <= hi[2] + gz; z++) {
        Links::Span &span = links.spans[z - lo[2] + 1];
        span = {hi[1] + 2, lo[1] - 2};
        for (int y = lo[1] - 1; y <= hi[1] + 1; y++) {
          const Bits row = bits(y, z) = compare(owner + at.index(x0, y, z), int32_t(s), looked_at);
          span.first = row.equal ? std::min(span.first, y) : span.first;
          span.last = row.equal ? y : span.last;
        }
      }
    }

    // Nodes with one fluid neighbour at most. Each is found once: with the sphere that covers its
    // neighbour below along x, or else the one above.
    void find_pockets()
    {
      static_assert(L::Q == 19 || L::Q == 9, "neighbours are those of D3Q19 or D2Q9");
      const bool wall_below = cover.behind(0, 0) == Cover::WALL && x0 == -1;
      const bool wall_above = cover.behind(0, 1) == Cover::WALL && at.n[0] - x0 <= 63;
      uint64_t water = ~uint64_t(0);    // bits that are not behind a wall along x
      if (wall_below) water &= ~uint64_t(1);
      if (wall_above) water &= ~(~uint64_t(0) << (at.n[0] - x0));
      const auto walled = [&](int d, int p) {
        return (p < 0 && cover.behind(d, 0) == Cover::WALL) ||
            (p >= at.n[d] && cover.behind(d, 1) == Cover::WALL);
      };
      for (int z = lo[2]; z <= hi[2]; z++)
        for (int y = span(z, 0).first; y <= span(z, 0).last; y++) {
          const Bits &here = bits(y, z);
          const auto fluid = [&](int dy, int dz) {
            if (at_wall && (walled(1, y + dy) || walled(2, z + dz))) return uint64_t(0);
            return bits(y + dy, z + dz).negative & water;
          };
          const uint64_t with = here.equal << 1 | (here.equal >> 1 & here.negative << 1);
          uint64_t found = window() & here.negative & with, one = 0;
          const auto drop_second = [&](uint64_t neighbours) {
            found &= ~(one & neighbours);
            one |= neighbours;
          };
          const auto drop_second_of_row = [&](uint64_t row) {
            drop_second(row);
            drop_second(row << 1);
            drop_second(row >> 1);
          };
          if (!found) continue;
          drop_second(fluid(0, 0) << 1);
          drop_second(fluid(0, 0) >> 1);
          for (int side : {-1, 1}) {
            drop_second_of_row(fluid(side, 0));
            if (L::D == 3 && found) drop_second_of_row(fluid(0, side));
          }
          for (int k = 0; L::D == 3 && found && k < 4; k++)
            drop_second(fluid(k & 1 ? 1 : -1, k & 2 ? 1 : -1));
          for (; found; found &= found - 1)
            links.pockets.push_back(uint32_t(at.index(x0 + __builtin_ctzll(found), y, z)));
        }
    }

    // bits of the owned nodes looked at that may have links
    uint64_t window() const
    {
      return (~uint64_t(0) >> (63 - std::min(hi[0] - x0, 62))) & ~uint64_t(1);
    }

    void along(int i)
    {
      const std::size_t begin = links.size, first_gap = links.gaps.size;
      switch (L::e[i][0]) {
        case -1:
          along_rows<-1>(i);
          break;
        case 0:
          along_rows<0>(i);
          break;
        case 1:
          along_rows<1>(i);
          break;
      }
      if (links.gaps.size > first_gap) set_fractions_of_gaps(i, first_gap);
      links.gaps.close(int32_t(s), i, first_gap);
      if (links.size == begin) return;
      set_fractions(i, begin);
      add_group(links.groups, int32_t(s), i, begin, links.size);
    }

    // bits of the nodes step further along x
    template <int step> static uint64_t seen_from(uint64_t b)
    {
      return step > 0 ? b >> 1 : (step == 0 ? b : b << 1);
    }

    template <int ex> void along_rows(int i)
    {
      const int(&e)[3] = L::e[i];
      const uint64_t window = this->window();
      for (int z = lo[2]; z <= hi[2]; z++) {
        const auto [first, last] = span(z + e[2], -e[1]);
        if (first > last) continue;
        const Bits *here = &bits(first, z), *ahead = &bits(first + e[1], z + e[2]),
                   *behind = &bits(first - e[1], z - e[2]);
        make_room(std::size_t(last - first + 1) * 62);
        const int32_t further = int32_t(at.stride_y);
        int32_t row = int32_t(at.index(x0, first, z)), *end = &links.node[links.size];
        for (int y = first; y <= last; y++, here++, ahead++, behind++, row += further) {
          const uint64_t found = window & ~here->equal & seen_from<ex>(ahead->equal);
          const uint64_t fluid = found & here->negative;
          const uint64_t free = fluid & seen_from<-ex>(behind->negative);
          end = append_bits(free, row, end);    // most rows have some: to ask first costs more
          if (free == found) continue;
          if (fluid != found && !obstacle) hide(i, found & ~fluid, y, z);
          if (i <= L::P && free != fluid) add_gaps(i, fluid & ~free, row);
        }
        links.size = std::size_t(end - links.node.data());
      }
    }

    void make_room(std::size_t more)
    {
      const std::size_t most = links.size + more + 16 + SIMD_WIDTH;
      if (links.q.size() >= most) return;
      links.q.resize(2 * most);
      links.node.resize(2 * most);
    }

    void set_fractions(int i, std::size_t begin)
    {
      const double r = cover.spheres()[s].radius;
      const int32_t *node = links.node.data();
      double *q = links.q.data();
      const int(&e)[3] = L::e[i];
      if (obstacle) {
        cover.obstacles().fractions(node + begin, links.size - begin, i, q + begin);
      } else {
        const V centre[3] = {V{} + c[0], V{} + c[1], V{} + c[2]};
        for (std::size_t k = begin; k < links.size; k += SIMD_WIDTH)    // the arrays reach further
          store(q + k, fractions(node + k, centre, e, V{} + r));
      }
      if (at_open_face) halve_at_open_face(i, begin);
    }

    // where no x_f' is known
    void halve_at_open_face(int i, std::size_t begin)
    {
      const Index back = -at.offset(L::e[i]);
      for (std::size_t k = begin; k < links.size; k++)
        if (owner[links.node[k] + back] == OUTSIDE) links.q[k] = 0.5;
    }

    using V = Pack<SIMD_WIDTH>;

    V fractions(const int32_t *node, const V (&centre)[3], const int (&e)[3], const V &radius) const
    {
      V x[3];
      decode(load<PackInt<SIMD_WIDTH>>(node), x);
      const V d[3] = {x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]};
      return cut(d, e, radius);
    }

    // links from nodes of another sphere
    void hide(int i, uint64_t found, int y, int z)
    {
      const Index row = at.index(x0, y, z);
      for (; found; found &= found - 1) {
        const int k = __builtin_ctzll(found);
        hide_link(i, owner[row + k], {x0 + k, y, z});
      }
    }

    void hide_link(int i, int32_t t, const Int3 &from)
    {
      const int(&e)[3] = L::e[i];
      const double w = L::w[i];
      const Vec3 we{w * e[0], w * e[1], w * e[2]};
      auto h = links.hidden.begin() + first_hidden;
      while (h != links.hidden.end() && h->t != t) ++h;
      if (h == links.hidden.end()) h = links.hidden.insert(h, {int32_t(s), t});
      const Vec3 wxe =
          cross({from[0] + 0.5 * e[0], from[1] + 0.5 * e[1], from[2] + 0.5 * e[2]}, we);
      for (int d = 0; d < 3; d++) {
        h->we[d] += we[d];
        h->wxe[d] += wxe[d];
      }
    }

    // links from behind a wall or an open face to covered nodes next to it
    void hide_at_faces()
    {
      for (int d = 0; d < L::D; d++)
        for (int side = 0; side < 2; side++) {
          const int layer = side == 0 ? 0 : at.n[d] - 1;
          if (cover.behind(d, side) == Cover::NEIGHBOUR || layer < lo[d] || layer > hi[d]) continue;
          Int3 a = lo, b = hi, p;
          a[d] = b[d] = layer;
          for (p[2] = a[2]; p[2] <= b[2]; p[2]++)
            for (p[1] = a[1]; p[1] <= b[1]; p[1]++)
              for (p[0] = a[0]; p[0] <= b[0]; p[0]++)
                if (owner[at.index(p[0], p[1], p[2])] == int32_t(s)) hide_behind(d, side, p);
        }
    }

    // through this face of node p; through an edge of the box with the first of its faces only
    void hide_behind(int d, int side, const Int3 &p)
    {
      for (int i = 1; i < L::Q; i++) {
        const int(&e)[3] = L::e[i];
        if (e[d] != (side == 0 ? 1 : -1)) continue;
        bool first = true;
        for (int k = 0; k < d; k++) {
          const int from = p[k] - e[k];
          if ((from < 0 && cover.behind(k, 0) != Cover::NEIGHBOUR) ||
              (from >= at.n[k] && cover.behind(k, 1) != Cover::NEIGHBOUR))
            first = false;
        }
        if (first) hide_link(i, FLUID, {p[0] - e[0], p[1] - e[1], p[2] - e[2]});
      }
    }

    void add_gaps(int i, uint64_t found, Index row)
    {
      const Index back = -at.offset(L::e[i]);
      for (; found; found &= found - 1) {
        const Index n = row + __builtin_ctzll(found);
        links.gaps.add(int32_t(n), owner[n + back]);
      }
    }

    void set_fractions_of_gaps(int i, std::size_t begin)
    {
      Gaps &gaps = links.gaps;
      const V r = V{} + cover.spheres()[s].radius, mine[3] = {V{} + c[0], V{} + c[1], V{} + c[2]};
      std::fill_n(&gaps.behind[gaps.size], SIMD_WIDTH, int32_t(s));    // for the rest of a pack
      for (std::size_t k = begin; k < gaps.size; k += SIMD_WIDTH) {
        const int32_t *t = &gaps.behind[k];
        V centre[3];
        for (int d = 0; d < 3; d++)
          centre[d] = pack_of<SIMD_WIDTH>([&](int l) LBM_INLINE {
            return cover.centre(t[l])[d];
          });
        const V radius = pack_of<SIMD_WIDTH>([&](int l) LBM_INLINE {
          return cover.spheres()[t[l]].radius;
        });
        store(&gaps.q_ahead[k], fractions(&gaps.node[k], mine, L::e[i], r));
        store(&gaps.q_behind[k], fractions(&gaps.node[k], centre, L::e[opposite<L>(i)], radius));
      }
      if (cover.is_obstacle(cover.spheres().size() - 1)) set_fractions_of_obstacles(i, begin);
    }

    void set_fractions_of_obstacles(int i, std::size_t begin)
    {
      Gaps &gaps = links.gaps;
      for (std::size_t k = begin; k < gaps.size; k++) {
        if (obstacle) gaps.q_ahead[k] = cover.obstacles().fraction(gaps.node[k], i);
        if (cover.is_obstacle(gaps.behind[k]))
          gaps.q_behind[k] = cover.obstacles().fraction(gaps.node[k], opposite<L>(i));
      }
    }
  };

}    // namespace

template <class L>
void find_links(const Layout &at, const Cover &cover, std::size_t s, const Region &region,
                Links &links)
{
  Finder<L>(at, cover, s, region, links).find();
}

#define LBM_INSTANTIATE(L) \
  template void find_links<L>(const Layout &, const Cover &, std::size_t, const Region &, Links &);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
