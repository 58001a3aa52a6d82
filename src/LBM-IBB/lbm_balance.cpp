// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_balance.h"

namespace lbm {

void Balance::start(const Vec3 &drive)
{
  drive_ = drive;
  for (int d = 0; d < 3; d++) state_.driven[d] += drive[d];
  state_.force = state_.left > 0.0 ? state_.next : Vec3{};
  state_.left -= 1.0;
}

void Balance::take(const Vec3 &momentum)
{
  for (int d = 0; d < 3; d++) here_[d] += momentum[d];
}

void Balance::look(const Survey &whole, double volume, int steps, Neighbours &neighbours)
{
  settle(neighbours);
  State &s = state_;
  if (whole.fluid_nodes == 0.0) return;
  for (int d = 0; d < 3; d++) {
    // in a survey the velocity has half of a step's force in it, which may be another in the next
    const double of_node = whole.momentum[d] / whole.fluid_nodes - 0.5 * (drive_[d] + s.force[d]);
    const double got = volume * of_node - s.momentum[d], due = s.driven[d] * volume - s.taken[d];
    s.missing[d] = s.known == 0.0 ? 0.0 : s.missing[d] + due - got;
    s.momentum[d] = volume * of_node;
    s.next[d] = s.missing[d] / (steps * volume);
  }
  s.driven = s.taken = {};
  s.known = 1.0;
  s.left = steps;
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
