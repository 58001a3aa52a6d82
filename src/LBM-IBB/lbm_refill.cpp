// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_refill.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace lbm {
namespace {

  // u_s at the node, just before it leaves the solid
  Vec3 solid_velocity(const Cover &before, const Uncovered &node)
  {
    const Vec3 c = before.centre(node.sphere);
    const Vec3 arm{node.p[0] - c[0], node.p[1] - c[1], node.p[2] - c[2]};
    return before.spheres()[node.sphere].velocity_at(arm);
  }

  // What a node holds: its moments, and if wanted its populations beyond equilibrium
  template <class L, RefillRule rule> struct Held {
    static constexpr int EXTRA = rule == RefillRule::NORMAL ? L::Q : 0, SIZE = 4 + EXTRA;
    Moments m{};
    std::array<double, EXTRA> beyond{};
    void read(const Slots<L> &f, Index n, const Vec3 &force)
    {
      m = moments<L>(f, n, force);
      for (int i = 0; i < EXTRA; i++) beyond[i] = f[i][n] - bare_equilibrium<L>(i, m, force);
    }
    void append_to(std::vector<double> &list) const
    {
      list.insert(list.end(), {m.drho, m.u[0], m.u[1], m.u[2]});
      list.insert(list.end(), beyond.begin(), beyond.end());
    }
    void take(const double *list)
    {
      m = {list[0], {list[1], list[2], list[3]}};
      std::copy_n(list + 4, EXTRA, beyond.begin());
    }
  };

  // Nodes next to uncovered ones, those beyond a face of the block got from the neighbour there
  template <class L, RefillRule rule> class Around {
   public:
    struct Sample : Held<L, rule> {
      bool known = false;
    };

    Around(const Layout &at, const Slots<L> &f, const Cover &before, const Cover &now,
           const Vec3 &force, Neighbours &neighbours) :
        at(at),
        f(f), before(before), now(now), force(force), neighbours(neighbours)
    {
    }

    // samples[2 d + side] of each node: its neighbours along the axes
    std::vector<std::array<Sample, 6>> collect(const std::vector<Uncovered> &nodes)
    {
      std::vector<std::array<Sample, 6>> samples(nodes.size());
      for (int d = 0; d < L::D; d++)
        for (int side = 0; side < 2; side++) {
          std::vector<double> wanted;
          std::vector<Sample *> answers;
          for (std::size_t k = 0; k < nodes.size(); k++) {
            Int3 p = nodes[k].p;
            p[d] += side == 0 ? -1 : 1;
            Sample &s = samples[k][2 * d + side];
            s.known = was_and_is_fluid(p);
            if (!s.known) continue;
            if (at.owned(p[0], p[1], p[2])) {
              s.read(f, at.index(p[0], p[1], p[2]), force);
            } else {
              const int a = (d + 1) % 3, b = (d + 2) % 3;
              wanted.push_back(p[a] + double(p[b]) * at.n[a]);
              answers.push_back(&s);
            }
          }
          ask(d, side, wanted, answers);
        }
      return samples;
    }

   private:
    const Layout &at;
    const Slots<L> &f;
    const Cover &before, &now;
    const Vec3 force;
    Neighbours &neighbours;

    bool was_and_is_fluid(const Int3 &p) const
    {
      const Index n = at.index(p[0], p[1], p[2]);
      return now.inside(p[0], p[1], p[2]) && before.owner()[n] < 0 && now.owner()[n] < 0;
    }

    // The neighbour on this side looks up the nodes of its boundary layer that are asked for.
    // Blocks that meet in a face have the same extent along the other directions: a node is named
    // by them.
    void ask(int d, int side, const std::vector<double> &wanted,
             const std::vector<Sample *> &answers)
    {
      const double nwanted = double(wanted.size());
      double nasked = 0.0;
      neighbours.shift(d, side, &nwanted, 1, &nasked, 1);
      std::vector<double> asked(std::size_t(nasked), 0.0);
      neighbours.shift(d, side, wanted.data(), wanted.size(), asked.data(), asked.size());

      std::vector<double> reply, answer(Sample::SIZE * wanted.size());
      const int a = (d + 1) % 3, b = (d + 2) % 3;
      for (double name : asked) {
        Int3 p;
        p[a] = int(Index(name) % at.n[a]);
        p[b] = int(Index(name) / at.n[a]);
        p[d] = side == 0 ? at.n[d] - 1 : 0;
        Held<L, rule> held;
        held.read(f, at.index(p[0], p[1], p[2]), force);
        held.append_to(reply);
      }
      neighbours.shift(d, 1 - side, reply.data(), reply.size(), answer.data(), answer.size());
      for (std::size_t k = 0; k < answers.size(); k++) answers[k]->take(&answer[Sample::SIZE * k]);
    }
  };

