// SPDX-License-Identifier: GPL-2.0-only
// The balance of momentum of a fluid that nothing holds: no wall, open face, obstacle or grain that
// is kept in place. Covered nodes take along what they hold, refilled ones bring that of the surface,
// and what drives the fluid acts on whole nodes: right on average, but the rest adds up until the
// whole drifts. A force on every fluid node, found anew now and then, gives it back. Lattice units.

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
    Vec3 force{};              // on every fluid node until the next look
  };

  // of each step: the force on a node that drives the fluid, and what grains took on this rank
  void drive(const Vec3 &force);
  void take(const Vec3 &momentum);

  // After so many steps since the last look: the whole fluid as it is, its true volume, and the steps
  // until the next one. Collective.
  void look(const Survey &whole, double volume, int steps, Neighbours &neighbours);
  void forget();    // grains came, went, or are held: begins anew

  const Vec3 &force() const { return state_.force; }
  const State &settle(Neighbours &neighbours);    // of all ranks. Collective.
  void resume(const State &state);

 private:
  State state_;
  Vec3 here_{};    // taken on this rank, not in the state yet
};

}    // namespace lbm
#endif
