// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_accounts.h"

#include <algorithm>
#include <cmath>

namespace lbm {

Accounts::Accounts(const Int3 &lattice, Index here, bool keep_mean, Neighbours &others) :
    lattice_(double(lattice[0]) * lattice[1] * lattice[2]), here_(here), fluid_(here),
    keep_mean_(keep_mean), neighbours_(others)
{
}

void Accounts::cover(Index nodes, double excess)
{
  fluid_ -= nodes;
  own_.covered += double(nodes);
  book(Ledger::COVERED, -excess);
}

void Accounts::uncover(Index nodes, double excess)
{
  fluid_ += nodes;
  own_.uncovered += double(nodes);
  book(Ledger::REFILLED, excess);
}

void Accounts::bounce(const std::vector<Load> &loads, const std::vector<Sphere> &spheres)
{
  for (std::size_t s = 0; s < loads.size(); s++) {
    book(Ledger::SWALLOWED, -loads[s].swallowed);
    book(Ledger::DISPLACED, loads[s].displaced);
    book(Ledger::RETURNED, 0.5 * spheres[s].refund * loads[s].area);
  }
}

void Accounts::agree(const std::array<bool *, 3> &any)
{
  const auto numbers = own_.numbers();
  std::array<double, Ledger::SIZE + 3> sums{};
  std::copy(numbers.begin(), numbers.end(), sums.begin());
  for (std::size_t k = 0; k < any.size(); k++) sums[Ledger::SIZE + k] = *any[k];
  neighbours_.sum(sums.data(), int(sums.size()));
  sums_.add(sums.data());
  own_ = {};
  for (std::size_t k = 0; k < any.size(); k++) *any[k] = sums[Ledger::SIZE + k] > 0.0;
}

void Accounts::settle()
{
  sums_ = all();
  own_ = {};
}

Ledger Accounts::all() const
{
  auto sums = own_.numbers();
  neighbours_.sum(sums.data(), int(sums.size()));
  Ledger all = sums_;
  all.add(sums.data());
  return all;
}

void Accounts::resume(const Ledger &sums, const MeanDensity &mean, Index covered)
{
  sums_ = sums;
  mean_ = mean;
  own_ = {};    // obstacles are in the sums already
  fluid_ = here_ - covered;
}

void Accounts::restore(bool motion, bool moved, const Look &whole)
{
  gain_ = 0.0;
  if (!keep_mean_ || !motion) return;
  if (mean_.known == 0.0)
    measure(whole);
  else if (moved)    // surfaces that stay where they are lose no more than a refund
    gain_ = lost_by_each_node();
}

void Accounts::measure(const Look &whole)
{
  const Survey s = whole();
  if (s.fluid_nodes == 0.0) return;
  const double excess = s.mass - s.fluid_nodes;
  mean_.start = excess - all().total_excess();
  if (mean_.known == 0.0) mean_.excess = excess / s.fluid_nodes;
  mean_.known = 1.0;
}

// No more than a scene that is well could need: where one node blows up, the others must not.
static constexpr double GAIN_MAX = 1e-3;

// As it was at the end of the last step: what surfaces displace, with them, in the next step belongs
// to the nodes that they cover and uncover now. It comes back evenly: no force comes of it.
double Accounts::lost_by_each_node() const
{
  const double nodes = lattice_ + sums_.nodes();
  if (nodes <= 0.0) return 0.0;
  const double lost = mean_.excess - (mean_.start + sums_.total_excess()) / nodes;
  return std::isfinite(lost) ? std::clamp(lost, -GAIN_MAX, GAIN_MAX) : 0.0;
}

}    // namespace lbm
