/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Light grains of fix lb/ibb: the fluid answers to their velocity within a fluid step. With a force
// that is held, a grain much lighter than the fluid it has to move along is thrown back and forth.
//
// In every granular step the force on a light grain is F - zeta (U - U_0), with F, zeta of the
// links and U_0 of the last fluid step (lbm_yield.h), U that of the middle of the step to come:
// solved for, not taken from before. The mean of U - U_0 is told to the fluid before its next step,
// so that momentum is kept to round-off.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"
#include "lbm_rules.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_store_atom.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "update.h"

#include <Eigen/Dense>
#include <algorithm>
#include <unordered_map>

using namespace LAMMPS_NS;

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int SIZE = lbm::Response::SIZE;

// columns of the store: zeta; what links swallow more, by velocity; U_0 and the sum of U - U_0
// since the last fluid step; area of the links; force and torque in gaps of one node; then zeta and
// U_0 of before that step, for runs that begin right after it. Physical, but TAKEN and AREA.
enum { ZETA = 0, TAKEN = SIZE, START = TAKEN + 6, SUM = START + 6, AREA = SUM + 6 };
enum {
  IN_GAPS = AREA + 1,
  FORMER_ZETA = IN_GAPS + 6,
  FORMER_START = FORMER_ZETA + SIZE,
  ROW = FORMER_START + 6
};

// zeta is zero for grains that do not yield
bool yielding(const double *row)
{
  return row[ZETA] > 0.0;
}

Matrix6 matrix(const double *lower)
{
  Matrix6 m;
  for (int i = 0; i < 6; i++)
    for (int j = 0; j <= i; j++) m(i, j) = m(j, i) = *lower++;
  return m;
}

// what a light grain got beyond its load, since it was faster than in the fluid step; lattice units
lbm::Vec3 further_load(const double *row, int steps, double unit)
{
  const Vector6 load = matrix(row + ZETA) * Eigen::Map<const Vector6>(row + SUM) / (-steps * unit);
  return {load[0], load[1], load[2]};
}

}    // namespace

void FixLbIbb::find_integrators()
{
  moving_bits = held_bits = set_bits = tied_bits = 0;
  for (auto *other : modify->get_fix_list()) {
    const auto is = [&](const char *style) {
      return utils::strmatch(other->style, style);
    };
    if (is("^freeze") || is("^move") || is("^nve/noforce"))
      held_bits |= other->groupbit;
    else if (other->time_integrate)
      moving_bits |= other->groupbit;
    if (is("^setforce")) set_bits |= other->groupbit;
    if (is("^setforce") || is("^rigid") || is("^poems")) tied_bits |= other->groupbit;
  }
}

// does the motion of a grain follow from forces?
bool FixLbIbb::is_driven(int i) const
{
  return (atom->mask[i] & moving_bits) && !(atom->mask[i] & held_bits);
}

// from its own alone: these may yield
bool FixLbIbb::is_light(int i) const
{
  const int mask = atom->mask[i];
  if (!light || !(mask & groupbit) || !is_driven(i) || (mask & tied_bits)) return false;
  return options.coupling == LBOptions::IMPLICIT || below_limit(i);
}

// of the grain, its mass in its hydrodynamic volume, to that of the fluid
double FixLbIbb::density_ratio(int i) const
{
  return atom->rmass[i] / (options.rho * units.grain_volume(hydrodynamic_radius(i)));
}

// The force of a single step throws grains of any density to and fro that are close to others.
bool FixLbIbb::below_limit(int i) const
{
  return !options.average ||
      density_ratio(i) < lbm::light_below(hydrodynamic_radius(i) / options.dx,
                                          units.tau(options.nu), domain->dimension);
}

// Storage, once there are grains that need it. Collective.
void FixLbIbb::provide_light()
{
  if (light || options.coupling == LBOptions::EXPLICIT || !atom->rmass_flag || !atom->radius_flag)
    return;
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && (options.coupling == LBOptions::IMPLICIT || below_limit(i)))
      mine = 1;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;
  light = dynamic_cast<FixStoreAtom *>(modify->add_fix(
      fmt::format("{}_LIGHT {} STORE/ATOM {} 0 0 1", id, group->names[igroup], +ROW)));
}

// what a restart file has of them belongs to a fluid that is gone
void FixLbIbb::forget_light()
{
  if (!light) return;
  for (int i = 0; i < atom->nlocal; i++) std::fill_n(light->astore[i], +ROW, 0.0);
}

