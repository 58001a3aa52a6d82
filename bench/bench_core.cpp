// SPDX-License-Identifier: GPL-2.0-only
// Speed of the solver core's parts: the memory's limit for in-place streaming, the sweep with each
// of its policies, and whole steps of a dense bed. "nodes" and "links" are rates per second.

#include "lbm_bounce_back.h"
#include "lbm_exchange.h"
#include "lbm_link.h"
#include "lbm_solver.h"
#include "lbm_sweep.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace lbm;

namespace {

constexpr int N = 128;

void nodes_per_second(benchmark::State &state, double nodes)
{
  state.counters["nodes"] =
      benchmark::Counter(nodes, benchmark::Counter::kIsIterationInvariantRate);
}

// read and write 19 arrays, nothing else: no sweep can be faster
void stream_limit(benchmark::State &state)
{
  const Layout at({0, 0, 0}, {N, N, N}, 3);
  Block<D3Q19> block(at);
  for (auto _ : state) {
    const Slots<D3Q19> p = block.slots();
    for (int z = 0; z < N; z++)
      for (int y = 0; y < N; y++) {
        const Index row = at.index(0, y, z);
        for (Index n = row; n < row + N; n += SIMD_WIDTH) {
          Pack<SIMD_WIDTH> f[D3Q19::Q];
          unroll<D3Q19::Q>([&](auto i) LBM_INLINE {
            read_ahead<D3Q19>(p[i] + n);
            f[i] = load<Pack<SIMD_WIDTH>>(p[i] + n);
          });
          unroll<D3Q19::Q>([&](auto i) LBM_INLINE {
            store(p[i] + n, f[i] + 1e-30);
          });
        }
      }
    block.advance();    // both parities, as they lie differently in memory
    benchmark::ClobberMemory();
  }
  nodes_per_second(state, double(N) * N * N);
}
BENCHMARK(stream_limit)->Unit(benchmark::kMillisecond);

// both parities in turn
template <class L, class Force, class Solid>
void run_sweep(benchmark::State &state, Block<L> &block, const Force &force, const Solid &solid)
{
  const auto collide = Trt<L>::trt(0.8, 3.0 / 16.0);
  for (auto _ : state) {
    sweep(block, collide, force, solid);
    block.advance();
    benchmark::ClobberMemory();
  }
  nodes_per_second(state, double(block.layout().nodes()));
}

template <class L> Layout cube()
{
  return L::D == 3 ? Layout({0, 0, 0}, {N, N, N}, 3) : Layout({0, 0, 0}, {8 * N, 8 * N, 1}, 2);
}

template <class L> void sweep_fluid(benchmark::State &state)
{
  Block<L> block(cube<L>());
  run_sweep(state, block, NoForce{}, NoSolids{});
}
BENCHMARK_TEMPLATE(sweep_fluid, D3Q19)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sweep_fluid, D2Q9)->Unit(benchmark::kMillisecond);

template <class L> void sweep_force(benchmark::State &state)
{
  Block<L> block(cube<L>());
  run_sweep(state, block, UniformForce{{1e-6, 0.0, 0.0}}, NoSolids{});
}
BENCHMARK_TEMPLATE(sweep_force, D3Q19)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(sweep_force, D2Q9)->Unit(benchmark::kMillisecond);

template <class L> void sweep_solids(benchmark::State &state)
{
  Block<L> block(cube<L>());
  const std::vector<int32_t> owner(block.layout().size, FLUID);
  run_sweep(state, block, NoForce{}, Solids{owner.data()});
}
BENCHMARK_TEMPLATE(sweep_solids, D3Q19)->Unit(benchmark::kMillisecond);

template <class L> void sweep_moving_solids(benchmark::State &state)
{
  Block<L> block(cube<L>());
  const std::vector<int32_t> owner(block.layout().size, FLUID);
  std::vector<float> drho(block.layout().size);
  run_sweep(state, block, NoForce{}, MovingSolids{owner.data(), drho.data()});
}
BENCHMARK_TEMPLATE(sweep_moving_solids, D3Q19)->Unit(benchmark::kMillisecond);

template <class L> void sweep_force_moving_solids(benchmark::State &state)
{
  Block<L> block(cube<L>());
  const std::vector<int32_t> owner(block.layout().size, FLUID);
  std::vector<float> drho(block.layout().size);
  run_sweep(state, block, UniformForce{{1e-6, 0.0, 0.0}}, MovingSolids{owner.data(), drho.data()});
}
BENCHMARK_TEMPLATE(sweep_force_moving_solids, D3Q19)->Unit(benchmark::kMillisecond);

