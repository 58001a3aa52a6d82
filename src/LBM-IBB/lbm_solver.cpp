// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_solver.h"

#include "lbm_accounts.h"
#include "lbm_covers.h"
#include "lbm_enclosed.h"
#include "lbm_halo.h"
#include "lbm_sweeps.h"

#include <limits>
#include <stdexcept>

namespace lbm {
namespace {

  template <class L> Collision<L> collision(const Settings &s)
  {
    return {s.bgk ? Trt<L>::bgk(s.tau) : Trt<L>::trt(s.tau, s.magic), Regularised<L>::with(s.tau),
            s.regularised};
  }

  template <class L> class FluidOn : public Fluid {
   public:
    FluidOn(const Settings &settings, const Layout &at, const Int3 &global, Neighbours &others) :
        settings(settings), at(at), at_end(ends(at, global, settings.faces)), lattice{global, {}},
        block(at), halo(at, others), sweeps(block, collision<L>(settings)),
        pass(at, settings.link, settings.ledger, settings.tile), enclosed(at), neighbours(others),
        covers(at, L::D, sides(at_end, settings.faces), settings.ledger),
        accounts(global, at.nodes(),
                 settings.hold_mean && settings.ledger && !any_open(settings.faces), others)
    {
      for (int d = 0; d < 3; d++) {
        lattice.periodic[d] = d < L::D && settings.faces[d][0].kind == FaceKind::PERIODIC;
        for (Face &face : this->settings.faces[d])
          for (int t = 0; t < L::D; t++)
            if (face.parabolic && between_walls(t)) face.across[t] = global[t];
      }
    }

    std::vector<ShapeReview> set_obstacles(const std::vector<Shape> &shapes) override
    {
      if (shapes.empty()) return {};
      covers.set_obstacles(find_obstacles(shapes));
      cover_nodes(covers.covered());
      return over_all(covers.bodies()->obstacles().reviews());
    }
    std::vector<ShapeReview> review(const std::vector<Shape> &shapes) override
    {
      return over_all(find_obstacles(shapes).reviews());
    }
    const std::vector<ObstacleState> &obstacles() const override { return covers.obstacles(); }
    void resume_obstacles(const std::vector<ObstacleState> &from) override
    {
      if (covers.bodies()) covers.bodies()->resume(from);
    }

    void follow(const std::vector<Sphere> &spheres) override
    {
      covers.follow(spheres, block.step() == 0);
      const auto [covered, uncovered] = covers.change();
      changed_since = changed_since || covers.moved();
      bool any = !uncovered.empty(), moved = covers.has_moved();
      bool motion = moved || covers.motion() != Motion::REST;
      accounts.agree({&any, &moved, &motion});
      cover_nodes(covered);
      if (any) refill(uncovered);
      accounts.restore(motion, moved, [&] {
        return whole();
      });
      if (keeps_density()) drho.resize(at.size);
    }

    void advance(std::vector<Load> &loads) override
    {
      loads.assign(spheres().size(), Load{});
      if (covers.any())
        collide_stream_and_bounce(loads);
      else
        collide_and_stream(at.all());
      accounts.restored();
      halo.exchange(block);
      block.advance();
      bounce_at_walls<L>(at, block.slots(), settings.faces, at_end);
      if (covers.any()) {
        pass.outermost(block.slots());
        accounts.book(Ledger::POCKETS, pass.fill_pockets(block.slots(), force));
      }
      if (enclosed.holds_any())
        accounts.book(Ledger::POCKETS, enclosed.hold(block.slots(), covers.now(), neighbours));
      open_faces();
      if (settings.ledger) accounts.bounce(loads, spheres());
      if (covers.bodies()) covers.bodies()->take(loads, neighbours);
    }
    const std::vector<Response> &responses() const override
    {
      static const std::vector<Response> none;
      return covers.any() ? pass.responses() : none;
    }
    const std::vector<Sphere> &spheres() const override { return covers.spheres(); }
    void correct(const std::vector<Gain> &gains) override
    {
      if (!covers.any()) return;
      const Taken taken = pass.correct(block.slots(), gains);
      if (!settings.ledger) return;
      accounts.book(Ledger::DISPLACED, -taken.displaced);
      accounts.book(Ledger::SWALLOWED, -taken.swallowed);
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
      return covers.owner() && covers.owner()[at.index(x, y, z)] >= 0;
    }
    Survey survey() const override { return survey_of(covers.owner()); }
    Planes planes(int axis, int n) const override
    {
      return lbm::planes<L>(at, block.slots(), covers.owner(), force, axis, n);
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
      return centred_here(covers.grains(), at, lattice);
    }
    void resume(const std::vector<Sphere> &grains, const Counts &so_far) override
    {
      counted = so_far;
      const auto reaching = reaching_here(grains, at, lattice);
      if (!reaching.empty()) {
        covers.place(reaching);
        pass.recall(covers.now());
      }
      accounts.resume(so_far.ledger, so_far.mean, Index(covers.covered().size()));
    }

    const Layout &layout() const override { return at; }
    double links() const override
    {
      if (block.step() == 0) return counted.links;
      return covers.any() ? pass.links() : 0.0;
    }
    double gaps() const override
    {
      if (block.step() == 0) return counted.gaps;
      return covers.any() ? pass.gaps() : 0.0;
    }
    Ledger ledger() const override { return accounts.all(); }
    const MeanDensity &mean_density() const override { return accounts.mean(); }
    void inspect() override
    {
      find_enclosed();
      if (settings.single && accounts.mean().known > 0.0)
        accounts.measure([&] {
          return whole();
        });
    }
    void settle() override
    {
      accounts.settle();
      find_enclosed();
    }
    double enclosed_sets() const override { return enclosed.sets(); }
    double enclosed_nodes() const override { return enclosed.nodes(); }
    const RefillCount &refilled() const override { return counted.refilled; }
    double bytes() const override
    {
      return block.bytes() + double(drho.capacity() * sizeof(float)) + covers.bytes() +
          pass.bytes() + enclosed.bytes();
    }

   private:
    Settings settings;
    Layout at;
    AtEnd at_end;
    Lattice lattice;
    Block<L> block;
    Halo<L> halo;
    Sweeps<L> sweeps;
    LinkPass<L> pass;
    Enclosed<L> enclosed;
    Neighbours &neighbours;
    Covers covers;
    Accounts accounts;
    Vec3 force{};
    std::vector<float> drho;      // density excess by node, for the wall term of moving surfaces
    bool changed_since = true;    // the cover, since inspect()
    Counts counted;               // of links and gaps those of a step made elsewhere

    Obstacles find_obstacles(const std::vector<Shape> &shapes) const
    {
      const auto behind = sides(at_end, settings.faces);
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

    bool between_walls(int d) const
    {
      const auto &face = settings.faces[d];
      return face[0].kind == FaceKind::WALL && face[1].kind == FaceKind::WALL;
    }

    // of each node, in the next sweep
    bool keeps_density() const { return covers.motion() != Motion::REST || accounts.gain() != 0.0; }
    void collide_and_stream(const Region &region)
    {
      if (keeps_density())
        sweeps.sweep({force, covers.now().owner(), drho.data(), accounts.gain()}, region);
      else
        sweeps.sweep({force, covers.any() ? covers.owner() : nullptr, nullptr, 0.0}, region);
    }

    // the links of each tile while it is in the cache
    void collide_stream_and_bounce(std::vector<Load> &loads)
    {
      const Motion motion = covers.motion();
      pass.start(covers.now(), covers.moved(), motion,
                 motion != Motion::REST ? drho.data() : nullptr, loads);
      for (std::size_t k = 0; k < pass.tiles().count(); k++) {
        collide_and_stream(pass.tiles().swept(k));
        pass.inner(k, block.slots(block.step() + 1));
      }
    }

    void open_faces()
    {
      for (int d = 0; d < L::D; d++)
        for (int side = 0; side < 2; side++)
          if (at_end[d][side] && settings.faces[d][side].open())
            accounts.book(Ledger::FACES + 2 * d + side,
                          open_face<L>(at, block.slots(), d, side, settings.faces[d][side],
                                       settings.faces, at_end, covers.owner(), force));
    }

    void find_enclosed()
    {
      double any[2] = {covers.any() ? 1.0 : 0.0, changed_since ? 1.0 : 0.0};
      neighbours.max(any, 2);
      changed_since = false;
      if (any[0] == 0.0)
        enclosed.forget();
      else if (any[1] > 0.0)
        enclosed.find(covers.now(), lattice.n, neighbours);
    }

    void cover_nodes(const std::vector<Index> &nodes)
    {
      accounts.cover(Index(nodes.size()), excess_in<L>(block.slots(), nodes));
    }

    // a rank without any may have to answer the others' questions
    void refill(const std::vector<Uncovered> &nodes)
    {
      const Slots<L> f = block.slots();
      const Cover &before = covers.before(), &now = covers.now();
      const double excess = settings.refill == RefillRule::EQUILIBRIUM
          ? refill_equilibrium<L>(f, before, nodes, mean_density_excess(), force, counted.refilled)
          : refill_local<L>(settings.refill, at, f, before, now, nodes, settings.tau, force,
                            neighbours, counted.refilled);
      accounts.uncover(Index(nodes.size()), excess);
    }

    Survey survey_of(const int32_t *owner) const
    {
      return lbm::survey<L>(at, block.slots(), owner, force);
    }
    Survey whole() const
    {
      Survey s = survey();
      reduce(s, neighbours);
      return s;
    }
    // of the whole system, over the nodes that were fluid in the last step
    double mean_density_excess()
    {
      const Survey s = survey_of(covers.has_moved() ? covers.before().owner() : covers.owner());
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
