// SPDX-License-Identifier: GPL-2.0-only
// Walks through a list of links, Links or another with groups and nodes, some packs before they
// are used, and fetches what they will need: their nodes are scattered over more than the caches
// next to a core hold.

#ifndef LBM_READ_AHEAD_H
#define LBM_READ_AHEAD_H

#include "lbm_link.h"

#include <algorithm>
#include <type_traits>

namespace lbm {

// open(direction) gives what the links of a group have in common, fetch(that, node) fetches
template <class List, class Open, class Fetch> class ReadAhead {
 public:
  ReadAhead(const List &links, int packs, Open open, Fetch fetch) :
      links_(links), open_(open), fetch_(fetch), common_(open(1))
  {
    begin(0);
    for (int k = 0; k < packs; k++) next();
  }

  // one pack of a group further, or what is left of it
  LBM_INLINE void next()
  {
    if (group_ == links_.groups.size()) return;
    const std::size_t end = links_.groups[group_].end;
    const std::size_t stop = std::min<std::size_t>(k_ + SIMD_WIDTH, end);
    for (; k_ < stop; k_++) fetch_(common_, links_.node[k_]);
    if (k_ == end) begin(group_ + 1);
  }

 private:
  const List &links_;
  const Open open_;
  const Fetch fetch_;
  std::invoke_result_t<Open, int> common_;
  std::size_t group_ = 0, k_ = 0;

  void begin(std::size_t group)
  {
    group_ = group;
    if (group == links_.groups.size()) return;
    common_ = open_(links_.groups[group].direction);
    k_ = links_.groups[group].begin;
  }
};

}    // namespace lbm
#endif
