// SPDX-License-Identifier: GPL-2.0-only
// The fluid of one rank, and its step. Lattice units; knows spheres, not atoms.
//
// A step of the coupled system:
//     follow(spheres)   cover and links follow the spheres, uncovered nodes are refilled
//     advance(loads)    sweep, halo, walls, links bounce back and give momentum, open faces
// The choice of lattice, rules and forces is made once, in create(), or per step by what is there:
// no node pays for what its scene does not contain.

#ifndef LBM_SOLVER_H
#define LBM_SOLVER_H

#include "lbm_face.h"
#include "lbm_ledger.h"
#include "lbm_link_pass.h"
#include "lbm_monitor.h"
#include "lbm_neighbours.h"
#include "lbm_obstacle.h"
#include "lbm_profile.h"
#include "lbm_refill.h"
#include "lbm_state.h"

#include <memory>

namespace lbm {

struct Settings {
  int dimension = 3;
  bool single = false;          // populations in single precision
  double tau = 0.8;             // relaxation time of the viscosity, > 1/2
  bool bgk = false;             // else two relaxation times
  bool regularised = false;     // neither of them: the regularised rule
  double magic = 3.0 / 16.0;    // Lambda = (tau+ - 1/2)(tau- - 1/2)
  LinkRule link = LinkRule::CLI;
  RefillRule refill = RefillRule::GRAD;
  bool ledger = true;    // of the mass that links swallow, to be given back; else none is
  // keep the mean density of the fluid while spheres move in a box without open faces; needs ledger
  bool hold_mean = false;
  Int3 tile{};    // nodes swept before their links; 0: by the size of the cache
  Faces faces;    // of the whole box
};

class Fluid {
 public:
  // lo, n: the nodes of this rank; global: of the whole lattice. Throws std::bad_alloc, or
  // std::invalid_argument if tau <= 1/2, a block is empty, or it has more than 2^31 nodes.
  static std::unique_ptr<Fluid> create(const Settings &settings, const Int3 &lo, const Int3 &n,
                                       const Int3 &global, Neighbours &neighbours);
  virtual ~Fluid() = default;

  // Solids that are not spheres, before the first follow(); what such shapes would be. Collective.
  virtual std::vector<ShapeReview> set_obstacles(const std::vector<Shape> &shapes) = 0;
  virtual std::vector<ShapeReview> review(const std::vector<Shape> &shapes) = 0;
  // what each got, summed over ranks; the next step depends on it
  virtual const std::vector<ObstacleState> &obstacles() const = 0;
  virtual void resume_obstacles(const std::vector<ObstacleState> &states) = 0;

  // Spheres that reach this rank's nodes or ghosts, periodic images among them. Collective.
  virtual void follow(const std::vector<Sphere> &spheres) = 0;
  // One step. loads[s] is the momentum that sphere s of the last follow() got through links of this
  // rank's nodes: to be summed over ranks and images. Collective.
  virtual void advance(std::vector<Load> &loads) = 0;
  // of the spheres of the last follow() if any of them yields, else empty; to be summed as loads
  virtual const std::vector<Response> &responses() const = 0;
  // of the last follow() or resume(), obstacles after them
  virtual const std::vector<Sphere> &spheres() const = 0;
  // Before the next follow(): by how much they were faster than handed in, by sphere of the last.
  virtual void correct(const std::vector<Gain> &gains) = 0;

  // force density on the fluid, and values at the faces, from the next step on
  virtual void set_force(const Vec3 &force) = 0;
  virtual void set_face(int d, int side, const Vec3 &u, double drho) = 0;
  // fluid at rest at this density everywhere
  virtual void fill(double drho) = 0;

  // x, y, z count from the first node of this rank
  virtual Moments moments(int x, int y, int z) const = 0;
  virtual void set_equilibrium(int x, int y, int z, const Moments &m) = 0;
  virtual bool solid(int x, int y, int z) const = 0;
  virtual Survey survey() const = 0;    // of this rank, see reduce()
  // of this rank, by the n planes of the whole lattice across an axis, see reduce()
  virtual Planes planes(int axis, int n) const = 0;

  // State in the form of lbm_state.h, for restarts and new cuts of the lattice. A fluid that is to
  // go on from it has made no step yet, and follows spheres only afterwards.
  virtual int directions() const = 0;    // populations of a node
  virtual int bytes_of_population() const = 0;
  virtual void give(const Part &part, void *to) const = 0;    // of this rank's nodes
  virtual void take(const Part &part, const void *from) = 0;
  virtual std::uint64_t checksum() const = 0;    // of this rank's nodes
  virtual std::vector<Sphere> own_spheres() const = 0;
  // every grain of the last step, and what this rank had counted
  virtual void resume(const std::vector<Sphere> &grains, const Counts &counts) = 0;

  virtual const Layout &layout() const = 0;
  virtual double links() const = 0;    // of this rank in the last step, gaps included
  virtual double gaps() const = 0;     // pairs closed in a gap of one node
  // Of all ranks, since the start; without a ledger of links theirs are left out. Collective.
  virtual Ledger ledger() const = 0;
  virtual const MeanDensity &mean_density() const = 0;    // on all ranks alike

  // Now and then: finds fluid that is enclosed, whose density is kept from then on, see
  // lbm_enclosed.h; in single precision the mean density is measured anew. Collective.
  virtual void inspect() = 0;
  // Before its state is given away: as the fluid that goes on from it will be. Collective.
  virtual void settle() = 0;
  // of all ranks, when last inspected
  virtual double enclosed_sets() const = 0;
  virtual double enclosed_nodes() const = 0;
  virtual const RefillCount &refilled() const = 0;
  virtual double bytes() const = 0;    // memory held
};

}    // namespace lbm
#endif
