/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Grains of fix lb/ibb: in to the fluid, forces out, and what is kept of each between fluid steps.

#include "fix_lb_ibb.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "force.h"
#include "memory.h"

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace LAMMPS_NS;
using lbm::Vec3;

// Since this was asked last, have grains come or gone, also one for another, become larger or
// heavier, joined the group or a rigid body? Told by a sum over them, alike on all ranks. Collective.
bool FixLbIbb::grains_changed()
{
  if (!atom->radius_flag) return false;
  const auto held = has_clumps() ? in_bodies() : std::vector<char>(atom->nlocal, 0);
  std::uint64_t sum = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double mass = atom->rmass_flag ? atom->rmass[i] : 0.0;
    const double grain[] = {double(atom->tag[i]), atom->radius[i], mass, double(held[i])};
    sum += lbm::checksum(grain, std::size(grain));
  }
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, world);
  const bool changed = sum != grains_known;
  grains_known = sum;
  return changed;
}

// The spheres that reach this rank: own grains and ghosts, each where its image is. The owner's
// place, snapped, goes out with the velocities, so that all images agree to the bit.
void FixLbIbb::place_grains()
{
  spheres.clear();
  sphere_atom.clear();
  fastest = {};
  trouble = {};
  if (atom->natoms == 0 || !atom->radius_flag) return;

  const int nall = atom->nlocal + atom->nghost;
  if (nall > nghosted) {
    nghosted = atom->nmax;
    memory->destroy(ghosted);
    memory->create(ghosted, nghosted, OUT, "lb/ibb:ghosted");
  }
  for (int i = 0; i < atom->nlocal; i++) {
    for (int d = 0; d < 3; d++) {
      ghosted[i][d] = lbm::snap((atom->x[i][d] - domain->boxlo[d]) / units.dx);
      ghosted[i][3 + d] = atom->v[i][d] / units.velocity();
      ghosted[i][6 + d] = atom->omega[i][d] / units.spin();
    }
    ghosted[i][9] = history[i][EXCESS];
    ghosted[i][10] = history[i][REFUND];
    if (atom->mask[i] & groupbit) inspect_grain(i, ghosted[i]);
  }
  comm->forward_comm(this);

  const lbm::Layout &at = fluid->layout();
  for (int i = 0; i < nall; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *g = ghosted[i];
    lbm::Sphere s{atom->tag[i],
                  {g[0], g[1], g[2]},
                  drawn_radius(i),
                  {g[3], g[4], g[5]},
                  {g[6], g[7], g[8]},
                  g[9],
                  g[10],
                  is_light(i)};
    bool reaches = true;
    for (int d = 0; d < domain->dimension; d++) {
      const double seen = (atom->x[i][d] - domain->boxlo[d]) / units.dx;
      if (domain->periodicity[d])
        s.centre[d] += nodes[d] * std::nearbyint((seen - s.centre[d]) / nodes[d]);
      reaches = reaches && s.centre[d] + s.radius > at.lo[d] - 1.0 &&
          s.centre[d] - s.radius < at.lo[d] + at.n[d] + 1.0;
    }
    if (!reaches) continue;
    spheres.push_back(s);
    sphere_atom.push_back(i);
  }
}

// momentum of the links to the grains, summed over images and ranks; mean of two steps if wanted
void FixLbIbb::give_forces()
{
  if (atom->natoms == 0 || !atom->radius_flag) return;
  const int nall = atom->nlocal + atom->nghost;
  for (int i = 0; i < nall; i++)
    for (int k = 0; k < BACK; k++) ghosted[i][k] = 0.0;
  for (std::size_t s = 0; s < loads.size(); s++) {
    double *g = ghosted[sphere_atom[s]];
    for (int d = 0; d < 3; d++) {
      g[d] += loads[s].force[d] * units.force();
      g[3 + d] += loads[s].torque[d] * units.torque();
    }
    g[6] += loads[s].pressing;
    g[7] += loads[s].area;
    g[8] += loads[s].swallowed;
  }
  // with newton off LAMMPS has no buffers for it but those it makes on the spot
  if (force->newton)
    comm->reverse_comm(this, BACK);
  else
    comm->reverse_comm_variable(this);

  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) {
      set_arrays(i);    // it may have been in the group before
      continue;
    }
    double *held = array_atom[i], *past = history[i];
    const double old = (options.average && past[AGE] > 0.0 && !is_light(i)) ? 0.5 : 0.0;
    for (int k = 0; k < 6; k++) {
      past[BEFORE + k] = held[k];
      held[k] = (1.0 - old) * ghosted[i][k] + old * past[LAST + k];
      past[LAST + k] = ghosted[i][k];
    }
    past[EXCESS] = ghosted[i][7] > 0.0 ? ghosted[i][6] / ghosted[i][7] : 0.0;
    if (options.conserve) past[REFUND] = lbm::refund(ghosted[i][8], past[SWALLOWED], ghosted[i][7]);
    past[SWALLOWED] = ghosted[i][8];
    inspect_force(i, ghosted[i]);
    if (options.has_gradp) {
      const double volume = displaced_volume(i);
      for (int d = 0; d < 3; d++) held[FORCE + d] -= volume * drive.gradp[d];
    }
    past[AGE] += 1.0;
  }
  keep_responses();
  share_nodes();
}

