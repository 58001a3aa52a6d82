// SPDX-License-Identifier: GPL-2.0-only
// When links are found and bounce back: as soon as the sweep has left their nodes in the cache.
//
// A link needs x_f and its two neighbours along the link swept, and nothing from beyond the faces
// of the block unless it lies in the block's outermost layer. So the sweep is cut into slabs of
// planes (across z, in two dimensions across y); after each, the links of the inner nodes behind it
// are done, and those of the outermost layer wait for the halo and the walls. A link whose nodes
// have to be fetched from memory costs up to four times as much as one in the cache (Zen 5, links
// of spheres that stay: 21 ns, 5 ns). A block that fits into the cache as a whole is not cut.
// Lattice units; places are those of the block.
//
// Links of spheres that move are found and used one sphere at a time; those of spheres that stay
// are found once and kept.

#ifndef LBM_LINK_PASS_H
#define LBM_LINK_PASS_H

#include <algorithm>

#include "lbm_link.h"

namespace lbm {

enum class LinkRule { HALFWAY, BOUZIDI, CLI };

template <class L> class LinkPass {
 public:
  // slab: planes of a slab; 0: chosen by the size of the cache
  LinkPass(const Layout &layout, LinkRule rule, int slab);

  // Before the sweep of a step. drho: density excess by node, filled by the sweep, if surfaces
  // move, else null; all three have to live until the end of the step. loads[s] gets what sphere s
  // receives.
  void start(const Cover &cover, bool moved, const float *drho, std::vector<Load> &loads);

  int slabs() const { return (planes() + slab_ - 1) / slab_; }
  int first_plane(int k) const { return std::min(k * slab_, planes()); }
  // after the sweep of slab k, which is in slots of the next step
  void inner(int k, const Slots<L> &f);
  // after halo and walls
  void outermost(const Slots<L> &f);
  // last of all, see fill_pockets()
  void fill_pockets(const Slots<L> &f, const Vec3 &force) const;

  double links() const { return double(links_); }    // in the last step, gaps included
  double gaps() const { return double(gaps_); }
  double bytes() const;

 private:
  static constexpr int OUTER = L::D - 1;    // the direction in which the sweep goes last
  Layout at_;
  LinkRule rule_;
  int slab_;
  std::vector<Region> shell_;    // the outermost layer, or everything if the block is not cut
  Region inner_;

  const Cover *cover_ = nullptr;
  const float *drho_ = nullptr;
  std::vector<Load> *loads_ = nullptr;
  bool moved_ = false, kept_ = false;
  std::vector<Links>
      lists_;    // of spheres that stay, by slab, the shell last; or one, of a moving sphere
  std::size_t links_ = 0, gaps_ = 0;

  int planes() const { return at_.n[OUTER]; }
  bool cut() const { return slab_ < planes(); }
  void part(std::size_t k, const std::vector<Region> &regions, const Slots<L> &f);
  void bounce(const Links &links, const Slots<L> &f);
  template <class Rule> void bounce_with(const Links &links, const Slots<L> &f);
};

}    // namespace lbm
#endif