  // 4.5 w rho P:(ee - I/3),  P = -(tau/3) (grad u + grad u^T), where the node has moments m
  template <class L, class Samples>
  std::array<double, L::Q> by_gradient(const Samples &samples, const Moments &m, double tau)
  {
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();    // (a, b) = d u_a / d x_b
    for (int b = 0; b < L::D; b++) {
      const auto &lo = samples[2 * b], &hi = samples[2 * b + 1];
      for (int a = 0; a < L::D; a++) {
        const double below = lo.known ? lo.m.u[a] : m.u[a], above = hi.known ? hi.m.u[a] : m.u[a];
        gradient(a, b) = (above - below) / (lo.known && hi.known ? 2.0 : 1.0);
      }
    }
    const Eigen::Matrix3d P = -tau / 3.0 * (gradient + gradient.transpose());
    std::array<double, L::Q> beyond{};
    for (int i = 0; i < L::Q; i++) {
      const Eigen::Vector3d e(L::e[i][0], L::e[i][1], L::e[i][2]);
      beyond[i] = 4.5 * L::w[i] * (1.0 + m.drho) * (e.dot(P * e) - P.trace() / 3.0);
    }
    return beyond;
  }

  // of the fluid neighbour along the axis nearest to the normal, which points along the arm
  template <class L, class Samples>
  std::array<double, L::Q> along_normal(const Samples &samples, const Cover &before,
                                        const Uncovered &node)
  {
    const Vec3 c = before.centre(node.sphere);
    std::array<double, L::Q> beyond{};
    double best = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2 * L::D; k++) {
      const double out = (k % 2 ? 1.0 : -1.0) * (node.p[k / 2] - c[k / 2]);
      if (!samples[k].known || out <= best) continue;
      best = out;
      beyond = samples[k].beyond;
    }
    return beyond;
  }

  template <class L, RefillRule rule, class Samples>
  std::array<double, L::Q> beyond_equilibrium(const Samples &samples, const Cover &before,
                                              const Uncovered &node, const Moments &m, double tau)
  {
    if constexpr (rule == RefillRule::GRAD) return by_gradient<L>(samples, m, tau);
    if constexpr (rule == RefillRule::NORMAL) return along_normal<L>(samples, before, node);
    return {};
  }

  // density of the populations that arrive from fluid, whose equilibrium velocity is u
  template <class L>
  bool arriving_density(const Layout &at, const Slots<L> &f, const Cover &before,
                        const Uncovered &node, const Vec3 &u, const Vec3 &force, double &drho)
  {
    double sum = 0.0, weight = 0.0;
    for (int i = 1; i < L::Q; i++) {
      const int(&e)[3] = L::e[i];
      const Int3 p{node.p[0] - e[0], node.p[1] - e[1], node.p[2] - e[2]};
      if (!before.inside(p[0], p[1], p[2]) || before.owner()[node.n - at.offset(e)] >= 0) continue;
      sum += f[i][node.n] - bare_equilibrium<L>(i, {0.0, u}, force);
      weight += L::w[i];
    }
    if (weight > 0.0) drho = sum / weight;
    return weight > 0.0;
  }

}    // namespace

template <class L> double excess_in(const Slots<L> &f, const std::vector<Index> &nodes)
{
  double sum = 0.0;
  for (const Index n : nodes)
    for (int i = 0; i < L::Q; i++) sum += f[i][n];
  return sum;
}

template <class L, RefillRule rule>
static double refill_by(const Layout &at, const Slots<L> &f, const Cover &before, const Cover &now,
                        const std::vector<Uncovered> &nodes, double tau, const Vec3 &force,
                        Neighbours &neighbours, RefillCount &count)
{
  double excess = 0.0;
  const auto samples = Around<L, rule>(at, f, before, now, force, neighbours).collect(nodes);
  for (std::size_t k = 0; k < nodes.size(); k++) {
    Moments m{0.0, solid_velocity(before, nodes[k])};
    int known = 0;
    for (const auto &s : samples[k])
      if (s.known) {
        m.drho += s.m.drho;
        known++;
      }
    if (known)
      m.drho /= known;
    else if (arriving_density<L>(at, f, before, nodes[k], m.u, force, m.drho))
      count.equilibrium++;
    else {    // deep in a sphere that is gone
      m.drho = before.spheres()[nodes[k].sphere].drho;
      count.deep++;
    }
    if (known) count.grad++;

    const auto beyond = beyond_equilibrium<L, rule>(samples[k], before, nodes[k], m, tau);
    for (int i = 0; i < L::Q; i++) {
      f[i][nodes[k].n] = typename L::Real(bare_equilibrium<L>(i, m, force) + beyond[i]);
      excess += f[i][nodes[k].n];
    }
  }
  return excess;
}

