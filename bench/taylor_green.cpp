// SPDX-License-Identifier: GPL-2.0-only
// Error of the fluid alone, for ./run accuracy: vortices of Taylor & Green, Proc. R. Soc. A 158, 499
// (1937), which decay as exp(-2 nu k^2 t), to half their velocity.
//
//   taylor_green N TAU RE COLLISION PRECISION    N nodes to the period, RE = U N/nu, trt | bgk |
//                                                regularised, double | single
//
// Prints the relative root-mean-square error of the velocity, and the cost in LAMMPS's words.

#include "lbm_neighbours.h"
#include "lbm_solver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

using namespace lbm;

static bool one_of(const char *word, std::initializer_list<const char *> words)
{
  return std::any_of(words.begin(), words.end(), [&](const char *w) {
    return !std::strcmp(w, word);
  });
}

int main(int argc, char **argv)
{
  if (argc != 6 || !one_of(argv[4], {"trt", "bgk", "regularised"}) ||
      !one_of(argv[5], {"double", "single"})) {
    std::fprintf(stderr, "taylor_green N TAU RE trt|bgk|regularised double|single\n");
    return 1;
  }
  const int n = std::atoi(argv[1]);
  Settings s;
  s.dimension = 2;
  s.tau = std::atof(argv[2]);
  s.bgk = !std::strcmp(argv[4], "bgk");
  s.regularised = !std::strcmp(argv[4], "regularised");
  s.single = !std::strcmp(argv[5], "single");
  const double nu = (s.tau - 0.5) / 3.0, k = 2.0 * M_PI / n, U = std::atof(argv[3]) * nu / n;
  Alone alone({true, true, false});
  const auto fluid = Fluid::create(s, {0, 0, 0}, {n, n, 1}, {n, n, 1}, alone);

  const auto flow = [&](int x, int y, double decay) {
    const double A = U * decay;
    Moments m{-0.75 * A * A * (std::cos(2 * k * x) + std::cos(2 * k * y)), {}};
    m.u = {A * std::cos(k * x) * std::sin(k * y), -A * std::sin(k * x) * std::cos(k * y), 0.0};
    return m;
  };
  for (int y = 0; y < n; y++)
    for (int x = 0; x < n; x++) fluid->set_equilibrium(x, y, 0, flow(x, y, 1.0));

  const int steps = int(std::lround(std::log(2.0) / (2.0 * nu * k * k)));
  std::vector<Load> loads;
  const auto begin = std::chrono::steady_clock::now();
  for (int t = 0; t < steps; t++) fluid->advance(loads);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;

  double error = 0.0, norm = 0.0;
  for (int y = 0; y < n; y++)
    for (int x = 0; x < n; x++) {
      const Vec3 u = fluid->moments(x, y, 0).u,
                 exact = flow(x, y, std::exp(-2.0 * nu * k * k * steps)).u;
      for (int d = 0; d < 2; d++) {
        error += (u[d] - exact[d]) * (u[d] - exact[d]);
        norm += exact[d] * exact[d];
      }
    }
  std::printf("%d x %d x 1 nodes, memory %.4g MiB\n", n, n, fluid->bytes() / 1048576.0);
  std::printf("Loop time of %.6g on 1 procs for %d steps\n", seconds.count(), steps);
  std::printf("result error %.8g Ma %.6g\n", std::sqrt(error / norm), U * std::sqrt(3.0));
  return 0;
}
