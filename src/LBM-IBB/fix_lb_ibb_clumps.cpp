/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Clumps: spheres that fix rigid holds together displace the volume of their union, which buoyancy
// and a pressure gradient act on. Bodies keep their shape: looked at when runs start or grains
// change.

#include "fix_lb_ibb.h"

#include "lbm_overlap.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "modify.h"

#include <algorithm>

using namespace LAMMPS_NS;
using lbm::Vec3;

// Buoyancy, gradp and the balance of momentum need volumes; nothing else does
bool FixLbIbb::has_clumps() const
{
  return (options.has_buoyancy || options.has_gradp || balance) && atom->radius_flag &&
      !modify->get_fix_by_style("^rigid").empty();
}

// by own atom: do rigid bodies hold it?
std::vector<char> FixLbIbb::in_bodies() const
{
  std::vector<char> held(atom->nlocal, 0);
  for (auto *rigid : modify->get_fix_by_style("^rigid")) {
    int dim;
    const int *body = (int *) rigid->extract("body", dim);
    if (!body) continue;
    for (int i = 0; i < atom->nlocal; i++)
      if (body[i] >= 0) held[i] = 1;
  }
  return held;
}

// volume of the fluid that grain i displaces
double FixLbIbb::displaced_volume(int i) const
{
  return units.grain_volume(hydrodynamic_radius(i)) * (1.0 - history[i][SHARED]);
}

// SHARED of the own grains: the part of a sphere's volume that counts for others of clumps
void FixLbIbb::share_volumes()
{
  if (!has_clumps()) return;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  for (int i = 0; i < nlocal; i++) history[i][SHARED] = 0.0;

  // own spheres of bodies, and by tag so are their images; spheres of other bodies may touch, but
  // what they overlap is nothing against a clump
  std::vector<int> list;
  double largest = 0.0;
  for (int i = 0; i < nall; i++) {
    if (!(atom->mask[i] & groupbit) || hydrodynamic_radius(i) <= 0.0) continue;
    list.push_back(i);
    largest = std::max(largest, hydrodynamic_radius(i));
  }
  double **x = atom->x;
  std::sort(list.begin(), list.end(), [&](int a, int b) {
    return x[a][0] < x[b][0];
  });

  const auto held = in_bodies();
  for (std::size_t k = 0; k < list.size(); k++) {
    const int i = list[k];
    if (i >= nlocal || !held[i]) continue;
    const double radius = hydrodynamic_radius(i);
    std::vector<lbm::Overlap> others;
    auto look_at = [&](int j) {
      Vec3 away;
      for (int d = 0; d < 3; d++) away[d] = x[j][d] - x[i][d];
      const double reach = radius + hydrodynamic_radius(j);
      if (lbm::dot(away, away) < reach * reach)
        others.push_back({away, hydrodynamic_radius(j), atom->tag[j] < atom->tag[i]});
    };
    const double reach = radius + largest;
    for (std::size_t b = k + 1; b < list.size() && x[list[b]][0] - x[i][0] < reach; b++)
      look_at(list[b]);
    for (std::size_t b = k; b-- > 0 && x[i][0] - x[list[b]][0] < reach;) look_at(list[b]);
    history[i][SHARED] = 1.0 - lbm::kept_share(radius, others, domain->dimension);
  }
}
