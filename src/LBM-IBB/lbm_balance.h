// SPDX-License-Identifier: GPL-2.0-only
// The balance of momentum of a fluid that nothing holds: no wall, open face, obstacle or grain that
// is kept in place. Covered nodes take along what they hold, refilled ones bring that of the surface:
// right on average, but the rest adds up until the whole drifts. A force on every fluid node, found
// anew now and then, gives it back. Lattice units.
//
// The fluid's momentum is the mean over its nodes times its volume: their number jitters as grains
// pass, by which nothing is gained. Its start is that of the first look.

#ifndef LBM_BALANCE_H
#define LBM_BALANCE_H

#include "lbm_monitor.h"

namespace lbm {

class Balance {
 public:
  struct State {
    double known = 0.0;        // yes or no: momentum at the last look
    Vec3 momentum{};           // of the fluid then
    Vec3 missing{};            // and what of it was not there yet
    Vec3 driven{}, taken{};    // since: force on a node by steps; given to grains, on all ranks
    Vec3 force{}, next{};      // on every fluid node now, and from the next step on
    double left = 0.0;         // steps until it ends
  };

  // a step begins, in which this force drives every node
  void start(const Vec3 &drive);
  const Vec3 &force() const { return state_.force; }
  void take(const Vec3 &momentum);    // by grains, on this rank

  // At the end of a step: the whole fluid as it is, its true volume; what is missing comes back in
  // so many steps. Collective.
  void look(const Survey &whole, double volume, int steps, Neighbours &neighbours);
  void forget();    // grains came, went, or are held: begins anew

  const State &settle(Neighbours &neighbours);    // of all ranks. Collective.
  void resume(const State &state);

 private:
  State state_;
  Vec3 drive_{};    // of this step
  Vec3 here_{};     // taken on this rank, not in the state yet
};

}    // namespace lbm
#endif
