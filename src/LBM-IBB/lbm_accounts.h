// SPDX-License-Identifier: GPL-2.0-only
// The ledger as it is kept: entries of this rank, until all ranks agree on their sums; and what the
// mean density of a closed box has lost, which the next sweep gives back. Lattice units.

#ifndef LBM_ACCOUNTS_H
#define LBM_ACCOUNTS_H

#include "lbm_ledger.h"
#include "lbm_monitor.h"
#include "lbm_sphere.h"

#include <functional>
#include <vector>

namespace lbm {

class Accounts {
 public:
  // lattice: nodes of the whole; here: of this rank, all of them fluid; keep_mean: the mean density
  Accounts(const Int3 &lattice, Index here, bool keep_mean, Neighbours &others);

  // entries of this rank: mass that its nodes gained; nodes that were lost and won with what they hold
  void book(int account, double gain) { own_.excess[account] += gain; }
  void cover(Index nodes, double excess);
  void uncover(Index nodes, double excess);
  void bounce(const std::vector<Load> &loads, const std::vector<Sphere> &spheres);

  // The entries of all ranks are summed, and what any of them says becomes what all say: one
  // message. Collective.
  void agree(const std::array<bool *, 3> &any);
  void settle();         // the sums alone. Collective.
  Ledger all() const;    // sums and entries. Collective.
  // goes on from sums made elsewhere, with so many covered nodes on this rank
  void resume(const Ledger &sums, const MeanDensity &mean, Index covered);

  // After agree(): what each node is to gain in the next sweep, if surfaces of any rank moved. The
  // mean density is known from the first motion on, by a survey of the whole fluid. Collective.
  using Look = std::function<Survey()>;
  void restore(bool motion, bool moved, const Look &whole);
  void restored() { book(Ledger::RESTORED, gain_ * double(fluid_)); }    // by that sweep
  double gain() const { return gain_; }                                  // on all ranks alike
  const MeanDensity &mean() const { return mean_; }
  void measure(const Look &whole);    // it anew, for what rounding has done. Collective.

 private:
  double lattice_;
  Index here_, fluid_;    // nodes of this rank
  bool keep_mean_;
  Neighbours &neighbours_;
  Ledger own_;     // of this rank, what is not in the sums yet
  Ledger sums_;    // of all ranks
  MeanDensity mean_;
  double gain_ = 0.0;

  double lost_by_each_node() const;
};

}    // namespace lbm
#endif