// The nodes of this rank, evenly over its grains: weights for the balance commands, which see
// grains alone. Their sum over a rank is what its part of the lattice costs.
void FixLbIbb::share_nodes()
{
  int grains = 0;
  for (int i = 0; i < atom->nlocal; i++) grains += (atom->mask[i] & groupbit) != 0;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) array_atom[i][SHARE] = double(fluid->layout().nodes()) / grains;
}

// ---------------------------------------------------------------------- per-atom data

// array_atom has no hidden columns: atom-style variables stride by size_peratom_cols
void FixLbIbb::grow_arrays(int nmax)
{
  memory->grow(array_atom, nmax, SHOWN, "lb/ibb:array_atom");
  memory->grow(history, nmax, COLUMNS, "lb/ibb:history");
}

void FixLbIbb::copy_arrays(int i, int j, int)
{
  std::copy_n(array_atom[i], int(SHOWN), array_atom[j]);
  std::copy_n(history[i], int(COLUMNS), history[j]);
}

void FixLbIbb::set_arrays(int i)
{
  std::fill_n(array_atom[i], int(SHOWN), 0.0);
  std::fill_n(history[i], int(COLUMNS), 0.0);
}

int FixLbIbb::pack_exchange(int i, double *buf)
{
  std::copy_n(array_atom[i], int(SHOWN), buf);
  std::copy_n(history[i], int(COLUMNS), buf + SHOWN);
  return SHOWN + COLUMNS;
}

int FixLbIbb::unpack_exchange(int i, double *buf)
{
  std::copy_n(buf, int(SHOWN), array_atom[i]);
  std::copy_n(buf + SHOWN, int(COLUMNS), history[i]);
  return SHOWN + COLUMNS;
}

int FixLbIbb::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  int m = 0;
  for (int i = 0; i < n; i++)
    if (about == LOADS)
      for (int k = 0; k < OUT; k++) buf[m++] = ghosted[list[i]][k];
    else
      for (int k = 0; k < 6; k++) buf[m++] = told[list[i]][k];
  return m;
}

void FixLbIbb::unpack_forward_comm(int n, int first, double *buf)
{
  int m = 0;
  for (int i = first; i < first + n; i++)
    if (about == LOADS)
      for (int k = 0; k < OUT; k++) ghosted[i][k] = buf[m++];
    else
      for (int k = 0; k < 6; k++) told[i][k] = buf[m++];
}

int FixLbIbb::pack_reverse_comm_size(int n, int)
{
  return n * (about == LOADS ? +BACK : +TOLD);
}

int FixLbIbb::pack_reverse_comm(int n, int first, double *buf)
{
  int m = 0;
  for (int i = first; i < first + n; i++)
    if (about == LOADS)
      for (int k = 0; k < BACK; k++) buf[m++] = ghosted[i][k];
    else
      for (int k = 0; k < TOLD; k++) buf[m++] = told[i][k];
  return m;
}

void FixLbIbb::unpack_reverse_comm(int n, int *list, double *buf)
{
  int m = 0;
  for (int i = 0; i < n; i++)
    if (about == LOADS)
      for (int k = 0; k < BACK; k++) ghosted[list[i]][k] += buf[m++];
    else
      for (int k = 0; k < TOLD; k++) told[list[i]][k] += buf[m++];
}
