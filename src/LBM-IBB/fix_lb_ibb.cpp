/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "fix_lb_ibb.h"

#include "lb_ibb_fields.h"
#include "lbm_neighbours_mpi.h"
#include "lbm_rules.h"
#include "lbm_state_mpi.h"

#include "atom.h"
#include "citeme.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "input.h"
#include "lb_ibb_citation.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "platform.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;
using lbm::Vec3;

// ---------------------------------------------------------------------- birth and death

FixLbIbb::FixLbIbb(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), units{}, nodes{1, 1, 1}, fluid_steps(0), first_step(-1), last_step(-1),
    history(nullptr), ghosted(nullptr), nghosted(0), survey_step(-1), fastest{},
    warned_of_masses(false), grains_known(0), drive{}, buoyancy_before{}, light(nullptr),
    moving_bits(0), held_bits(0), set_bits(0), tied_bits(0), about(LOADS), was_saved(false),
    starts_anew(false), trouble{}, warned_of_speed(false)
{
  if (lmp->citeme) lmp->citeme->add(LB_IBB_CITATION);
  if (domain->box_exist == 0)
    error->all(FLERR, "Fix lb/ibb: the simulation box must be defined before the fix");
  check_box();
  options = LBOptionsParser(lmp, narg, arg).parse();

  nevery = options.every;
  time_depend = 1;    // LAMMPS refuses reset_timestep: the fluid has its own clock
  dynamic_group_allow = 1;
  scalar_flag = vector_flag = peratom_flag = pergrid_flag = 1;
  size_vector = NUMBERS + LOAD * int(options.obstacles.size());
  extscalar = extvector = 0;
  size_peratom_cols = SHOWN;
  global_freq = peratom_freq = pergrid_freq = 1;
  comm_forward = OUT;
  // LAMMPS sizes its buffers by this, before grains that are light may come
  comm_reverse = options.coupling == LBOptions::EXPLICIT ? +BACK : std::max(+BACK, +TOLD);
  create_attribute = 1;
  restart_global = restart_peratom = restart_file = 1;
  maxexchange = SHOWN + COLUMNS;

  units = {options.dx, options.every * update->dt, options.rho, domain->dimension};
  const char *direction[3] = {"x", "y", "z"};
  for (int d = 0; d < domain->dimension; d++) {
    std::string why;
    nodes[d] = lbm::cells(domain->prd[d], options.dx, direction[d], why);
    if (!nodes[d]) error->all(FLERR, "Fix lb/ibb: {}", why);
  }
  fields = std::make_unique<LBFields>(lmp, nodes);
  provide_balance();

  FixLbIbb::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  for (int i = 0; i < atom->nlocal; i++) FixLbIbb::set_arrays(i);
}

// now already, for what a restart file holds of it
void FixLbIbb::post_constructor()
{
  provide_light();
}

FixLbIbb::~FixLbIbb()
{
  if (copymode) return;
  if (light && modify->nfix) modify->delete_fix(std::string(id) + "_LIGHT");
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(array_atom);
  memory->destroy(history);
  memory->destroy(ghosted);
}

int FixLbIbb::setmask()
{
  return POST_FORCE | END_OF_STEP | POST_RUN;
}

// the fluid is not advanced here: "run 0" and repeated runs leave it alone
void FixLbIbb::setup(int)
{
  review_setup();
  if (grains_changed() && balance) balance->forget();
  share_volumes();
  share_nodes();
  if (balance && !keeps_momentum()) balance->forget();
  warned_of_speed = false;
  survey_step = -1;    // forces may have changed, and the velocity has half of one in it
  start_clock();
  // The velocities are to be integrated with the forces that were there when the last run ended:
  // if it ended with a fluid step, those of before.
  const bool before = update->ntimestep == last_step;
  if (before)
    add_forces(history, buoyancy_before);
  else
    add_forces(array_atom, drive.buoyancy);
  yield(true, before);
}

// ---------------------------------------------------------------------- the step

// every granular step: the force of the last fluid steps is held
void FixLbIbb::post_force(int)
{
  add_forces(array_atom, drive.buoyancy);
  yield(false, false);
}

// held[i]: force and torque
void FixLbIbb::add_forces(double **held, const Vec3 &gravity)
{
  double **f = atom->f, **torque = atom->torque;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (int d = 0; d < 3; d++) {
      f[i][d] += held[i][FORCE + d];
      torque[i][d] += held[i][TORQUE + d];
    }
    if (options.has_buoyancy) {
      const double mass = options.rho * displaced_volume(i);
      for (int d = 0; d < 3; d++) f[i][d] -= mass * gravity[d];
    }
  }
}

// every nevery granular steps, positions and velocities are those of the full step: one fluid step
void FixLbIbb::end_of_step()
{
  const double start = platform::walltime();
  if (!clock.running) start_clock();
  buoyancy_before = drive.buoyancy;
  drive = evaluate_all();
  check_faces();
  if (balance) balance->start(driving_force(drive));
  drive_fluid(drive);
  if (grains_changed()) {
    share_volumes();
    check_discs();
    provide_light();
    if (balance) balance->forget();
  }
  correct_fluid();
  place_grains();
  const double placed = platform::walltime();
  fluid->follow(spheres);
  if (fluid_steps % options.check == 0) fluid->inspect();
  fluid->advance(loads);
  const double advanced = platform::walltime();
  give_forces();
  fluid_steps++;
  last_step = update->ntimestep;
  clock.fluid += advanced - placed;
  clock.grains += placed - start + platform::walltime() - advanced;
  survey_step = -1;
  stop_for_trouble();
  const bool output_follows = output->next < update->ntimestep + nevery;
  if (fluid_steps % options.check == 0 || output_follows) take_survey();
  if (balance) keep_momentum();
}

