// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_profile.h"

#include <algorithm>
#include <cmath>

namespace lbm {
namespace {

  // Mean density excess of each plane; planes without fluid lie on the line between their
  // neighbours
  std::vector<double> plane_means(const Planes &sums)
  {
    const int n = int(sums.fluid.size());
    std::vector<double> mean(n, 0.0);
    int last = -1;    // plane with fluid
    for (int k = 0; k < n; k++) {
      if (sums.fluid[k] == 0.0) continue;
      mean[k] = sums.drho[k] / sums.fluid[k];
      for (int j = last + 1; j < k; j++)
        mean[j] = last < 0 ? mean[k]
                           : mean[last] + (mean[k] - mean[last]) * (j - last) / (k - last);
      last = k;
    }
    for (int j = last + 1; j < n && last >= 0; j++) mean[j] = mean[last];
    return mean;
  }

}    // namespace

template <class L>
Planes planes(const Layout &at, const Slots<L> &f, const int32_t *owner, const Vec3 &force,
              int axis, int n)
{
  Planes sums(n);
  Int3 p;
  for (p[2] = 0; p[2] < at.n[2]; p[2]++)
    for (p[1] = 0; p[1] < at.n[1]; p[1]++)
      for (p[0] = 0; p[0] < at.n[0]; p[0]++) {
        const Index node = at.index(p[0], p[1], p[2]);
        if (owner && owner[node] >= 0) continue;
        const Moments m = moments<L>(f, node, force);
        const int k = p[axis] + at.lo[axis];
        sums.fluid[k] += 1.0;
        sums.drho[k] += m.drho;
        sums.velocity[k] += m.u[axis];
      }
  return sums;
}

void reduce(Planes &sums, Neighbours &neighbours)
{
  for (auto *values : {&sums.fluid, &sums.drho, &sums.velocity})
    neighbours.sum(values->data(), int(values->size()));
}

std::vector<Layer> layers(const Planes &sums, double nodes_per_plane, int width, bool periodic,
                          double force)
{
  const int n = int(sums.fluid.size());
  const std::vector<double> drho = plane_means(sums);
  // at the lower side of plane k
  auto border = [&](int k) {
    if (periodic) return 0.5 * (drho[(k + n - 1) % n] + drho[k % n]);
    return 0.5 * (drho[std::max(k - 1, 0)] + drho[std::min(k, n - 1)]);
  };
  std::vector<Layer> all;
  for (int k = 0; k < n; k += width) {
    Layer l{0.0, 0.0, 0.0, force, double(width)};
    for (int j = k; j < k + width; j++) {
      l.porosity += sums.fluid[j] / (nodes_per_plane * width);
      l.flux += sums.velocity[j] / (nodes_per_plane * width);
      l.pressure += drho[j] / (3.0 * width);    // c_s^2 = 1/3
    }
    if (!periodic) l.length -= 0.5 * ((k == 0) + (k + width == n));
    if (l.length > 0.0) l.gradient -= (border(k + width) - border(k)) / (3.0 * l.length);
    all.push_back(l);
  }
  return all;
}

double volume_below(double z, double r, int dimension)
{
  const double s = std::clamp(z / r, -1.0, 1.0);
  if (dimension == 2) return r * r * (std::asin(s) + s * std::sqrt(1.0 - s * s) + 0.5 * M_PI);
  return M_PI * r * r * r * (s - s * s * s / 3.0 + 2.0 / 3.0);
}

#define LBM_INSTANTIATE(L)                                                                        \
  template Planes planes<L>(const Layout &, const Slots<L> &, const int32_t *, const Vec3 &, int, \
                            int);
LBM_FOR_EACH_LATTICE(LBM_INSTANTIATE)
#undef LBM_INSTANTIATE

}    // namespace lbm