template <class L>
double refill_local(RefillRule rule, const Layout &at, const Slots<L> &f, const Cover &before,
                    const Cover &now, const std::vector<Uncovered> &nodes, double tau,
                    const Vec3 &force, Neighbours &neighbours, RefillCount &count)
{
  const auto by = rule == RefillRule::NORMAL ? refill_by<L, RefillRule::NORMAL>
      : rule == RefillRule::LOCAL            ? refill_by<L, RefillRule::LOCAL>
                                             : refill_by<L, RefillRule::GRAD>;
  return by(at, f, before, now, nodes, tau, force, neighbours, count);
}

template <class L>
double refill_equilibrium(const Slots<L> &f, const Cover &before,
                          const std::vector<Uncovered> &nodes, double drho_mean, const Vec3 &force,
                          RefillCount &count)
{
  double excess = 0.0;
  for (const Uncovered &node : nodes) {
    const Moments m{drho_mean, solid_velocity(before, node)};
    for (int i = 0; i < L::Q; i++) {
      f[i][node.n] = typename L::Real(bare_equilibrium<L>(i, m, force));
      excess += f[i][node.n];
    }
    count.equilibrium++;
  }
  return excess;
}

template <class L>
double fill_pockets(const Layout &at, const Slots<L> &f, const Cover &cover,
                    const std::vector<uint32_t> &pockets, const Vec3 &force)
{
  double gain = 0.0;
  for (const Index n : pockets) {
    const Int3 p = at.node(n);
    Moments m{0.0, {}};
    int around = 0, spheres = 0, arriving = 0;    // population that comes from the fluid neighbour
    double at_obstacles = 0.0;    // along which the density changes: the last choice
    bool at_open_face = false;
    for (int i = 1; i < L::Q; i++) {
      const int(&e)[3] = L::e[i];
      const int32_t s = cover.owner()[n + at.offset(e)];
      if (s < 0) {
        at_open_face = at_open_face || s == OUTSIDE;
        if (cover.inside(p[0] + e[0], p[1] + e[1], p[2] + e[2])) arriving = opposite<L>(i);
        continue;    // else behind a wall
      }
      const Sphere &sphere = cover.spheres()[s];
      const Vec3 &c = cover.centre(s);
      const Vec3 u = sphere.velocity_at({p[0] - c[0], p[1] - c[1], p[2] - c[2]});
      for (int d = 0; d < L::D; d++) m.u[d] += u[d];
      around++;
      (cover.is_obstacle(s) ? at_obstacles : m.drho) += sphere.drho;
      spheres += !cover.is_obstacle(s);
    }
    if (at_open_face) continue;    // which sets the node
    m.drho = spheres ? m.drho / spheres : at_obstacles / around;
    for (double &u : m.u) u /= around;
    if (arriving) {    // what the node held, less what it sent there, and what came from there
      const int sent = opposite<L>(arriving);
      m.drho = f[arriving][n] - f[sent][n + at.offset(L::e[sent])];
      for (int i = 0; i < L::Q; i++) m.drho += f[i][n + at.offset(L::e[i])];
    }
    for (int i = 0; i < L::Q; i++) {
      const auto filled = typename L::Real(bare_equilibrium<L>(i, m, force));
      gain += double(filled) - double(f[i][n]);
      f[i][n] = filled;
    }
  }
  return gain;
}

#define LBM_INSTANTIATE(L)                                                                     \
  template double refill_local<L>(RefillRule, const Layout &, const Slots<L> &, const Cover &, \
                                  const Cover &, const std::vector<Uncovered> &, double,       \
                                  const Vec3 &, Neighbours &, RefillCount &);                  \
  template double excess_in<L>(const Slots<L> &, const std::vector<Index> &);                  \
  template double refill_equilibrium<L>(const Slots<L> &, const Cover &,                       \
                                        const std::vector<Uncovered> &, double, const Vec3 &,  \
                                        RefillCount &);                                        \
  template double fill_pockets<L>(const Layout &, const Slots<L> &, const Cover &,             \
                                  const std::vector<uint32_t> &, const Vec3 &);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
