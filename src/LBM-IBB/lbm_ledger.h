// SPDX-License-Identifier: GPL-2.0-only
// The mass ledger: by what the fluid gains and loses mass. Lattice units.
//
// Its mass is the sum of rho over fluid nodes, their number plus their density excess. Every gain
// is booked where it happens, so that to round-off, on any number of ranks,
//     mass now - mass at the start = sum of the accounts
// Nodes that spheres cover and uncover come and go as a whole, while the surfaces push mass out of
// the way and draw it in continuously: only the sum of the first three accounts is the motion's.

#ifndef LBM_LEDGER_H
#define LBM_LEDGER_H

#include <array>

namespace lbm {

struct Ledger {
  enum Account {
    COVERED,      // nodes that spheres cover: a loss
    REFILLED,     // nodes that they uncover
    DISPLACED,    // what links give to fluid that is at rest with a moving surface
    SWALLOWED,    // what they get beyond that and do not return, see Load: a loss
    RETURNED,     // refunds of it
    POCKETS,      // nodes that have no way to the rest of the fluid, or no more than one
    RESTORED,     // to keep the mean density of a closed box
    FACES,        // faces of the box: xlo, xhi, ylo, yhi, zlo, zhi
    ACCOUNTS = FACES + 6
  };
  std::array<double, ACCOUNTS> excess{};    // gained, beyond rest density in the nodes below
  double covered = 0.0, uncovered = 0.0;    // nodes

  double gain(int account) const
  {
    return excess[account] + (account == COVERED ? -covered : account == REFILLED ? uncovered : 0);
  }
  double nodes() const { return uncovered - covered; }
  double total_excess() const
  {
    double sum = 0.0;
    for (double x : excess) sum += x;
    return sum;
  }
  double total() const { return nodes() + total_excess(); }

  static constexpr int SIZE = ACCOUNTS + 2;
  std::array<double, SIZE> numbers() const
  {
    std::array<double, SIZE> all{};
    for (int k = 0; k < ACCOUNTS; k++) all[k] = excess[k];
    all[ACCOUNTS] = covered;
    all[ACCOUNTS + 1] = uncovered;
    return all;
  }
  void add(const double *numbers)
  {
    for (int k = 0; k < ACCOUNTS; k++) excess[k] += numbers[k];
    covered += numbers[ACCOUNTS];
    uncovered += numbers[ACCOUNTS + 1];
  }
};

// Mean density of a closed box, kept for as long as its spheres move: known from when they first do
struct MeanDensity {
  double known = 0.0;     // yes or no
  double start = 0.0;     // total excess when the ledger was empty
  double excess = 0.0;    // of a node, in the mean
};

}    // namespace lbm
#endif
