// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_solver.h"

#include "lbm_halo.h"
#include "lbm_sweep.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace lbm {
namespace {

  Motion most(const std::vector<Sphere> &spheres)
  {
    Motion most = Motion::REST;
    for (const Sphere &s : spheres) {
      if (s.spin != Vec3{}) return Motion::TURN;
      if (s.velocity != Vec3{}) most = Motion::SHIFT;
    }
    return most;
  }

  template <class L> class FluidOn : public Fluid {
   public:
    FluidOn(const Settings &settings, const Layout &at, const Int3 &global,
            Neighbours &neighbours) :
        settings(settings),
        at(at), lattice{global, {}}, block(at), halo(at, neighbours),
        pass(at, settings.link, settings.ledger, settings.tile), neighbours(neighbours),
        collide(settings.bgk ? Trt<L>::bgk(settings.tau)
                             : Trt<L>::trt(settings.tau, settings.magic))
    {
      for (int d = 0; d < 3; d++) {
        lattice.periodic[d] = d < L::D && settings.faces[d][0].kind == FaceKind::PERIODIC;
        at_end[d][0] = at.lo[d] == 0 && settings.faces[d][0].kind != FaceKind::PERIODIC;
        at_end[d][1] =
            at.lo[d] + at.n[d] == global[d] && settings.faces[d][1].kind != FaceKind::PERIODIC;
        for (Face &face : this->settings.faces[d])
          for (int t = 0; t < L::D; t++)
            if (face.parabolic && between_walls(t)) face.across[t] = global[t];
      }
    }

    std::vector<ShapeReview> set_obstacles(const std::vector<Shape> &shapes) override
    {
      if (shapes.empty()) return {};
      solids = std::make_unique<Obstacles>(find_obstacles(shapes));
      states.assign(shapes.size(), {});
      now = nullptr;
      provide(now);
      now->place(with_obstacles({}));
      return over_all(solids->reviews());
    }
    std::vector<ShapeReview> review(const std::vector<Shape> &shapes) override
    {
      return over_all(find_obstacles(shapes).reviews());
    }
    const std::vector<ObstacleState> &obstacles() const override { return states; }
    void resume_obstacles(const std::vector<ObstacleState> &from) override { states = from; }

    void follow(const std::vector<Sphere> &spheres) override
    {
      if (solids)
        follow_bodies(with_obstacles(spheres));
      else
        follow_bodies(spheres);
    }

    void follow_bodies(const std::vector<Sphere> &spheres)
    {
      if (!now && spheres.empty()) {
        refill_uncovered();
        return;
      }
      provide(now);
      // another order of a list that was taken over is no motion
      if (block.step() == 0 && same_but_for_order(now->spheres(), spheres)) now->place(spheres);
      moved = !now->same_places(spheres);
      if (moved) {
        // a scene at rest, but for obstacles, needs no former cover
        if (before || now->spheres().size() > states.size()) {
          provide(before);
          std::swap(before, now);
        }
        now->place(spheres);
      } else {
        now->set_velocities(spheres);
      }
      refill_uncovered();
      motion = most(spheres);
    }

    void advance(std::vector<Load> &loads) override
    {
      loads.assign(now ? now->spheres().size() : 0, Load{});
      if (spheres_here())
        collide_stream_and_bounce(loads);
      else
        collide_and_stream(at.all());
      halo.exchange(block);
      block.advance();
      bounce_at_walls<L>(at, block.slots(), settings.faces, at_end);
      if (spheres_here()) {
        pass.outermost(block.slots());
        pass.fill_pockets(block.slots(), force);
      }
      open_faces();
      find_responses();
      if (solids) take_from_obstacles(loads);
    }
    const std::vector<Response> &responses() const override { return responses_; }
    const std::vector<Sphere> &spheres() const override
    {
      static const std::vector<Sphere> none;
      return now ? now->spheres() : none;
    }
    void correct(const std::vector<Gain> &gains) override
    {
      if (spheres_here()) pass.correct(block.slots(), gains);
    }

    void set_force(const Vec3 &f) override { force = f; }
    void set_face(int d, int side, const Vec3 &u, double drho) override
    {
      settings.faces[d][side].u = u;
      settings.faces[d][side].drho = drho;
    }
    void fill(double drho) override
    {
      for (int z = 0; z < at.n[2]; z++)
        for (int y = 0; y < at.n[1]; y++)
          for (int x = 0; x < at.n[0]; x++) set_equilibrium(x, y, z, {drho, {}});
    }

    Moments moments(int x, int y, int z) const override
    {
      return lbm::moments<L>(block.slots(), at.index(x, y, z), force);
    }
    void set_equilibrium(int x, int y, int z, const Moments &m) override
    {
      const Slots<L> f = block.slots();
      for (int i = 0; i < L::Q; i++)
        f[i][at.index(x, y, z)] = typename L::Real(bare_equilibrium<L>(i, m, force));
    }
    bool solid(int x, int y, int z) const override
    {
      return now && now->owner()[at.index(x, y, z)] >= 0;
    }
    Survey survey() const override { return lbm::survey<L>(at, block.slots(), owner(), force); }
    Planes planes(int axis, int n) const override
    {
      return lbm::planes<L>(at, block.slots(), owner(), force, axis, n);
    }

    int directions() const override { return L::Q; }
    int bytes_of_population() const override { return sizeof(typename L::Real); }
    void give(const Part &part, void *to) const override
    {
      lbm::give<L>(at, block.slots(), part, static_cast<typename L::Real *>(to));
    }
    void take(const Part &part, const void *from) override
    {
      lbm::take<L>(at, block.slots(), part, static_cast<const typename L::Real *>(from));
    }
    std::uint64_t checksum() const override
    {
      return lbm::checksum<L>(at, block.slots(), lattice.n);
    }
    std::vector<Sphere> own_spheres() const override
    {
      if (!now) return {};
      auto spheres = now->spheres();
      spheres.resize(spheres.size() - states.size());
      return centred_here(spheres, at, lattice);
    }
    void resume(const std::vector<Sphere> &grains, const Counts &so_far) override
    {
      counts = so_far;
      const auto spheres = reaching_here(grains, at, lattice);
      if (spheres.empty()) return;
      provide(now);
      now->place(solids ? with_obstacles(spheres) : spheres);
      pass.recall(*now);
    }

    const Layout &layout() const override { return at; }
    double links() const override
    {
      if (block.step() == 0) return counts.links;
      return spheres_here() ? pass.links() : 0.0;
    }
    double gaps() const override
    {
      if (block.step() == 0) return counts.gaps;
      return spheres_here() ? pass.gaps() : 0.0;
    }
    const RefillCount &refilled() const override { return counts.refilled; }
    double bytes() const override
    {
      return block.bytes() + (now ? now->bytes() : 0.0) + (before ? before->bytes() : 0.0) +
          double(drho.capacity() * sizeof(float)) + pass.bytes() + (solids ? solids->bytes() : 0.0);
    }

   private:
    Settings settings;
    Layout at;
    Lattice lattice;
    Block<L> block;
    Halo<L> halo;
    LinkPass<L> pass;
    Neighbours &neighbours;
    Trt<L> collide;
    Vec3 force{};
    AtEnd at_end;

    // nothing of this exists without obstacles; states are the same on all ranks
    std::unique_ptr<Obstacles> solids;
    std::vector<ObstacleState> states;

    // spheres: nothing of this exists before the first one comes
    std::unique_ptr<Cover> now, before;
    bool moved = false;
    Motion motion = Motion::REST;
    std::vector<Response> responses_;
    std::vector<float> drho;    // density excess by node, for the wall term of moving surfaces
    Counts counts;              // of links and gaps those of a step made elsewhere

    void provide(std::unique_ptr<Cover> &cover) const
    {
      if (!cover) cover = std::make_unique<Cover>(at, L::D, sides(), solids.get());
    }

    Obstacles find_obstacles(const std::vector<Shape> &shapes) const
    {
      const auto behind = sides();
      Place place{lattice.n, lattice.periodic, {}, {}};
      for (int d = 0; d < 3; d++) {
        place.lo[d] = behind[d][0] == Cover::NEIGHBOUR ? -at.ghost[d] : 0;
        place.hi[d] = at.n[d] - 1 + (behind[d][1] == Cover::NEIGHBOUR ? at.ghost[d] : 0);
      }
      return Obstacles::find<L>(at, place, shapes);
    }

    std::vector<ShapeReview> over_all(std::vector<ShapeReview> reviews)
    {
      reduce(reviews, neighbours);
      return reviews;
    }

    std::vector<Sphere> with_obstacles(std::vector<Sphere> spheres) const
    {
      for (int k = 0; k < solids->count(); k++) {
        spheres.push_back(solids->body(k));
        spheres.back().drho = states[k].last.drho();
        if (settings.ledger)
          spheres.back().refund =
              refund(states[k].last.swallowed, states[k].before.swallowed, states[k].last.area);
      }
      return spheres;
    }

    // collective: what they got here is the end of the list
    void take_from_obstacles(std::vector<Load> &loads)
    {
      static_assert(sizeof(Load) == 9 * sizeof(double), "sums are numbers alone");
      const std::size_t grains = loads.size() - states.size();
      std::vector<double> sums(9 * states.size());
      std::memcpy(sums.data(), &loads[grains], sums.size() * sizeof(double));
      neighbours.sum(sums.data(), int(sums.size()));
      for (std::size_t k = 0; k < states.size(); k++) {
        states[k].before = states[k].last;
        std::memcpy(static_cast<void *>(&states[k].last), &sums[9 * k], sizeof(Load));
        states[k].steps += 1.0;
      }
      loads.resize(grains);
      if (!responses_.empty()) responses_.resize(grains);
    }

    const int32_t *owner() const { return now ? now->owner() : nullptr; }
    bool spheres_here() const { return now && !now->spheres().empty(); }

    bool between_walls(int d) const
    {
      const auto &face = settings.faces[d];
      return face[0].kind == FaceKind::WALL && face[1].kind == FaceKind::WALL;
    }
    Cover::Sides sides() const
    {
      Cover::Sides s;
      for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
          s[d][side] = !at_end[d][side]        ? Cover::NEIGHBOUR
              : settings.faces[d][side].open() ? Cover::OPEN
                                               : Cover::WALL;
      return s;
    }

    template <class Force> void sweep_with(const Force &f, const Region &region)
    {
      if (!spheres_here())
        sweep_nodes(f, NoSolids{}, region);
      else if (motion == Motion::REST)
        sweep_nodes(f, Solids{owner()}, region);
      else
        sweep_nodes(f, MovingSolids{owner(), drho.data()}, region);
    }

    // never inlined: the loop is then as good whatever is around it
    template <class Force, class Solid>
    __attribute__((noinline)) void sweep_nodes(const Force &f, const Solid &solid,
                                               const Region &region)
    {
      sweep(block, collide, f, solid, region);
    }

    void collide_and_stream(const Region &region)
    {
      if (force == Vec3{})
        sweep_with(NoForce{}, region);
      else
        sweep_with(UniformForce{force}, region);
    }

    // the links of each tile while it is in the cache
    void collide_stream_and_bounce(std::vector<Load> &loads)
    {
      const bool moving = motion != Motion::REST;
      if (moving) drho.resize(at.size);
      pass.start(*now, moved, motion, moving ? drho.data() : nullptr, loads);
      for (std::size_t k = 0; k < pass.tiles().count(); k++) {
        collide_and_stream(pass.tiles().swept(k));
        pass.inner(k, block.slots(block.step() + 1));
      }
    }

    void find_responses()
    {
      responses_.clear();
      if (!spheres_here()) return;
      const auto &list = now->spheres();
      if (std::none_of(list.begin(), list.end(), [](const Sphere &s) {
            return s.yields;
          }))
        return;
      responses_.resize(list.size());
      pass.add_responses(responses_);
    }

    void open_faces()
    {
      for (int d = 0; d < L::D; d++)
        for (int side = 0; side < 2; side++)
          if (at_end[d][side] && settings.faces[d][side].open())
            open_face<L>(at, block.slots(), d, side, settings.faces[d][side], settings.faces,
                         at_end, owner(), force);
    }

    void refill_uncovered()
    {
      std::vector<Uncovered> nodes;
      if (moved && before) nodes = find_uncovered(at, *before, *now);
      double any = nodes.empty() ? 0.0 : 1.0;
      neighbours.max(&any, 1);
      if (any == 0.0) return;
      provide(now);    // a rank without any may have to answer the others' questions
      provide(before);
      switch (settings.refill) {
        case RefillRule::GRAD:
          return refill_with<RefillRule::GRAD>(nodes);
        case RefillRule::NORMAL:
          return refill_with<RefillRule::NORMAL>(nodes);
        case RefillRule::LOCAL:
          return refill_with<RefillRule::LOCAL>(nodes);
        case RefillRule::EQUILIBRIUM:
          return refill_equilibrium<L>(block.slots(), *before, nodes, mean_density_excess(), force,
                                       counts.refilled);
      }
    }

    template <RefillRule rule> void refill_with(const std::vector<Uncovered> &nodes)
    {
      refill_local<L, rule>(at, block.slots(), *before, *now, nodes, settings.tau, force,
                            neighbours, counts.refilled);
    }

    // of the whole system, over the nodes that were fluid in the last step
    double mean_density_excess()
    {
      const Cover &last = moved && before ? *before : *now;
      const Survey s = lbm::survey<L>(at, block.slots(), last.owner(), force);
      double sums[] = {s.mass - s.fluid_nodes, s.fluid_nodes};
      neighbours.sum(sums, 2);
      return sums[1] > 0.0 ? sums[0] / sums[1] : 0.0;
    }
  };

  template <class L>
  std::unique_ptr<Fluid> in_precision(const Settings &settings, const Layout &at,
                                      const Int3 &global, Neighbours &neighbours)
  {
    if (settings.single)
      return std::make_unique<FluidOn<InSingle<L>>>(settings, at, global, neighbours);
    return std::make_unique<FluidOn<L>>(settings, at, global, neighbours);
  }

}    // namespace

std::unique_ptr<Fluid> Fluid::create(const Settings &settings, const Int3 &lo, const Int3 &n,
                                     const Int3 &global, Neighbours &neighbours)
{
  if (!(settings.tau > 0.5)) throw std::invalid_argument("tau must be larger than 1/2");
  for (int d = 0; d < 3; d++)
    if (n[d] < 1) throw std::invalid_argument("a rank without lattice nodes");
  const Layout at(lo, n, settings.dimension);
  if (at.size > Index(std::numeric_limits<int32_t>::max()))    // links hold indices of nodes
    throw std::invalid_argument("more than 2^31 lattice nodes on one rank");
  if (settings.dimension == 2) return in_precision<D2Q9>(settings, at, global, neighbours);
  return in_precision<D3Q19>(settings, at, global, neighbours);
}

}    // namespace lbm
