// SPDX-License-Identifier: GPL-2.0-only
// Which sweep a step needs: the collision rule is chosen once, forces and solids by what is there.

#ifndef LBM_SWEEPS_H
#define LBM_SWEEPS_H

#include "lbm_sweep.h"

namespace lbm {

template <class L> struct Collision {
  Trt<L> trt;
  Regularised<L> regularised;
  bool is_regularised;
};

template <class L> class Sweeps {
 public:
  Sweeps(const Block<L> &block, const Collision<L> &collision) :
      block_(block), collision_(collision)
  {
  }

  // owner: null without solids; drho: null unless surfaces move or nodes gain mass, see MovingSolids
  struct Around {
    Vec3 force;
    const int32_t *owner;
    float *drho;
    double gain;
  };
  void sweep(const Around &around, const Region &region) const
  {
    if (around.force == Vec3{})
      with(NoForce{}, around, region);
    else
      with(UniformForce{around.force}, around, region);
  }

 private:
  const Block<L> &block_;
  Collision<L> collision_;

  template <class Force>
  void with(const Force &force, const Around &around, const Region &region) const
  {
    if (around.drho)
      in(force, MovingSolids{around.owner, around.drho, around.gain}, region);
    else if (around.owner)
      in(force, Solids{around.owner}, region);
    else
      in(force, NoSolids{}, region);
  }

  template <class Force, class Solid>
  void in(const Force &force, const Solid &solid, const Region &region) const
  {
    if (collision_.is_regularised)
      by(collision_.regularised, force, solid, region);
    else
      by(collision_.trt, force, solid, region);
  }

  // never inlined: the loop is then as good whatever is around it
  template <class Rule, class Force, class Solid>
  __attribute__((noinline)) void by(const Rule &rule, const Force &force, const Solid &solid,
                                    const Region &region) const
  {
    lbm::sweep(block_, rule, force, solid, region);
  }
};

}    // namespace lbm
#endif
