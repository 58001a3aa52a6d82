/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Grains of fix lb/ibb are looked at in every fluid step, before and after the fluid has moved: a
// place, velocity or force that no run may go on with. All ranks stop together, before anything of
// it is written.

#include "fix_lb_ibb.h"

#include "lbm_rules.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using lbm::Vec3;

// Would it have to be coupled implicitly, but is not?
bool FixLbIbb::is_loose(int i) const
{
  return is_driven(i) && !(atom->mask[i] & set_bits) && below_limit(i) && !is_light(i);
}

std::string FixLbIbb::cause_of_loose() const
{
  return options.average ? "the grain is too light to be coupled explicitly; use coupling auto and "
                           "a fix that integrates each grain by its force and torque"
                         : "the force of a single fluid step throws the grain to and fro; use "
                           "average yes, or coupling auto and a fix that integrates "
                           "each grain by its force and torque";
}

// What is wrong stops the run when the step is done, on all ranks together. Until then the grain
// stays at rest where it was, so that the fluid gets numbers.
void FixLbIbb::inspect_grain(int i, double *g)
{
  double *past = history[i];
  const bool known = past[AGE] > 0.0;
  const double radius = hydrodynamic_radius(i) / units.dx;
  Vec3 step{};
  for (int d = 0; d < domain->dimension && known; d++) {
    step[d] = g[d] - past[PLACE + d];
    if (domain->periodicity[d]) step[d] -= nodes[d] * std::nearbyint(step[d] / nodes[d]);
  }
  const double moved = std::sqrt(lbm::dot(step, step));
  const Vec3 v{g[3], g[4], g[5]}, spin{g[6], g[7], g[8]};
  const double surface = std::sqrt(lbm::dot(v, v)) + radius * std::sqrt(lbm::dot(spin, spin));

  Trouble::Kind wrong = Trouble::NONE;
  double value = 0.0;
  if (!std::isfinite(moved) || !std::isfinite(surface)) {
    wrong = Trouble::NO_NUMBER;
  } else if (moved > 1.0) {
    wrong = Trouble::MOVED;
    value = moved;
  } else if (lbm::mach(surface) > lbm::MACH_LIMIT) {
    wrong = Trouble::FAST;
    value = surface;
  } else if (!known && !(radius >= lbm::RADIUS_LIMIT)) {
    wrong = Trouble::SMALL;
  }
  if (wrong != Trouble::NONE) {
    note(wrong, i, value);
    for (int d = 0; d < 3; d++) g[d] = known ? past[PLACE + d] : std::isfinite(g[d]) ? g[d] : 0.0;
    std::fill_n(g + 3, 6, 0.0);
  } else if (surface > fastest.speed)
    fastest = {surface, double(atom->tag[i]), {g[0], g[1], g[2]}};
  std::copy_n(g, 3, past + PLACE);
}

// held for as long as the fluid stands still: no thermo, dump or print may see what comes of it
void FixLbIbb::inspect_force(int i, const double *force)
{
  for (int k = 0; k < 6; k++)
    if (!std::isfinite(force[k])) {
      note(Trouble::NO_NUMBER, i, 0.0);
      return;
    }
}

// keeps the gravest; of equals the largest value, then the lowest ID
void FixLbIbb::note(Trouble::Kind kind, int i, double value)
{
  const double id = atom->tag[i];
  if (kind < trouble.kind || (kind == trouble.kind && value < trouble.value) ||
      (kind == trouble.kind && value == trouble.value && id > trouble.id))
    return;
  const Vec3 v{atom->v[i][0], atom->v[i][1], atom->v[i][2]};
  trouble = {double(kind),
             value,
             id,
             hydrodynamic_radius(i) / units.dx,
             density_ratio(i),
             std::sqrt(lbm::dot(v, v)) / units.velocity(),
             is_loose(i) ? 1.0 : 0.0,
             {atom->x[i][0], atom->x[i][1], atom->x[i][2]}};
}

// collective
void FixLbIbb::stop_for_trouble()
{
  if (atom->natoms == 0 || !atom->radius_flag) return;
  struct {
    double gravity;
    int rank;
  } worst{trouble.kind + 0.5 * trouble.value / (1.0 + trouble.value), comm->me};
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  if (worst.gravity <= 0.0) return;
  MPI_Bcast(&trouble, sizeof(trouble), MPI_BYTE, worst.rank, world);
  const Trouble &t = trouble;
  const auto id = (tagint) t.id;
  if (t.kind == Trouble::SMALL)
    error->all(FLERR,
               "Fix lb/ibb: grain {}, new at step {}, has a hydrodynamic radius of {:.3g} cells, "
               "limit {}: use dx <= {:.4g}",
               id, update->ntimestep, t.radius, lbm::RADIUS_LIMIT,
               t.radius * units.dx / lbm::RADIUS_LIMIT);

  std::string what,
      cause = "it is too fast for the fluid time step, or thrown by a contact that is "
              "too stiff for timestep or overlaps from the start; reduce timestep or "
              "every, or lay grains apart";
  if (t.kind == Trouble::MOVED)
    what = fmt::format("moved {:.3g} cells in one fluid step, limit 1", t.value);
  else if (t.kind == Trouble::FAST)
    what = fmt::format("has a surface that moves at {:.4g}, Ma = {:.3g}, limit {}",
                       t.value * units.velocity(), lbm::mach(t.value), lbm::MACH_LIMIT);
  else
    what = "has a place, a velocity or a force that is not a finite number";
  if (t.kind == Trouble::MOVED && t.speed < 0.5 * t.value)
    cause = "it was placed anew; delete a grain and create it instead";
  else if (t.kind == Trouble::NO_NUMBER)
    cause =
        "the fluid around it is unstable, or another fix or the pair style gave it such a force; "
        "use a smaller check to see where it begins";
  else if (fluid_steps == 1 && t.density < 0.5 && t.value < 2.0 * t.speed)
    cause =
        "until the first fluid step so light a grain falls as if there were no water; ramp what "
        "drives it over some fluid steps, or reduce timestep or every";
  else if (t.loose > 0.0)
    cause = cause_of_loose();
  else if (t.kind == Trouble::FAST && t.value - t.speed > t.speed)
    cause = "it spins too fast for the fluid time step; reduce timestep or every";
  error->all(
      FLERR,
      "Fix lb/ibb: stopped at step {}, fluid step {}: grain {} at ({:.6g}, {:.6g}, {:.6g}) {}; "
      "its speed is {:.4g}, radius {:.3g} cells, density {:.3g} rho; tau = {:.4f}. Likely "
      "cause: {}",
      update->ntimestep, fluid_steps, id, t.place[0], t.place[1], t.place[2], what,
      t.speed * units.velocity(), t.radius, t.density, units.tau(options.nu), cause);
}