// face-centred cubic bed of spheres of radius r, solid fraction .6, about 96 nodes wide
struct Bed {
  int n;
  double radius, cell;
  int cells;

  explicit Bed(double r) : radius(r)
  {
    const double wanted = std::cbrt(16.0 * M_PI / 3.0 * r * r * r / 0.6);
    cells = int(std::lround(96.0 / wanted));
    n = int(std::lround(cells * wanted));
    cell = double(n) / cells;
  }
  std::vector<Sphere> spheres(double shift, double velocity) const
  {
    const double basis[4][3] = {{.1, .13, .17}, {.6, .63, .17}, {.6, .13, .67}, {.1, .63, .67}};
    std::vector<Sphere> list;
    std::int64_t id = 0;
    for (int i = -1; i <= cells; i++)
      for (int j = -1; j <= cells; j++)
        for (int k = -1; k <= cells; k++)
          for (const auto &b : basis) {
            const Vec3 c{snap((i + b[0]) * cell + shift), snap((j + b[1]) * cell),
                         snap((k + b[2]) * cell)};
            bool reaches = true;
            for (double x : c) reaches = reaches && x > -radius - 1 && x < n + radius + 1;
            if (reaches) list.push_back({id, c, radius, {velocity, 0, 0}, {0, 0, 0.1 * velocity}});
            id++;
          }
    return list;
  }
};

// whole steps; argument: link rule
void bed(benchmark::State &state, bool moving)
{
  const Bed bed(5.0);
  Settings s;
  s.tau = 0.55;
  s.link = LinkRule(state.range(0));
  Alone alone({true, true, true});
  auto fluid = Fluid::create(s, {0, 0, 0}, {bed.n, bed.n, bed.n}, {bed.n, bed.n, bed.n}, alone);
  std::vector<Load> loads;
  double t = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    const auto spheres = bed.spheres(moving ? 0.01 * t : 0.0, moving ? 0.01 : 0.0);
    t += 1.0;
    state.ResumeTiming();
    fluid->follow(spheres);
    fluid->advance(loads);
  }
  nodes_per_second(state, std::pow(bed.n, 3));
  state.counters["links"] =
      benchmark::Counter(fluid->links(), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["links/node"] = fluid->links() / std::pow(bed.n, 3);
  state.counters["bytes/node"] = fluid->bytes() / std::pow(bed.n, 3);
}
BENCHMARK_CAPTURE(bed, fixed, false)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bed, moving, true)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

// the link pass alone, lists ready; the rate of links is the inverse of the time per link
template <class Rule, bool moving> void link_pass(benchmark::State &state)
{
  const Bed bed(5.0);
  const Layout at({0, 0, 0}, {bed.n, bed.n, bed.n}, 3);
  const Block<D3Q19> block(at);
  Cover cover(at, 3, Cover::Sides{});
  cover.place(bed.spheres(0.0, moving ? 0.01 : 0.0));
  Links links;
  const Region all{{0, 0, 0}, {bed.n - 1, bed.n - 1, bed.n - 1}};
  for (std::size_t s = 0; s < cover.spheres().size(); s++)
    find_links<D3Q19>(at, cover, s, all, links);
  const std::vector<float> drho(at.size);
  std::vector<Load> loads(cover.spheres().size());
  Yields none;
  for (auto _ : state)
    bounce_back<D3Q19, Rule, moving ? Motion::TURN : Motion::REST, true, false>(
        at, block.slots(), cover, links, drho.data(), loads, none);
  state.counters["links"] = benchmark::Counter(double(links.size + 2 * links.gaps.size),
                                               benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK_TEMPLATE(link_pass, Halfway, false)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(link_pass, Bouzidi, false)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(link_pass, Cli, false)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(link_pass, Bouzidi, true)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(link_pass, Cli, true)->Unit(benchmark::kMillisecond);

void find_all_links(benchmark::State &state)
{
  const Bed bed(5.0);
  const Layout at({0, 0, 0}, {bed.n, bed.n, bed.n}, 3);
  Cover cover(at, 3, Cover::Sides{});
  cover.place(bed.spheres(0.0, 0.0));
  Links links;
  const Region all{{0, 0, 0}, {bed.n - 1, bed.n - 1, bed.n - 1}};
  for (auto _ : state) {
    links.clear();
    for (std::size_t s = 0; s < cover.spheres().size(); s++)
      find_links<D3Q19>(at, cover, s, all, links);
  }
  state.counters["links"] = benchmark::Counter(double(links.size + 2 * links.gaps.size),
                                               benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(find_all_links)->Unit(benchmark::kMillisecond);

}    // namespace