// after all other forces; at the start of a run velocities are those of the full step, half of the
// force is still to act on them, and the fluid knows of it already
void FixLbIbb::yield(bool start, bool before)
{
  if (!light) return;
  const double dt = (start ? 0.5 : 1.0) * update->dt;
  const double inertia = domain->dimension == 2 ? 0.5 : 0.4;
  if (yieldings.size() < std::size_t(atom->nlocal)) yieldings.resize(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) {
    double *row = light->astore[i];
    const double *held = row + (before ? +FORMER_ZETA : +ZETA);
    const double *from = row + (before ? +FORMER_START : +START);
    if (!(atom->mask[i] & groupbit) || !yielding(held)) continue;
    const double m = atom->rmass[i], r = atom->radius[i], I = inertia * m * r * r;
    Vector6 f, gain, per_mass;
    for (int d = 0; d < 3; d++) {
      f[d] = atom->f[i][d];
      f[3 + d] = atom->torque[i][d];
      gain[d] = atom->v[i][d] - from[d];
      gain[3 + d] = atom->omega[i][d] - from[3 + d];
      per_mass[d] = dt / m;
      per_mass[3 + d] = dt / I;
    }
    // f - zeta gain', with gain' = gain + M^-1 dt (f - zeta gain') that at the end of the step:
    // f - zeta (1 + M^-1 dt zeta)^-1 (gain + M^-1 dt f), in which that before the bracket is
    // M/dt (M/dt + zeta)^-1 zeta
    Yielding once, &kept = start ? once : yieldings[i];
    if (kept.grain != atom->tag[i] || kept.fluid_step != fluid_steps ||
        kept.per_mass[0] != per_mass[0] || kept.per_mass[1] != per_mass[3]) {
      const Matrix6 zeta = matrix(held);
      const Matrix6 M = per_mass.cwiseInverse().asDiagonal();    // over dt
      kept = {atom->tag[i], fluid_steps, {per_mass[0], per_mass[3]}, {}};
      Eigen::Map<Matrix6>(kept.less.data()) = M * (M + zeta).llt().solve(zeta);
    }
    f -= Eigen::Map<const Matrix6>(kept.less.data()) * (gain + per_mass.cwiseProduct(f));
    gain += per_mass.cwiseProduct(f);
    for (int d = 0; d < 3; d++) {
      atom->f[i][d] = f[d];
      atom->torque[i][d] = f[3 + d];
    }
    if (start) continue;
    for (int d = 0; d < 6; d++) row[SUM + d] += gain[d];
  }
}

// Before a fluid step: the fluid of the last one learns how much faster light grains were. Grains
// may have changed ranks since, so that spheres are found by their ids. Collective.
void FixLbIbb::correct_fluid()
{
  if (!light || fluid_steps == 0) return;
  const int nall = atom->nlocal + atom->nghost;
  told.assign(std::size_t(nall), {});
  for (int i = 0; i < atom->nlocal; i++) {
    double *row = light->astore[i], *past = history[i], taken = 0.0;
    if (balance && yielding(row)) balance->take(further_load(row, nevery, units.force()));
    for (int d = 0; d < 6; d++) {
      told[i][d] = row[SUM + d] / nevery / (d < 3 ? units.velocity() : units.spin());
      taken += row[TAKEN + d] * told[i][d];
      row[SUM + d] = 0.0;
    }
    past[SWALLOWED] += taken;
    if (options.conserve && row[AREA] > 0.0) past[REFUND] += taken / row[AREA];
  }
  about = RESPONSES;
  comm->forward_comm(this, 6);
  about = LOADS;
  const auto &last = fluid->spheres();
  if (std::none_of(last.begin(), last.end(), [](const lbm::Sphere &s) {
        return s.yields;
      }))
    return;
  std::unordered_map<std::int64_t, int> atom_of;
  for (int i = 0; i < nall; i++) atom_of[atom->tag[i]] = i;
  std::vector<lbm::Gain> gains(last.size());
  for (std::size_t s = 0; s < last.size(); s++) {
    const auto found = atom_of.find(last[s].id);
    if (found == atom_of.end() || !last[s].yields) continue;
    const auto &t = told[found->second];
    gains[s] = {{t[0], t[1], t[2]}, {t[3], t[4], t[5]}};
  }
  fluid->correct(gains);
}

// After a fluid step: the response of each light grain, over images and ranks. Collective.
void FixLbIbb::keep_responses()
{
  if (!light) return;
  told.assign(std::size_t(atom->nlocal) + atom->nghost, {});
  const auto &responses = fluid->responses();
  for (std::size_t s = 0; s < responses.size(); s++) {
    auto &t = told[sphere_atom[s]];
    for (int n = 0; n < SIZE; n++) t[n] += responses[s].zeta[n];
    for (int d = 0; d < 6; d++) {
      t[SIZE + d] += responses[s].swallowed[d];
      t[SIZE + 6 + d] += responses[s].in_gaps[d];
    }
  }
  about = RESPONSES;
  if (force->newton)
    comm->reverse_comm(this, TOLD);
  else
    comm->reverse_comm_variable(this);
  about = LOADS;
  const double load[2] = {units.force(), units.torque()};
  const double motion[2] = {units.velocity(), units.spin()};
  for (int i = 0; i < atom->nlocal; i++) {
    double *row = light->astore[i];
    std::copy_n(row + ZETA, SIZE, row + FORMER_ZETA);
    std::copy_n(row + START, 6, row + FORMER_START);
    for (int a = 0, n = 0; a < 6; a++)
      for (int b = 0; b <= a; b++, n++) row[ZETA + n] = told[i][n] * load[a / 3] / motion[b / 3];
    std::copy_n(&told[i][SIZE], 6, row + TAKEN);
    std::copy_n(atom->v[i], 3, row + START);
    std::copy_n(atom->omega[i], 3, row + START + 3);
    row[AREA] = ghosted[i][7];
    for (int d = 0; d < 6; d++) {
      const double in_gaps = told[i][SIZE + 6 + d] * load[d / 3];
      if (row[FORMER_ZETA] > 0.0 && yielding(row))
        array_atom[i][d] += 0.5 * (row[IN_GAPS + d] - in_gaps);
      row[IN_GAPS + d] = in_gaps;
    }
  }
}

// Grains that are coupled implicitly; those that would have to be, but are not. Of all ranks.
bigint FixLbIbb::light_grains() const
{
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) mine += is_light(i);
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

void FixLbIbb::warn_of_loose()
{
  if (!atom->rmass_flag || !atom->radius_flag) return;
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) mine += (atom->mask[i] & groupbit) && is_loose(i);
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all > 0 && comm->me == 0)
    error->warning(FLERR, "Fix lb/ibb: {} grains may be thrown to and fro by the water: {}", all,
                   cause_of_loose());
}
