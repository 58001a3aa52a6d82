// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_halo.h"

#include <algorithm>

namespace lbm {

namespace {

  template <class Real> void copy_row(const Real *from, int length, Real *to)
  {
    if (length == 1)    // faces along x: no call for a single number
      *to = *from;
    else
      std::copy_n(from, length, to);
  }

}    // namespace

template <class L> std::size_t Halo<L>::Box::nodes() const
{
  return std::size_t(hi[0] - lo[0] + 1) * (hi[1] - lo[1] + 1) * (hi[2] - lo[2] + 1);
}

template <class L>
Halo<L>::Halo(const Layout &layout, Neighbours &neighbours) : at_(layout), neighbours_(neighbours)
{
  std::size_t most = 0;
  for (int d = 0; d < L::D; d++)
    most = std::max(most, for_each_crossing(d, 0, true, [](int, const Box &) {
                    }));
  send_.resize(most);
  receive_.resize(most);
}

template <class L> typename Halo<L>::Box Halo<L>::region(int k, int d, int side, bool ghosts) const
{
  Box box{{0, 0, 0}, {at_.n[0] - 1, at_.n[1] - 1, at_.n[2] - 1}};
  // directions already done: the values wanted have moved along them
  for (int p = 0; p < d; p++) {
    box.lo[p] += L::e[k][p];
    box.hi[p] += L::e[k][p];
  }
  const int outside = side == 0 ? -1 : at_.n[d], opposite_layer = side == 0 ? at_.n[d] - 1 : 0;
  box.lo[d] = box.hi[d] = ghosts ? outside : opposite_layer;
  return box;
}

template <class L>
template <class F>
std::size_t Halo<L>::for_each_crossing(int d, int side, bool ghosts, F &&f) const
{
  std::size_t n = 0;
  for (int k = 1; k < L::Q; k++)
    if (L::e[k][d] == (side == 0 ? -1 : 1)) {
      const Box box = region(k, d, side, ghosts);
      f(k, box);
      n += box.nodes();
    }
  return n;
}

// values that cross the face on this side of the block; forwards they come from the neighbour there
template <class L> void Halo<L>::along(const Block<L> &block, int d, int side, bool forwards)
{
  if (neighbours_.itself(d)) return to_itself(block, d, side, forwards);
  using Real = typename L::Real;
  auto copy = [&](Real *buffer, bool ghosts, bool pack) {
    return for_each_crossing(d, side, ghosts, [&](int k, const Box &box) {
      Real *array = block.array(k);
      const int length = box.hi[0] - box.lo[0] + 1;
      for (int z = box.lo[2]; z <= box.hi[2]; z++)
        for (int y = box.lo[1]; y <= box.hi[1]; y++, buffer += length) {
          Real *row = array + at_.index(box.lo[0], y, z);
          copy_row(pack ? row : buffer, length, pack ? buffer : row);
        }
    });
  };
  // forwards: boundary layer -> neighbour's ghosts on its other side; backwards: ghosts -> layer
  const std::size_t n = copy(send_.data(), !forwards, true);
  const int to = forwards ? 1 - side : side;
  neighbours_.shift(d, to, send_.data(), n, receive_.data(), n);
  if (neighbours_.exists(d, 1 - to)) copy(receive_.data(), forwards, false);
}

// the same where the block is its own neighbour: from layer to layer
template <class L>
void Halo<L>::to_itself(const Block<L> &block, int d, int side, bool forwards) const
{
  for_each_crossing(d, side, !forwards, [&](int k, const Box &from) {
    const Box to = region(k, d, side, forwards);
    auto *array = block.array(k);
    const int length = from.hi[0] - from.lo[0] + 1;
    for (int z = from.lo[2]; z <= from.hi[2]; z++)
      for (int y = from.lo[1]; y <= from.hi[1]; y++)
        copy_row(array + at_.index(from.lo[0], y, z), length,
                 array + at_.index(to.lo[0], y - from.lo[1] + to.lo[1], z - from.lo[2] + to.lo[2]));
  });
}

template <class L> void Halo<L>::exchange(const Block<L> &block)
{
  const bool forwards = block.step() % 2 == 0;
  for (int p = 0; p < L::D; p++)
    for (int side = 0; side < 2; side++) along(block, forwards ? p : L::D - 1 - p, side, forwards);
}

#define LBM_INSTANTIATE(L) template class Halo<L>;
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
