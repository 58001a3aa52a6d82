// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_state.h"

#include <cstring>
#include <tuple>

namespace lbm {
namespace {

  // finalizer of SplitMix64 (Steele, Lea & Flood 2014): every bit of x moves half of the result's
  std::uint64_t mix(std::uint64_t x)
  {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  constexpr std::uint64_t GOLDEN = 0x9e3779b97f4a7c15u;

  std::uint64_t bits(double x)
  {
    std::uint64_t b;
    std::memcpy(&b, &x, sizeof b);
    return b;
  }
  std::uint64_t bits(float x)
  {
    std::uint32_t b;
    std::memcpy(&b, &x, sizeof b);
    return b;
  }

  template <class F> void for_each_row(const Layout &at, const Part &part, F &&f)
  {
    for (int z = 0; z < part.n[2]; z++)
      for (int y = 0; y < part.n[1]; y++)
        f(at.index(part.lo[0] - at.lo[0], part.lo[1] + y - at.lo[1], part.lo[2] + z - at.lo[2]));
  }

}    // namespace

template <class L>
void give(const Layout &at, const Slots<L> &f, const Part &part, typename L::Real *to)
{
  for_each_row(at, part, [&](Index row) {
    for (int x = 0; x < part.n[0]; x++)
      for (int i = 0; i < L::Q; i++) *to++ = f[i][row + x];
  });
}

template <class L>
void take(const Layout &at, const Slots<L> &f, const Part &part, const typename L::Real *from)
{
  for_each_row(at, part, [&](Index row) {
    for (int x = 0; x < part.n[0]; x++)
      for (int i = 0; i < L::Q; i++) f[i][row + x] = *from++;
  });
}

// odd factors, so that no change of a single value goes unseen
template <class L> std::uint64_t checksum(const Layout &at, const Slots<L> &f, const Int3 &global)
{
  std::uint64_t factor[L::Q] = {}, sum = 0;
  for (int i = 0; i < L::Q; i++) factor[i] = mix(GOLDEN * (i + 1)) | 1;
  for (int z = 0; z < at.n[2]; z++)
    for (int y = 0; y < at.n[1]; y++) {
      const Index row = at.index(0, y, z);
      const std::uint64_t first = at.lo[0] +
          std::uint64_t(global[0]) * (at.lo[1] + y + std::uint64_t(global[1]) * (at.lo[2] + z));
      for (int x = 0; x < at.n[0]; x++) {
        std::uint64_t node = mix(GOLDEN * (first + x + 1));
        for (int i = 0; i < L::Q; i++) node += bits(f[i][row + x]) * factor[i];
        sum += mix(node);
      }
    }
  return sum;
}

Trace::Trace(const Sphere &s) :
    id(s.id), centre(s.centre), radius(s.radius), velocity(s.velocity), spin(s.spin), drho(s.drho),
    yields(s.yields)
{
}

Sphere Trace::sphere() const
{
  return {id, centre, radius, velocity, spin, drho, 0.0, yields != 0};
}

std::uint64_t checksum(const Sphere &s)
{
  const Trace trace(s);
  static_assert(sizeof(Trace) == 13 * 8, "no padding, whose bits would be anything");
  return checksum(&trace, sizeof trace / 8);
}

std::uint64_t checksum(const void *words, std::size_t n)
{
  std::uint64_t h = 0, word;
  for (std::size_t k = 0; k < n; k++) {
    std::memcpy(&word, static_cast<const char *>(words) + 8 * k, 8);
    h = mix(h + GOLDEN + word);
  }
  return h;
}

std::vector<Sphere> centred_here(const std::vector<Sphere> &spheres, const Layout &at,
                                 const Lattice &lattice)
{
  std::vector<Sphere> here;
  for (const Sphere &s : spheres) {
    bool in = true;
    for (int d = 0; d < 3; d++) {
      double place = std::floor(s.centre[d]);
      if (!lattice.periodic[d]) place = std::clamp(place, 0.0, lattice.n[d] - 1.0);
      in = in && place >= at.lo[d] && place < at.lo[d] + at.n[d];
    }
    if (in) here.push_back(s);
  }
  return here;
}

std::vector<Sphere> reaching_here(const std::vector<Sphere> &grains, const Layout &at,
                                  const Lattice &lattice)
{
  std::vector<Sphere> here;
  for (const Sphere &grain : grains) {
    Int3 first{}, last{};    // periods by which an image may be shifted
    for (int d = 0; d < 3; d++) {
      if (!lattice.periodic[d]) continue;
      const double room = grain.radius + 1.0, c = grain.centre[d];
      first[d] = int(std::floor((at.lo[d] - room - c) / lattice.n[d]));
      last[d] = int(std::ceil((at.lo[d] + at.n[d] + room - c) / lattice.n[d]));
    }
    for (int z = first[2]; z <= last[2]; z++)
      for (int y = first[1]; y <= last[1]; y++)
        for (int x = first[0]; x <= last[0]; x++) {
          Sphere image = grain;
          const Int3 shift{x, y, z};
          bool reaches = true;
          for (int d = 0; d < 3; d++) {
            image.centre[d] += double(shift[d]) * lattice.n[d];
            reaches = reaches &&
                (at.ghost[d] == 0 ||
                 (image.centre[d] + image.radius > at.lo[d] - 1.0 &&
                  image.centre[d] - image.radius < at.lo[d] + at.n[d] + 1.0));
          }
          if (reaches) here.push_back(image);
        }
  }
  return here;
}

bool same_but_for_order(std::vector<Sphere> a, std::vector<Sphere> b)
{
  auto key = [](const Sphere &s) {
    return std::tie(s.id, s.centre, s.radius);
  };
  auto before = [&](const Sphere &s, const Sphere &t) {
    return key(s) < key(t);
  };
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Sphere &s, const Sphere &t) {
    return key(s) == key(t);
  });
}

#define LBM_INSTANTIATE(L)                                                                         \
  template void give<L>(const Layout &, const Slots<L> &, const Part &, typename L::Real *);       \
  template void take<L>(const Layout &, const Slots<L> &, const Part &, const typename L::Real *); \
  template std::uint64_t checksum<L>(const Layout &, const Slots<L> &, const Int3 &);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
