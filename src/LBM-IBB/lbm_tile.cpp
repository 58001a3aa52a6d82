// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_tile.h"

#include <cmath>

namespace lbm {
namespace {

  // What the nodes of a tile may take of the cache, and blocks not worth cutting. Smaller tiles
  // stay nearer to the core, but cut spheres into more pieces: 1/2 to 4 MiB are alike (Zen 5).
  constexpr double TILE = 3.0 * (1 << 20), WHOLE = 16.0 * (1 << 20);
  // rows are not cut shorter: whole packs, and enough of them to read ahead
  constexpr int ROW = 128;

  Int3 fitting(const Int3 &n, int dimension, double bytes_a_node)
  {
    if (bytes_a_node * double(n[0]) * n[1] * n[2] <= WHOLE) return n;
    const int length = n[0] < 2 * ROW ? n[0] : ROW;
    const double rows = TILE / (bytes_a_node * length);
    if (dimension == 2) return {length, std::max(4, int(rows)), 1};
    const int edge = std::max(4, int(std::sqrt(rows)));
    return {length, edge, edge};
  }

  // the outermost layer in parts that do not overlap; what is left is inside
  std::vector<Region> peel(Region &left, int dimension)
  {
    std::vector<Region> layers;
    for (int d = dimension - 1; d >= 0; d--)
      for (int side = 0; side < 2 && left.lo[d] <= left.hi[d]; side++) {
        Region layer = left;
        if (side == 0)
          layer.hi[d] = left.lo[d]++;
        else
          layer.lo[d] = left.hi[d]--;
        layers.push_back(layer);
      }
    return layers;
  }

}    // namespace

Tiles::Tiles(const Layout &layout, int dimension, double bytes_a_node, const Int3 &size) :
    n_(layout.n), size_(size[0] > 0 ? size : fitting(layout.n, dimension, bytes_a_node)),
    inner_(layout.all())
{
  for (int d = 0; d < 3; d++) {
    size_[d] = std::min(size_[d], n_[d]);
    parts_[d] = (n_[d] + size_[d] - 1) / size_[d];
  }
  if (cut())
    shell_ = peel(inner_, dimension);
  else
    shell_ = {inner_};
}

Region Tiles::swept(std::size_t k) const
{
  Region region;
  for (int d = 0; d < 3; d++) {
    const int part = int(k % parts_[d]);
    k /= parts_[d];
    region.lo[d] = part * size_[d];
    region.hi[d] = std::min(region.lo[d] + size_[d], n_[d]) - 1;
  }
  return region;
}

Region Tiles::behind(std::size_t k) const
{
  Region region = swept(k);
  for (int d = 0; d < 3; d++) {
    region.lo[d] = std::max(region.lo[d] - 1, inner_.lo[d]);
    region.hi[d] = region.hi[d] == n_[d] - 1 ? inner_.hi[d] : region.hi[d] - 1;
  }
  return region;
}

}    // namespace lbm
