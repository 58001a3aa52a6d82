// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_solver.h"

#include "lbm_bodies.h"
#include "lbm_enclosed.h"
#include "lbm_halo.h"
#include "lbm_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lbm {
namespace {

  Motion most(const std::vector<Sphere> &spheres)
  {
    Motion most = Motion::REST;
    for (const Sphere &s : spheres) {
      if (s.spin != Vec3{} || s.yields) return Motion::TURN;
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
        pass(at, settings.link, settings.ledger, settings.tile), enclosed(at),
        neighbours(neighbours), collide(settings.bgk ? Trt<L>::bgk(settings.tau)
                                                     : Trt<L>::trt(settings.tau, settings.magic)),
        regularised(Regularised<L>::with(settings.tau))
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
      solids = std::make_unique<Bodies>(find_obstacles(shapes));
      now = nullptr;
      provide(now);
      now->place(solids->after({}, settings.ledger));
      const auto lost = covered_nodes();
      covered = Index(lost.size());
      book.covered += double(covered);
      book.excess[Ledger::COVERED] -= excess_in<L>(block.slots(), lost);
      return over_all(solids->obstacles().reviews());
    }
    std::vector<ShapeReview> review(const std::vector<Shape> &shapes) override
    {
      return over_all(find_obstacles(shapes).reviews());
    }
    const std::vector<ObstacleState> &obstacles() const override
    {
      static const std::vector<ObstacleState> none;
      return solids ? solids->states() : none;
    }
    void resume_obstacles(const std::vector<ObstacleState> &from) override
    {
      if (solids) solids->resume(from);
    }

    void follow(const std::vector<Sphere> &spheres) override
    {
      if (solids)
        follow_bodies(solids->after(spheres, settings.ledger));
      else
        follow_bodies(spheres);
    }

    void follow_bodies(const std::vector<Sphere> &spheres)
    {
      if (!now && spheres.empty()) {
        change_nodes();
        return;
      }
      provide(now);
      // another order of a list that was taken over is no motion
      if (block.step() == 0 && same_but_for_order(now->spheres(), spheres)) now->place(spheres);
      moved = !now->same_places(spheres);
      if (moved) {
        // a scene at rest, but for obstacles, needs no former cover
        if (before || now->spheres().size() > obstacles().size()) {
          provide(before);
          std::swap(before, now);
        }
        now->place(spheres);
      } else {
        now->set_velocities(spheres);
      }
      motion = most(spheres);
      change_nodes();
    }

    void advance(std::vector<Load> &loads) override
    {
      loads.assign(now ? now->spheres().size() : 0, Load{});
      if (spheres_here())
        collide_stream_and_bounce(loads);
      else
        collide_and_stream(at.all());
      book.excess[Ledger::RESTORED] += gain * double(at.nodes() - covered);
      halo.exchange(block);
      block.advance();
      bounce_at_walls<L>(at, block.slots(), settings.faces, at_end);
      if (spheres_here()) {
        pass.outermost(block.slots());
        book.excess[Ledger::POCKETS] += pass.fill_pockets(block.slots(), force);
      }
      if (enclosed.holds_any()) {
        provide(now);
        book.excess[Ledger::POCKETS] += enclosed.hold(block.slots(), *now, neighbours);
      }
      open_faces();
      if (settings.ledger) book_links(loads);
      if (solids) solids->take(loads, neighbours);
    }
    const std::vector<Response> &responses() const override
    {
      static const std::vector<Response> none;
      return spheres_here() ? pass.responses() : none;
    }
    const std::vector<Sphere> &spheres() const override
    {
      static const std::vector<Sphere> none;
      return now ? now->spheres() : none;
    }
    void correct(const std::vector<Gain> &gains) override
    {
      if (!spheres_here()) return;
      const Taken taken = pass.correct(block.slots(), gains);
      if (!settings.ledger) return;
      book.excess[Ledger::DISPLACED] -= taken.displaced;
      book.excess[Ledger::SWALLOWED] -= taken.swallowed;
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
      spheres.resize(spheres.size() - obstacles().size());
      return centred_here(spheres, at, lattice);
    }
    void resume(const std::vector<Sphere> &grains, const Counts &so_far) override
    {
      counts = so_far;
      book = {};    // obstacles are in the ledger already
      const auto spheres = reaching_here(grains, at, lattice);
      if (spheres.empty()) return;
      provide(now);
      now->place(solids ? solids->after(spheres, settings.ledger) : spheres);
      covered = Index(covered_nodes().size());
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
    Ledger ledger() const override
    {
      auto sums = book.numbers();
      neighbours.sum(sums.data(), int(sums.size()));
      Ledger all = counts.ledger;
      all.add(sums.data());
      return all;
    }
    const MeanDensity &mean_density() const override { return counts.mean; }
    void inspect() override
    {
      find_enclosed();
      if (settings.single && counts.mean.known > 0.0) {
        const Survey s = whole();
        counts.mean.start = s.mass - s.fluid_nodes - ledger().total_excess();
      }
    }
    void settle() override
    {
      counts.ledger = ledger();
      book = {};
      find_enclosed();
    }
    double enclosed_sets() const override { return enclosed.sets(); }
    double enclosed_nodes() const override { return enclosed.nodes(); }
    const RefillCount &refilled() const override { return counts.refilled; }
    double bytes() const override
    {
      return block.bytes() + (now ? now->bytes() : 0.0) + (before ? before->bytes() : 0.0) +
          double(drho.capacity() * sizeof(float)) + pass.bytes() + enclosed.bytes() +
          (solids ? solids->bytes() : 0.0);
    }

   private:
    Settings settings;
    Layout at;
    Lattice lattice;
    Block<L> block;
    Halo<L> halo;
    LinkPass<L> pass;
    Enclosed<L> enclosed;
    Neighbours &neighbours;
    Trt<L> collide;
    Regularised<L> regularised;
    Vec3 force{};
    AtEnd at_end;

    std::unique_ptr<Bodies> solids;    // obstacles, if there are any

    // spheres: nothing of this exists before the first one comes
    std::unique_ptr<Cover> now, before;
    bool moved = false, changed_since = true;    // since the last step; since inspect()
    Motion motion = Motion::REST;
    std::vector<float> drho;    // density excess by node, for the wall term of moving surfaces
    Counts counts;              // of links and gaps those of a step made elsewhere
    Ledger book;                // of this rank, what is not in counts yet
    Index covered = 0;          // nodes of this rank
    double gain = 0.0;          // of each fluid node in the next sweep, on all ranks alike

    void provide(std::unique_ptr<Cover> &cover) const
    {
      if (!cover)
        cover = std::make_unique<Cover>(at, L::D, sides(), solids ? &solids->obstacles() : nullptr);
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
      if (motion != Motion::REST || gain != 0.0)
        sweep_nodes(f, MovingSolids{owner(), drho.data(), gain}, region);
      else if (spheres_here())
        sweep_nodes(f, Solids{owner()}, region);
      else
        sweep_nodes(f, NoSolids{}, region);
    }

    template <class Force, class Solid>
    void sweep_nodes(const Force &f, const Solid &solid, const Region &region)
    {
      if (settings.regularised)
        sweep_by(regularised, f, solid, region);
      else
        sweep_by(collide, f, solid, region);
    }

    // never inlined: the loop is then as good whatever is around it
    template <class Collision, class Force, class Solid>
    __attribute__((noinline)) void sweep_by(const Collision &rule, const Force &f,
                                            const Solid &solid, const Region &region)
    {
      sweep(block, rule, f, solid, region);
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
      pass.start(*now, moved, motion, moving ? drho.data() : nullptr, loads);
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
            book.excess[Ledger::FACES + 2 * d + side] +=
                open_face<L>(at, block.slots(), d, side, settings.faces[d][side], settings.faces,
                             at_end, owner(), force);
    }

    void book_links(const std::vector<Load> &loads)
    {
      for (std::size_t s = 0; s < loads.size(); s++) {
        book.excess[Ledger::SWALLOWED] -= loads[s].swallowed;
        book.excess[Ledger::DISPLACED] += loads[s].displaced;
        book.excess[Ledger::RETURNED] += 0.5 * spheres()[s].refund * loads[s].area;
      }
    }

    void find_enclosed()
    {
      double any[2] = {spheres_here() ? 1.0 : 0.0, changed_since ? 1.0 : 0.0};
      neighbours.max(any, 2);
      changed_since = false;
      if (any[0] == 0.0) {
        enclosed.forget();
      } else if (any[1] > 0.0) {
        provide(now);
        enclosed.find(*now, lattice.n, neighbours);
      }
    }

    // of this rank, of spheres and obstacles; a look at all nodes
    std::vector<Index> covered_nodes() const
    {
      std::vector<Index> list;
      for (int z = 0; z < at.n[2]; z++)
        for (int y = 0; y < at.n[1]; y++)
          for (int x = 0; x < at.n[0]; x++)
            if (solid(x, y, z)) list.push_back(at.index(x, y, z));
      return list;
    }

    // nodes become solid, and fluid
    void change_nodes()
    {
      std::vector<Uncovered> nodes;
      std::vector<Index> lost;
      if (moved) {
        changed_since = true;
        lost = find_covered(at, before.get(), *now);
        if (before) nodes = find_uncovered(at, *before, *now);
        covered += Index(lost.size()) - Index(nodes.size());
        // sums must not hang on the order of the spheres, which a restart may change
        std::sort(lost.begin(), lost.end());
        std::sort(nodes.begin(), nodes.end(), [](const Uncovered &a, const Uncovered &b) {
          return a.n < b.n;
        });
      }
      bool any = !nodes.empty(), any_moved = moved && before != nullptr;
      bool any_motion = any_moved || motion != Motion::REST;
      agree({&any, &any_moved, &any_motion});
      book.covered += double(lost.size());
      book.excess[Ledger::COVERED] -= excess_in<L>(block.slots(), lost);
      if (any) refill(nodes);
      gain = any_motion ? lost_by_each_node() : 0.0;
      if (!any_moved) gain = 0.0;    // surfaces that stay where they are lose no more than a refund
      if (motion != Motion::REST || gain != 0.0) {    // for MovingSolids
        provide(now);
        drho.resize(at.size);
      }
    }

    // one message for all that ranks have to know of each other
    void agree(const std::array<bool *, 3> &any)
    {
      const auto numbers = book.numbers();
      std::array<double, Ledger::SIZE + 3> sums;
      std::copy(numbers.begin(), numbers.end(), sums.begin());
      for (std::size_t k = 0; k < any.size(); k++) sums[Ledger::SIZE + k] = *any[k];
      neighbours.sum(sums.data(), int(sums.size()));
      counts.ledger.add(sums.data());
      book = {};
      for (std::size_t k = 0; k < any.size(); k++) *any[k] = sums[Ledger::SIZE + k] > 0.0;
    }

    void refill(const std::vector<Uncovered> &nodes)
    {
      provide(now);    // a rank without any may have to answer the others' questions
      provide(before);
      book.uncovered += double(nodes.size());
      book.excess[Ledger::REFILLED] += settings.refill == RefillRule::EQUILIBRIUM
          ? refill_equilibrium<L>(block.slots(), *before, nodes, mean_density_excess(), force,
                                  counts.refilled)
          : refill_local<L>(settings.refill, at, block.slots(), *before, *now, nodes, settings.tau,
                            force, neighbours, counts.refilled);
    }

    // What the mean density had lost comes back with the next sweep, evenly: no force comes of it.
    // No more than a scene that is well could need: where one node blows up, the others must not.
    static constexpr double GAIN_MAX = 1e-3;
    double lost_by_each_node()
    {
      if (!settings.hold_mean || !settings.ledger || has_open_face()) return 0.0;
      const Ledger &sums = counts.ledger;
      const double nodes = double(lattice.n[0]) * lattice.n[1] * lattice.n[2] + sums.nodes();
      MeanDensity &mean = counts.mean;
      if (mean.known == 0.0) {
        const Survey s = whole();
        if (s.fluid_nodes == 0.0) return 0.0;
        const double excess = s.mass - s.fluid_nodes;
        mean = {1.0, excess - ledger().total_excess(), excess / s.fluid_nodes};
        return 0.0;
      }
      if (nodes <= 0.0) return 0.0;
      // as it was at the end of the last step: what surfaces displace, with them, in the next step
      // belongs to the nodes that they cover and uncover now
      const double lost = mean.excess - (mean.start + sums.total_excess()) / nodes;
      return std::isfinite(lost) ? std::clamp(lost, -GAIN_MAX, GAIN_MAX) : 0.0;
    }
    Survey whole() const
    {
      Survey s = survey();
      reduce(s, neighbours);
      return s;
    }
    bool has_open_face() const
    {
      for (const auto &pair : settings.faces)
        for (const Face &face : pair)
          if (face.open()) return true;
      return false;
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
