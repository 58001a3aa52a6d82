// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_link_pass.h"

#include "lbm_bounce_back.h"
#include "lbm_exchange.h"
#include "lbm_refill.h"

#include <algorithm>

namespace lbm {
namespace {

  // what a core can count on of the last level of cache, and what of it the planes of a slab may
  // take
  constexpr double CACHE = 16.0 * (1 << 20), SLAB = 8.0 * (1 << 20);

  Region whole(const Layout &at)
  {
    return {{0, 0, 0}, {at.n[0] - 1, at.n[1] - 1, at.n[2] - 1}};
  }

  // the outermost layer in parts that do not overlap; what is left is inside
  std::vector<Region> shell(Region &left, int dimension)
  {
    std::vector<Region> layers;
    for (int d = dimension - 1; d >= 0; d--)
      for (int side = 0; side < 2 && left.lo[d] <= left.hi[d]; side++) {
        Region layer = left;
        if (side == 0)
          layer.hi[d] = left.lo[d]++;
        else
          layer.lo[d] = left.hi[d]--;
        layers.push_back(layer);
      }
    return layers;
  }

}    // namespace

template <class L>
LinkPass<L>::LinkPass(const Layout &layout, LinkRule rule, int slab) :
    at_(layout), rule_(rule), slab_(slab), inner_(whole(layout))
{
  const double bytes_a_plane =
      sizeof(typename L::Real) * double(L::Q) * double(at_.size) / double(planes());
  if (slab_ == 0)
    slab_ = bytes_a_plane * planes() < CACHE ? planes()
                                             : std::max(4, int(SLAB / bytes_a_plane) - 2);
  slab_ = std::min(slab_, planes());
  if (cut())
    shell_ = shell(inner_, L::D);
  else
    shell_ = {inner_};
}

template <class L>
void LinkPass<L>::start(const Cover &cover, bool moved, const float *drho, std::vector<Load> &loads)
{
  cover_ = &cover;
  drho_ = drho;
  loads_ = &loads;
  moved_ = moved;
  if (moved_) kept_ = false;
  if (kept_) return;
  lists_.resize(moved_ ? 1 : slabs() + 1);
  for (Links &list : lists_) {
    list.clear();
    list.pockets.clear();
  }
  links_ = gaps_ = 0;
}

// nodes of this slab but its last plane, whose next is not swept yet, and the last of the one
// before
template <class L> void LinkPass<L>::inner(int k, const Slots<L> &f)
{
  if (!cut()) return;
  Region region = inner_;
  region.lo[OUTER] = std::max(region.lo[OUTER], first_plane(k) - 1);
  region.hi[OUTER] = std::min(region.hi[OUTER], first_plane(k + 1) - 2);
  part(k, {region}, f);
}

template <class L> void LinkPass<L>::outermost(const Slots<L> &f)
{
  part(slabs(), shell_, f);
  if (!moved_) kept_ = true;
}

template <class L>
void LinkPass<L>::part(std::size_t k, const std::vector<Region> &regions, const Slots<L> &f)
{
  Links &list = moved_ ? lists_[0] : lists_[k];
  if (!kept_) {
    for (std::size_t s = 0; s < cover_->spheres().size(); s++)
      for (const Region &region : regions) {
        const std::size_t links = list.size, gaps = list.gaps.size();
        find_links<L>(at_, *cover_, s, region, list);
        links_ += list.size - links + 2 * (list.gaps.size() - gaps);
        gaps_ += list.gaps.size() - gaps;
        if (!moved_) continue;
        bounce(list, f);
        list.clear();
      }
    if (moved_) return;
    list.trim();
  }
  bounce(list, f);
}

template <class L> void LinkPass<L>::bounce(const Links &links, const Slots<L> &f)
{
  switch (rule_) {
    case LinkRule::HALFWAY:
      return bounce_with<Halfway>(links, f);
    case LinkRule::BOUZIDI:
      return bounce_with<Bouzidi>(links, f);
    case LinkRule::CLI:
      return bounce_with<Cli>(links, f);
  }
}

template <class L>
template <class Rule>
void LinkPass<L>::bounce_with(const Links &links, const Slots<L> &f)
{
  if (drho_)
    bounce_back<L, Rule, true>(at_, f, *cover_, links, drho_, *loads_);
  else
    bounce_back<L, Rule, false>(at_, f, *cover_, links, nullptr, *loads_);
}

template <class L> void LinkPass<L>::fill_pockets(const Slots<L> &f, const Vec3 &force) const
{
  for (const Links &list : lists_) lbm::fill_pockets<L>(at_, f, *cover_, list.pockets, force);
}

template <class L> double LinkPass<L>::bytes() const
{
  double sum = 0.0;
  for (const Links &list : lists_) sum += list.bytes();
  return sum;
}

#define LBM_INSTANTIATE(L) template class LinkPass<L>;
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
