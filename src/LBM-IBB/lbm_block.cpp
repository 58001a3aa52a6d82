// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_block.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lbm {

Layout::Layout(const Int3 &lo_, const Int3 &n_, int dimension) :
    lo(lo_), n(n_), ghost{1, 1, dimension == 3 ? 1 : 0}
{
  stride_y = n[0] + 2 * ghost[0];
  stride_z = stride_y * (n[1] + 2 * ghost[1]);
  origin = ghost[0] + ghost[1] * stride_y + ghost[2] * stride_z;
  size = stride_z * (n[2] + 2 * ghost[2]);
}

Int3 Layout::node(Index i) const
{
  return {int(i % stride_y) - ghost[0], int(i / stride_y % (stride_z / stride_y)) - ghost[1],
          int(i / stride_z) - ghost[2]};
}

void Freed::operator()(void *p) const
{
  std::free(p);
}

void *zeroed_pages(std::size_t bytes)
{
  constexpr std::size_t small = 4096, huge = std::size_t(1) << 21;
  const std::size_t page = bytes >= 8 * huge ? huge : small;
  const std::size_t whole = (std::max<std::size_t>(bytes, 1) + page - 1) / page * page;
  void *p = std::aligned_alloc(page, whole);
  if (!p) throw std::bad_alloc();
#ifdef __linux__
  // 19 streams at once need more pages than the translation buffer holds of the small ones
  if (page == huge) madvise(p, whole, MADV_HUGEPAGE);
#endif
  std::memset(p, 0, whole);
  return p;
}

template <class L> Block<L>::Block(const Layout &layout) : at(layout)
{
  // Q streams that start at the same address modulo 4096 would evict each other from the cache:
  // let successive arrays start three cache lines apart.
  constexpr Index page = 4096 / sizeof(Real), line = 64 / sizeof(Real);
  pitch = (at.size + page - 1) / page * page + 3 * line;
  populations.reset(static_cast<Real *>(zeroed_pages(sizeof(Real) * L::Q * pitch)));
}

#define LBM_INSTANTIATE(L) template class Block<L>;
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
