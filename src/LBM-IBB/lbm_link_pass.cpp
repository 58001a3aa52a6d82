// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_link_pass.h"

#include "lbm_bounce_back.h"
#include "lbm_exchange.h"
#include "lbm_refill.h"

#include <algorithm>
#include <numeric>

namespace lbm {

template <class L>
LinkPass<L>::LinkPass(const Layout &layout, LinkRule rule, bool ledger, const Int3 &tile) :
    at_(layout), rule_(rule), ledger_(ledger),
    tiles_(layout, L::D, sizeof(typename L::Real) * double(L::Q), tile)
{
}

template <class L>
void LinkPass<L>::start(const Cover &cover, bool moved, Motion motion, const float *drho,
                        std::vector<Load> &loads)
{
  cover_ = &cover;
  drho_ = drho;
  loads_ = &loads;
  moved_ = moved;
  motion_ = motion;
  const auto &spheres = cover.spheres();
  any_yields_ = std::any_of(spheres.begin(), spheres.end(), [](const Sphere &s) {
    return s.yields;
  });
  responses_.clear();
  yields_.reaches.assign(any_yields_ ? REACHES<L> * spheres.size() : 0, {});
  yields_.answers.clear();
  yields_.in_gaps.assign(any_yields_ ? spheres.size() : 0, {});
  if (moved_) kept_ = false;
  if (moved_ && cover.first_obstacle() < spheres.size())
    renumber_still();
  else
    still_ = {};
  if (kept_) return;
  lists_.resize(moved_ ? 1 : tiles_.count() + 1);
  for (Links &list : lists_) {
    list.clear();
    list.pockets.clear();
  }
  links_ = gaps_ = 0;
  if (tiles_.cut()) find_near();
}

template <class L> void LinkPass<L>::find_near()
{
  const auto for_each_tile = [&](std::size_t s, auto &&f) {
    tiles_.for_each_behind(nodes_with_links(*cover_, s), f);
  };
  const std::size_t spheres = cover_->spheres().size();
  first_near_.assign(tiles_.count() + 1, 0);
  for (std::size_t s = 0; s < spheres; s++)
    for_each_tile(s, [&](std::size_t k) {
      first_near_[k]++;
    });
  // each entry is the end of its tile, and goes back to the beginning as the tile is filled
  std::partial_sum(first_near_.begin(), first_near_.end(), first_near_.begin());
  near_.resize(first_near_.back());
  for (std::size_t s = spheres; s-- > 0;)
    for_each_tile(s, [&](std::size_t k) {
      near_[--first_near_[k]] = uint32_t(s);
    });
}

// obstacles are the last in the list of spheres
template <class L> void LinkPass<L>::renumber_still()
{
  const std::size_t first = cover_->first_obstacle();
  const auto shift = int32_t(first) - int32_t(first_obstacle_);
  first_obstacle_ = first;
  still_.resize(tiles_.count() + tiles_.shell().size());
  if (shift == 0) return;
  for (Still &still : still_) {
    Gaps &gaps = still.links.gaps;
    for (LinkGroup &group : still.links.groups) group.sphere += shift;
    for (LinkGroup &group : gaps.groups) group.sphere += shift;
    for (int32_t &s : gaps.behind) s += shift;
  }
}

template <class L> bool LinkPass<L>::obstacles_alone(const Region &region) const
{
  for (std::size_t s = 0; s < first_obstacle_; s++)
    if (!nodes_with_links(*cover_, s).apart(region)) return false;
  return true;
}

// of obstacles that no sphere is near to
template <class L>
void LinkPass<L>::bounce_still(std::size_t part, const Region &region, const Slots<L> &f)
{
  auto &[found, links] = still_[part];
  if (!found) {
    for (std::size_t s = first_obstacle_; s < cover_->spheres().size(); s++)
      find_links<L>(at_, *cover_, s, region, links);
    links.trim();
    found = true;
  }
  links_ += links.size + 2 * links.gaps.size;
  gaps_ += links.gaps.size;
  auto &pockets = lists_[0].pockets;
  pockets.insert(pockets.end(), links.pockets.begin(), links.pockets.end());
  bounce(links, any_yields_ && links.gaps.size > 0, f);
}

template <class L> void LinkPass<L>::inner(std::size_t k, const Slots<L> &f)
{
  if (!tiles_.cut()) return;
  if (!kept_) {
    const std::size_t first = first_near_[k], end = first_near_[k + 1];    // obstacles last
    if (!still_.empty() && first < end && cover_->is_obstacle(near_[first]))
      bounce_still(k, tiles_.behind(k), f);
    else
      for (std::size_t n = first; n < end; n++) find(near_[n], tiles_.behind(k), k, f);
  }
  if (!moved_) bounce_kept(k, f);
}

template <class L> void LinkPass<L>::find_outermost(const Slots<L> &f)
{
  const std::size_t all = cover_->spheres().size(), moving = still_.empty() ? all : first_obstacle_;
  const auto &shell = tiles_.shell();
  for (std::size_t s = 0; s < moving; s++)
    for (const Region &region : shell) find(s, region, tiles_.count(), f);
  for (std::size_t r = 0; moving < all && r < shell.size(); r++)
    if (obstacles_alone(shell[r]))
      bounce_still(tiles_.count() + r, shell[r], f);
    else
      for (std::size_t s = moving; s < all; s++) find(s, shell[r], tiles_.count(), f);
}

template <class L> void LinkPass<L>::outermost(const Slots<L> &f)
{
  if (!kept_) find_outermost(f);
  if (!moved_) {
    bounce_kept(tiles_.count(), f);
    kept_ = true;
  }
  for (std::size_t s = 0; any_yields_ && s < cover_->spheres().size(); s++) {
    (*loads_)[s] += yields_.in_gaps[s];
    if (!cover_->is_obstacle(s))
      responses_.push_back(response<L>(&yields_.reaches[REACHES<L> * s], yields_.in_gaps[s]));
  }
}

template <class L> void LinkPass<L>::bounce_kept(std::size_t k, const Slots<L> &f)
{
  if (!kept_) lists_[k].trim();
  bounce(lists_[k], any_yields_, f);
}

// links of one sphere; if it moves they are used at once and not kept
template <class L>
void LinkPass<L>::find(std::size_t s, const Region &region, std::size_t k, const Slots<L> &f)
{
  Links &list = lists_[moved_ ? 0 : k];
  const std::size_t links = list.size, gaps = list.gaps.size;
  __builtin_prefetch(&(*loads_)[s], 1);
  __builtin_prefetch(&(*loads_)[s].displaced, 1);
  find_links<L>(at_, *cover_, s, region, list);
  links_ += list.size - links + 2 * (list.gaps.size - gaps);
  gaps_ += list.gaps.size - gaps;
  if (!moved_) return;
  // of the spheres at the two ends of a gap either may yield
  const bool shared = list.gaps.size > 0 || !list.hidden.empty();
  bounce(list, cover_->spheres()[s].yields || (any_yields_ && shared), f);
  list.clear();
}

template <class L> template <class F> void LinkPass<L>::with_rule(F &&f) const
{
  switch (rule_) {
    case LinkRule::HALFWAY:
      return f(Halfway{});
    case LinkRule::BOUZIDI:
      return f(Bouzidi{});
    case LinkRule::CLI:
      return f(Cli{});
    case LinkRule::ZHAO:
      return f(Zhao{});
  }
}

template <class L> void LinkPass<L>::bounce(const Links &links, bool yields, const Slots<L> &f)
{
  with_rule([&](auto rule) {
    bounce_with<decltype(rule)>(links, yields, f);
  });
}

template <class L>
template <class Rule>
void LinkPass<L>::bounce_with(const Links &links, bool yields, const Slots<L> &f)
{
  if (yields) return bounce_in<Rule, Motion::TURN, true>(links, f);
  switch (motion_) {
    case Motion::REST:
      return bounce_in<Rule, Motion::REST, false>(links, f);
    case Motion::SHIFT:
      return bounce_in<Rule, Motion::SHIFT, false>(links, f);
    case Motion::TURN:
      return bounce_in<Rule, Motion::TURN, false>(links, f);
  }
}

template <class L>
template <class Rule, Motion motion, bool yields>
void LinkPass<L>::bounce_in(const Links &links, const Slots<L> &f)
{
  if (ledger_)
    bounce_back<L, Rule, motion, true, yields>(at_, f, *cover_, links, drho_, *loads_, yields_);
  else
    bounce_back<L, Rule, motion, false, yields>(at_, f, *cover_, links, drho_, *loads_, yields_);
}

template <class L> double LinkPass<L>::fill_pockets(const Slots<L> &f, const Vec3 &force) const
{
  double gain = 0.0;
  for (const Links &list : lists_)
    gain += lbm::fill_pockets<L>(at_, f, *cover_, list.pockets, force);
  return gain;
}

template <class L>
Taken LinkPass<L>::correct(const Slots<L> &f, const std::vector<Gain> &gains) const
{
  Taken sum;
  if (yields_.reaches.empty()) return sum;
  lbm::correct<L>(at_, f, *cover_, yields_.answers, gains);
  for (std::size_t s = 0; s < gains.size(); s++) {
    const Taken more = taken<L>(&yields_.reaches[REACHES<L> * s], gains[s]);
    sum.displaced += more.displaced;
    sum.swallowed += more.swallowed;
  }
  return sum;
}

template <class L> void LinkPass<L>::recall(const Cover &cover)
{
  cover_ = &cover;
  moved_ = true;
  kept_ = false;
  yields_.reaches.assign(REACHES<L> * cover.spheres().size(), {});
  yields_.answers.clear();
  Links links;
  const auto look = [&](std::size_t s, const Region &region) {
    // a gap of a sphere that yields may be found with the one at its other end
    if (!cover.spheres()[s].yields && !GAPS_ANSWER<L>) return;
    find_links<L>(at_, cover, s, region, links);
    with_rule([&](auto rule) {
      lbm::recall<L, decltype(rule)>(at_, cover, links, yields_);
    });
    links.clear();
  };
  // in the order of a step, so that sums are the same to the bit
  if (tiles_.cut()) {
    find_near();
    for (std::size_t k = 0; k < tiles_.count(); k++)
      for (std::size_t n = first_near_[k]; n < first_near_[k + 1]; n++)
        look(near_[n], tiles_.behind(k));
  }
  for (std::size_t s = 0; s < cover.spheres().size(); s++)
    for (const Region &region : tiles_.shell()) look(s, region);
}

template <class L> double LinkPass<L>::bytes() const
{
  double sum = yields_.answers.bytes();
  for (const Links &list : lists_) sum += list.bytes();
  for (const Still &still : still_) sum += still.links.bytes();
  return sum + double((first_near_.capacity() + near_.capacity()) * sizeof(uint32_t));
}

#define LBM_INSTANTIATE(L) template class LinkPass<L>;
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
