// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_link.h"

namespace lbm {

namespace {

  template <class T> double held(const std::vector<T> &list)
  {
    return double(list.capacity() * sizeof(T));
  }

}    // namespace

void Gaps::clear()
{
  groups.clear();
  size = 0;
}

void Gaps::add(int32_t x_f, int32_t sphere_behind)
{
  if (node.size() < size + 2 * SIMD_WIDTH) resize(2 * size + 64);
  node[size] = x_f;
  behind[size++] = sphere_behind;
}

void Gaps::close(int32_t ahead, int direction, std::size_t begin)
{
  if (size > begin) add_group(groups, ahead, direction, begin, size);
}

void Gaps::trim()
{
  resize(size + SIMD_WIDTH);
  groups.shrink_to_fit();
  node.shrink_to_fit();
  behind.shrink_to_fit();
  q_ahead.shrink_to_fit();
  q_behind.shrink_to_fit();
}

void Gaps::resize(std::size_t room)
{
  node.resize(room);
  behind.resize(room);
  q_ahead.resize(room);
  q_behind.resize(room);
}

double Gaps::bytes() const
{
  return held(groups) + held(node) + held(behind) + held(q_ahead) + held(q_behind);
}

void Links::clear()
{
  groups.clear();
  gaps.clear();
  hidden.clear();
  size = 0;
}

void Links::trim()
{
  auto fit = [this](auto &list) {
    list.resize(size + SIMD_WIDTH);
    list.shrink_to_fit();
  };
  fit(q);
  fit(node);
  groups.shrink_to_fit();
  gaps.trim();
  hidden.shrink_to_fit();
  bits = {};
  spans = {};
}

double Links::bytes() const
{
  return held(q) + held(node) + held(groups) + gaps.bytes() + held(pockets) + held(hidden) +
      held(bits) + held(spans);
}

Region nodes_with_links(const Cover &cover, std::size_t s)
{
  if (cover.is_obstacle(s)) return cover.obstacles().nodes_with_links(cover.obstacle(s));
  const double reach = cover.spheres()[s].radius + 1.0;
  Region region;
  for (int d = 0; d < 3; d++) {
    region.lo[d] = int(std::ceil(cover.centre(s)[d] - reach));
    region.hi[d] = int(std::floor(cover.centre(s)[d] + reach));
  }
  return region;
}

}    // namespace lbm
