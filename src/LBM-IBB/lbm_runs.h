// SPDX-License-Identifier: GPL-2.0-only
// The fluid nodes of a block as runs along x, and which of them are connected within the block:
// runs that a population can cross between are joined, row by row (Rosenfeld & Pfaltz 1966).

#ifndef LBM_RUNS_H
#define LBM_RUNS_H

#include "lbm_block.h"
#include "lbm_simd.h"

#include <algorithm>
#include <vector>

namespace lbm {

// Sets that are joined: each member knows a smaller one of its set, the smallest itself
class Joined {
 public:
  void add() { parent_.push_back(parent_.size()); }
  std::size_t smallest(std::size_t k)
  {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b)
  {
    a = smallest(a);
    b = smallest(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Piece {
  int xa, xb, y, z;    // nodes xa..xb
};

template <class L> class FluidRuns {
 public:
  // owner < 0 is fluid, rows can be read 64 nodes past their end
  FluidRuns(const Layout &at, const int32_t *owner) : at_(at)
  {
    for (int z = 0; z < at.n[2]; z++)
      for (int y = 0; y < at.n[1]; y++) {
        first_.push_back(pieces_.size());
        read_row(owner + at.index(0, y, z), y, z);
      }
    first_.push_back(pieces_.size());
    for (int z = 0; z < at.n[2]; z++)
      for (int y = 0; y < at.n[1]; y++) {
        join_rows(y, z, -1, 0);
        for (int dy = -1; L::D == 3 && dy <= 1; dy++) join_rows(y, z, dy, -1);
      }
  }

  const std::vector<Piece> &pieces() const { return pieces_; }
  // the first of those connected with piece k
  std::size_t first_of(std::size_t k) { return joined_.smallest(k); }

 private:
  const Layout &at_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> first_;    // of each row
  Joined joined_;

  void read_row(const int32_t *owner, int y, int z)
  {
    const std::size_t begin = pieces_.size();
    for (int x0 = 0; x0 < at_.n[0]; x0 += 64) {
      uint64_t fluid = compare(owner + x0, 0).negative;
      if (at_.n[0] - x0 < 64) fluid &= (uint64_t(1) << (at_.n[0] - x0)) - 1;
      while (fluid) {
        const int from = __builtin_ctzll(fluid);
        const uint64_t solid = ~(fluid >> from);    // zeros move in from above
        const int to = from + (solid ? __builtin_ctzll(solid) : 64);
        if (pieces_.size() > begin && pieces_.back().xb == x0 + from - 1) {
          pieces_.back().xb = x0 + to - 1;
        } else {
          pieces_.push_back({x0 + from, x0 + to - 1, y, z});
          joined_.add();
        }
        fluid = to == 64 ? 0 : fluid & (~uint64_t(0) << to);
      }
    }
  }

  // with a row that comes before; populations go sideways too, unless both dy and dz differ from 0
  void join_rows(int y, int z, int dy, int dz)
  {
    static_assert(L::Q == 19 || L::Q == 9, "neighbours are those of D3Q19 or D2Q9");
    if (y + dy < 0 || y + dy >= at_.n[1] || z + dz < 0) return;
    const int reach = dy != 0 && dz != 0 ? 0 : 1;
    const std::size_t here = std::size_t(y) + std::size_t(z) * at_.n[1];
    const std::size_t there = std::size_t(y + dy) + std::size_t(z + dz) * at_.n[1];
    std::size_t a = first_[here], b = first_[there];
    while (a < first_[here + 1] && b < first_[there + 1]) {
      if (pieces_[a].xa <= pieces_[b].xb + reach && pieces_[b].xa <= pieces_[a].xb + reach)
        joined_.join(a, b);
      if (pieces_[a].xb < pieces_[b].xb)
        a++;
      else
        b++;
    }
  }
};

}    // namespace lbm
#endif
