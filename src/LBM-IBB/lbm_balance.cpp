// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_balance.h"

namespace lbm {

void Balance::drive(const Vec3 &force)
{
  for (int d = 0; d < 3; d++) state_.driven[d] += force[d];
}

void Balance::take(const Vec3 &momentum)
{
  for (int d = 0; d < 3; d++) here_[d] += momentum[d];
}

void Balance::look(const Survey &whole, double volume, int steps, Neighbours &neighbours)
{
  settle(neighbours);
  State &s = state_;
  for (int d = 0; d < 3; d++) {
    const double due = s.driven[d] * volume - s.taken[d], got = whole.momentum[d] - s.momentum[d];
    s.missing[d] = s.known == 0.0 ? 0.0 : s.missing[d] + due - got;
    s.force[d] = s.missing[d] / (steps * whole.fluid_nodes);
  }
  s.momentum = whole.momentum;
  s.driven = s.taken = {};
  s.known = 1.0;
}

void Balance::forget()
{
  state_ = {};
  here_ = {};
}

const Balance::State &Balance::settle(Neighbours &neighbours)
{
  neighbours.sum(here_.data(), 3);
  for (int d = 0; d < 3; d++) state_.taken[d] += here_[d];
  here_ = {};
  return state_;
}

void Balance::resume(const State &state)
{
  state_ = state;
  here_ = {};
}

}    // namespace lbm
