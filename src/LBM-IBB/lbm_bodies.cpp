// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_bodies.h"

#include <cstring>

namespace lbm {

std::vector<Sphere> Bodies::after(std::vector<Sphere> spheres, bool refunds) const
{
  for (int k = 0; k < obstacles_.count(); k++) {
    const ObstacleState &state = states_[k];
    spheres.push_back(obstacles_.body(k));
    spheres.back().drho = state.last.drho();
    if (refunds)
      spheres.back().refund = refund(state.last.swallowed, state.before.swallowed, state.last.area);
  }
  return spheres;
}

void Bodies::take(std::vector<Load> &loads, Neighbours &neighbours)
{
  constexpr std::size_t N = sizeof(Load) / sizeof(double);    // all of it are sums
  const std::size_t grains = loads.size() - states_.size();
  std::vector<double> sums(N * states_.size());
  std::memcpy(sums.data(), &loads[grains], sums.size() * sizeof(double));
  neighbours.sum(sums.data(), int(sums.size()));
  for (std::size_t k = 0; k < states_.size(); k++) {
    states_[k].before = states_[k].last;
    std::memcpy(static_cast<void *>(&states_[k].last), &sums[N * k], sizeof(Load));
    states_[k].steps += 1.0;
  }
  loads.resize(grains);
}

}    // namespace lbm