double FixLbIbb::evaluate(const LBValue &value)
{
  if (value.variable.empty()) return value.constant;
  const double x = input->variable->compute_equal(input->variable->find(value.variable.c_str()));
  if (!std::isfinite(x))
    error->all(FLERR, "Fix lb/ibb: variable {} is {} at step {}", value.variable, x,
               update->ntimestep);
  return x;
}

FixLbIbb::Drive FixLbIbb::evaluate_all()
{
  modify->clearstep_compute();
  Drive now{};
  for (int d = 0; d < 3; d++) {
    now.gradp[d] = evaluate(options.gradp[d]);
    now.buoyancy[d] = evaluate(options.buoyancy[d]);
    now.force[d] = options.rho * evaluate(options.accel[d]) - now.gradp[d];
  }
  double low = 0.0, high = 0.0;
  for (int d = 0; d < domain->dimension; d++)
    for (int side = 0; side < 2; side++) {
      Vec3 &u = now.u[d][side];
      for (int k = 0; k < 3; k++) u[k] = evaluate(options.face[d][side].u[k]);
      now.face_speed = std::max(now.face_speed, std::sqrt(lbm::dot(u, u)));
      const double p = now.p[d][side] = evaluate(options.face[d][side].p);
      low = std::min(low, p);
      high = std::max(high, p);
    }
  now.pressure_difference = high - low;
  const bigint fluid_step = update->ntimestep - update->ntimestep % nevery;
  modify->addstep_compute(fluid_step + nevery);
  return now;
}

static Vec3 divided(Vec3 v, double unit)
{
  for (double &component : v) component /= unit;
  return v;
}

// on a node
Vec3 FixLbIbb::driving_force(const Drive &with) const
{
  return divided(with.force, units.force_density());
}

void FixLbIbb::drive_fluid(const Drive &with)
{
  Vec3 force = driving_force(with);
  for (int d = 0; balance && d < domain->dimension; d++) force[d] += balance->force()[d];
  fluid->set_force(force);
  for (int d = 0; d < domain->dimension; d++)
    for (int side = 0; side < 2; side++)
      fluid->set_face(d, side, divided(with.u[d][side], units.velocity()),
                      units.density_excess(with.p[d][side]));
}

// variables may have gone where no run would have been allowed to start
void FixLbIbb::check_faces()
{
  if (units.density_excess(drive.pressure_difference) <= lbm::EXCESS_LIMIT &&
      drive.face_speed <= lbm::MACH_LIMIT * units.sound_speed())
    return;
  for (const auto &finding :
       lbm::review({units, options.nu, nevery, drive.pressure_difference, drive.face_speed, 0.0}))
    if (finding.fatal)
      error->all(FLERR, "Fix lb/ibb: stopped at step {}, fluid step {}: {}", update->ntimestep,
                 fluid_steps, finding.text);
}

double FixLbIbb::hydrodynamic_radius(int i) const
{
  return atom->radius[i] - options.shrink;
}

double FixLbIbb::drawn_radius(int i) const
{
  const double r = hydrodynamic_radius(i) / units.dx;
  return radii ? radii->drawn(r) : r;
}

// ---------------------------------------------------------------------- per-grid data

// LAMMPS 4 Feb 2025 and 4 Jul 2026: fix ave/grid follows no new sub-domains, it crashes
void FixLbIbb::check_averages()
{
  for (auto *other : modify->get_fix_by_style("^ave/grid"))
    error->all(FLERR,
               "Fix lb/ibb: fix {} ({}) of LAMMPS crashes when sub-domains change: unfix it before "
               "balance, or do without fix balance",
               other->id, other->style);
}

void FixLbIbb::reset_grid()
{
  if (!fields->cut_changed()) return;
  check_averages();
  fields = std::make_unique<LBFields>(lmp, nodes);
  if (!fluid) return;
  check_cut();
  if (!has_started()) return create_fluid();
  lbm::Carried carried(*fluid, {fields->lo(), fields->n()}, world);
  const auto obstacles = fluid->obstacles();
  create_fluid();
  carried.into(*fluid);
  fluid->resume_obstacles(obstacles);
  fluid->settle();
  drive_fluid(drive);
}

int FixLbIbb::get_grid_by_name(const std::string &name, int &dim)
{
  dim = domain->dimension;
  return name == "grid" ? 0 : -1;
}

void *FixLbIbb::get_grid_by_index(int index)
{
  return index == 0 ? fields->grid() : nullptr;
}

int FixLbIbb::get_griddata_by_name(int igrid, const std::string &name, int &ncol)
{
  return igrid == 0 ? LBFields::find(name, ncol) : -1;
}

void *FixLbIbb::get_griddata_by_index(int index)
{
  if (!fluid) error->all(FLERR, "Fix lb/ibb: fields exist from the first run on: use run 0 before");
  return fields->compute(index, *fluid, units);
}

lbm::Part FixLbIbb::own_nodes() const
{
  return {fields->lo(), fields->n()};
}

std::vector<float> FixLbIbb::sample(int field, const lbm::Sample &which)
{
  take_survey();
  return fields->sample(field, which, *fluid, units);
}

double FixLbIbb::memory_usage()
{
  return (fluid ? fluid->bytes() : 0.0) + fields->memory_usage() +
      sizeof(double) * (double(atom->nmax) * (SHOWN + COLUMNS) + double(nghosted) * OUT);
}
