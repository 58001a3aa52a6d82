// SPDX-License-Identifier: GPL-2.0-only
// When links are found and bounce back: as soon as the sweep has left their nodes in the cache.
//
// A link needs x_f and its two neighbours along the link swept, and nothing from beyond the faces
// of the block unless it lies in the block's outermost layer. So the block is swept in tiles; after
// each, the links of the inner nodes behind it are done, and those of the outermost layer wait for
// the halo and the walls. A link touches four lines of memory at random: 5 ns in the cache, 21 ns
// out of it (Zen 5, links of spheres that stay). Lattice units; places are those of the block.
//
// Links of spheres that move are found and used one sphere at a time; those of spheres that stay
// are found once and kept, and so are those of obstacles in tiles that no sphere reaches.

#ifndef LBM_LINK_PASS_H
#define LBM_LINK_PASS_H

#include "lbm_link.h"
#include "lbm_tile.h"
#include "lbm_yield.h"

namespace lbm {

enum class LinkRule { HALFWAY, BOUZIDI, CLI, ZHAO };

template <class L> class LinkPass {
 public:
  // ledger: of the mass that links swallow; tile: its nodes along x, y, z; 0: chosen by the size of
  // the cache
  LinkPass(const Layout &layout, LinkRule rule, bool ledger, const Int3 &tile);

  // Before the sweep of a step. moved: spheres are not where they were; motion: what they do now.
  // drho: density excess by node, filled by the sweep, if surfaces move, else null; cover, drho and
  // loads have to live until the end of the step. loads[s] gets what sphere s receives.
  void start(const Cover &cover, bool moved, Motion motion, const float *drho,
             std::vector<Load> &loads);

  const Tiles &tiles() const { return tiles_; }
  // after the sweep of tile k, which is in slots of the next step
  void inner(std::size_t k, const Slots<L> &f);
  // after halo and walls
  void outermost(const Slots<L> &f);
  // last of all, see fill_pockets(); returns the mass gained
  double fill_pockets(const Slots<L> &f, const Vec3 &force) const;

  // of spheres that yield in the last step, see lbm_yield.h, the former of all spheres if any does;
  // recall() finds the links of a step made elsewhere
  const std::vector<Response> &responses() const { return responses_; }
  Taken correct(const Slots<L> &f, const std::vector<Gain> &gains) const;
  void recall(const Cover &cover);

  double links() const { return double(links_); }    // in the last step, gaps included
  double gaps() const { return double(gaps_); }
  double bytes() const;

 private:
  Layout at_;
  LinkRule rule_;
  bool ledger_;
  Tiles tiles_;

  const Cover *cover_ = nullptr;
  const float *drho_ = nullptr;
  std::vector<Load> *loads_ = nullptr;
  bool moved_ = false, kept_ = false, any_yields_ = false;
  Motion motion_ = Motion::REST;
  // of spheres that stay, by tile, the shell last; or one, of a moving sphere
  std::vector<Links> lists_;
  Yields yields_;
  std::vector<Response> responses_;
  // spheres that may have links behind each tile k: near_[first_near_[k]] ...
  std::vector<uint32_t> first_near_, near_;
  std::size_t links_ = 0, gaps_ = 0;

  // Links of obstacles while spheres move elsewhere: by tile, the regions of the shell last
  struct Still {
    bool found = false;
    Links links;
  };
  std::vector<Still> still_;
  std::size_t first_obstacle_ = 0;    // as they are numbered in still_

  void find_near();
  void renumber_still();
  bool obstacles_alone(const Region &region) const;
  void bounce_still(std::size_t part, const Region &region, const Slots<L> &f);
  void find_outermost(const Slots<L> &f);
  void find(std::size_t s, const Region &region, std::size_t k, const Slots<L> &f);
  void bounce_kept(std::size_t k, const Slots<L> &f);
  void bounce(const Links &links, bool yields, const Slots<L> &f);
  template <class Rule> void bounce_with(const Links &links, bool yields, const Slots<L> &f);
  template <class Rule, Motion motion, bool yields>
  void bounce_in(const Links &links, const Slots<L> &f);
  template <class F> void with_rule(F &&f) const;
};

}    // namespace lbm
#endif
