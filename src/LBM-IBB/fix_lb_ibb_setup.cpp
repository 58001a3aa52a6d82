/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Set-up of fix lb/ibb: what a scene must and must not have, and what it will cost.

#include "fix_lb_ibb.h"

#include "lb_ibb_fields.h"
#include "lbm_neighbours_mpi.h"
#include "lbm_rules.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"
#include "variable.h"

#include <cmath>

using namespace LAMMPS_NS;
using lbm::Vec3;

bool FixLbIbb::has_started() const
{
  return fluid_steps > 0 || (first_step >= 0 && update->ntimestep > first_step);
}

void FixLbIbb::init()
{
  check_scene();
  check_order_of_fixes();
  warned_of_masses = false;
  find_integrators();
  check_discs();
  provide_light();
  if (starts_anew && !has_started()) forget_light();
  find_variables();
  if (has_started()) reset_dt();
  if (!has_started() || !fluid) create_fluid();
  if (options.calibrated && !has_started())
    radii = std::make_unique<LBRadius>(lmp, options.link_name(), units.tau(options.nu));
  check_obstacles();
  read_fluid();
  provide_ghosts();
}

// a change of timestep between runs, or within a run by another fix
void FixLbIbb::reset_dt()
{
  if (has_started() && units.dt != nevery * update->dt)
    error->all(FLERR,
               "Fix lb/ibb: the fluid has run with timestep {:.8g} and cannot go on with {:.8g}: "
               "keep it, or define the fix anew",
               units.dt / nevery, update->dt);
}

// also when the fix is defined: the length of such boxes is no number of cells
void FixLbIbb::check_box()
{
  if (domain->triclinic) error->all(FLERR, "Fix lb/ibb does not support triclinic boxes");
  if (domain->nonperiodic == 2)
    error->all(FLERR, "Fix lb/ibb does not support shrink-wrapped boxes: use boundary style f");
}

void FixLbIbb::check_scene()
{
  if (update->whichflag == 2) error->all(FLERR, "Fix lb/ibb cannot be used with minimisation");
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Fix lb/ibb cannot be used with run_style respa");
  check_box();
  if (domain->box_change_size || domain->box_change_shape)
    error->all(FLERR, "Fix lb/ibb does not support a changing box: remove the fix that changes it");
  if (domain->box_change_domain && comm->nprocs > 1) check_averages();
  for (int d = 0; d < domain->dimension; d++) {
    std::string why;
    if (lbm::cells(domain->prd[d], options.dx, "a side", why) != nodes[d])
      error->all(FLERR,
                 "Fix lb/ibb: the box has changed since the fix was defined; define it anew");
    for (int side = 0; side < 2; side++)
      if (domain->periodicity[d] != (options.face[d][side].kind == lbm::FaceKind::PERIODIC))
        error->all(FLERR, "Fix lb/ibb: the boundary command was used after the fix was defined");
  }
  check_cut();
  if (comm->mode != Comm::SINGLE) error->all(FLERR, "Fix lb/ibb needs comm_modify mode single");
  if (force->ftm2v != 1.0 || force->nktv2p != 1.0)
    error->all(FLERR,
               "Fix lb/ibb: units {} have hidden conversion factors: use units si, cgs, lj, "
               "micro or nano",
               update->unit_style);
  if (group->count(igroup) > 0 && !(atom->radius_flag && atom->omega_flag && atom->torque_flag))
    error->all(FLERR, "Fix lb/ibb: grains need radius, omega and torque: use atom_style sphere");

  for (const char *style : {"^lb/ibb$", "^lb/fluid"})
    for (auto *other : modify->get_fix_by_style(style))
      if (other != this)
        error->all(FLERR, "Fix lb/ibb: only one fluid can fill the box: unfix {} or {}", id,
                   other->id);
  for (auto *other : modify->get_fix_list()) {
    if (utils::strmatch(other->style, "^dt/reset"))
      error->all(FLERR,
                 "Fix lb/ibb cannot be used with fix {}: the fluid needs a constant time step",
                 other->style);
    if (other->diam_flag)
      error->all(FLERR,
                 "Fix lb/ibb: fix {} changes radii, which the fluid does not follow: unfix it",
                 other->id);
  }
  check_offset();
  if (first_step < 0) first_step = update->ntimestep;
  if (first_step % nevery)
    error->all(
        FLERR,
        "Fix lb/ibb: the first run starts at step {}, which is no multiple of every = {}: "
        "the first fluid step would be too short; use reset_timestep before the fix, or run to a "
        "multiple",
        first_step, nevery);
  if (last_step >= 0 &&
      (update->ntimestep < last_step || update->ntimestep >= last_step + 2 * nevery))
    error->all(FLERR,
               "Fix lb/ibb: the last fluid step was at step {}, now it is step {}: the time step "
               "counter was changed",
               last_step, update->ntimestep);
}

// radii made smaller for the fluid and larger for contacts would do the same thing twice
void FixLbIbb::check_offset()
{
  if (options.shrink == 0.0) return;
  auto check = [&](void *offset, const std::string &what) {
    if (offset && *(double *) offset > 0.0)
      error->all(FLERR,
                 "Fix lb/ibb: shrink {} and the contact offset {} of {} are two ways of the same "
                 "thing: use one",
                 options.shrink, *(double *) offset, what);
  };
  int dim;
  if (force->pair)
    check(force->pair->extract("offset", dim), fmt::format("pair style {}", force->pair_style));
  for (auto *other : modify->get_fix_by_style("^wall/gran"))
    check(other->extract("offset", dim), fmt::format("fix {}", other->id));
}

// forces are added in the order of the fixes: those that overrule forces must come later
void FixLbIbb::check_order_of_fixes()
{
  for (auto *other : modify->get_fix_list()) {
    if (other == this) return;
    if (utils::strmatch(other->style, "^rigid") && comm->me == 0)
      error->warning(FLERR,
                     "Fix {} ({}) is defined before fix lb/ibb and does not see its forces at the "
                     "start of a run, nor at all with bodyforces early: define it after",
                     other->id, other->style);
    bool overrules = false;    // by suffixes too, e.g. freeze/kk
    for (const char *style : {"^freeze", "^setforce", "^enforce2d"})
      overrules = overrules || utils::strmatch(other->style, style);
    if (overrules && comm->me == 0)
      error->warning(FLERR,
                     "Fix {} ({}) is defined before fix lb/ibb and does not see its forces: "
                     "define it after",
                     other->id, other->style);
  }
}

void FixLbIbb::find_variables()
{
  auto check = [&](const LBValue &value) {
    if (value.variable.empty()) return;
    const int i = input->variable->find(value.variable.c_str());
    if (i < 0)
      error->all(FLERR, "Fix lb/ibb: variable {} does not exist: define it before the run",
                 value.variable);
    if (!input->variable->equalstyle(i))
      error->all(FLERR, "Fix lb/ibb: variable {} is not of style equal: define it as such",
                 value.variable);
  };
  for (int d = 0; d < 3; d++) {
    check(options.accel[d]);
    check(options.gradp[d]);
    check(options.buoyancy[d]);
    for (const LBFace &face : options.face[d]) {
      check(face.p);
      for (const LBValue &u : face.u) check(u);
    }
  }
}

// every rank needs a brick of nodes, whose neighbours are bricks of the same width and height
void FixLbIbb::check_cut()
{
  if (comm->layout == Comm::LAYOUT_TILED)
    error->all(FLERR,
               "Fix lb/ibb needs sub-domains in rows and columns, not those of balance rcb: the "
               "fluid has one neighbour across every face; balance with style shift");
  if (comm->style == Comm::TILED && !force->newton)
    error->all(FLERR, "Fix lb/ibb: comm_style tiled needs newton on; or use comm_style brick");
  const lbm::Int3 n = fields->n();
  int empty = n[0] < 1 || n[1] < 1 || n[2] < 1, any;
  MPI_Allreduce(&empty, &any, 1, MPI_INT, MPI_MAX, world);
  if (any)
    error->all(FLERR,
               "Fix lb/ibb: {} x {} x {} ranks are too many for {} x {} x {} lattice nodes: each "
               "needs at least one along every direction; see the processors command",
               comm->procgrid[0], comm->procgrid[1], comm->procgrid[2], nodes[0], nodes[1],
               nodes[2]);
}

void FixLbIbb::create_fluid()
{
  units.dt = nevery * update->dt;
  const lbm::Int3 n = fields->n();
  std::array<std::array<int, 2>, 3> rank{};
  lbm::Settings s;
  for (int d = 0; d < 3; d++)
    for (int side = 0; side < 2; side++) {
      const bool end = comm->myloc[d] == (side == 0 ? 0 : comm->procgrid[d] - 1);
      rank[d][side] = (end && !domain->periodicity[d]) ? MPI_PROC_NULL : comm->procneigh[d][side];
      s.faces[d][side].kind = options.face[d][side].kind;
      s.faces[d][side].parabolic = options.face[d][side].parabolic;
    }
  s.dimension = domain->dimension;
  s.tau = units.tau(options.nu);
  s.bgk = options.bgk;
  s.regularised = options.regularised;
  s.single = options.single;
  s.magic = options.magic;
  s.link = options.link;
  s.refill = options.refill;
  s.ledger = s.hold_mean = options.conserve;
  // a single message for what no user can mend but by other numbers
  for (const auto &finding : lbm::review({units, options.nu, nevery, 0.0, 0.0, 0.0}))
    if (finding.fatal)
      error->all(FLERR, "Fix lb/ibb: {} (see doc/src/Howto_lbm_ibb.rst)", finding.text);
  fluid.reset();    // it refers to the neighbours, and two fluids may not fit into memory
  neighbours = std::make_unique<lbm::MpiNeighbours>(world, rank);
  try {
    fluid = lbm::Fluid::create(s, fields->lo(), n, nodes, *neighbours);
  } catch (std::exception &failure) {
    error->one(FLERR,
               "Fix lb/ibb: no room for {} x {} x {} nodes on one rank ({}): use more ranks, or a "
               "larger dx",
               n[0], n[1], n[2], failure.what());
  }
  make_obstacles();
}

// radii over all ranks, and of grains that other fixes will insert
double FixLbIbb::largest_radius(double &smallest)
{
  double extremes[2] = {0.0, -1e300};
  if (atom->radius_flag)
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & groupbit) {
        extremes[0] = std::max(extremes[0], atom->radius[i] - options.shrink);
        extremes[1] = std::max(extremes[1], options.shrink - atom->radius[i]);
      }
  for (auto *other : modify->get_fix_list())
    for (int type = 1; type <= atom->ntypes; type++) {
      int itype = type;
      auto *r = (double *) other->extract("radius", itype);
      if (r && *r > 0.0) extremes[0] = std::max(extremes[0], *r - options.shrink);
    }
  MPI_Allreduce(MPI_IN_PLACE, extremes, 2, MPI_DOUBLE, MPI_MAX, world);
  smallest = extremes[1] > -1e300 ? -extremes[1] : 0.0;
  return extremes[0];
}

// every rank must know the grains that cover its nodes and its neighbours' next to them
void FixLbIbb::provide_ghosts()
{
  double smallest;
  const double largest = largest_radius(smallest);
  if (largest <= 0.0) return;
  for (int d = 0; d < domain->dimension; d++)    // its images would be without number
    if (domain->periodicity[d] && largest > domain->prd[d])
      error->all(FLERR,
                 "Fix lb/ibb: the largest hydrodynamic radius, {:.6g}, is larger than the periodic "
                 "box, {:.6g} "
                 "along {}: set diameters (LAMMPS gives atoms a diameter of 1)",
                 largest, domain->prd[d], "xyz"[d]);
  // what overlaps a grain of a clump, for its volume, may lie further away than what covers a node
  const bool clumps = has_clumps() && largest > 2.0 * options.dx;
  const double need = largest + (clumps ? largest : 2.0 * options.dx) + neighbor->skin;
  const double have =
      std::max(comm->cutghostuser, force->pair ? force->pair->cutforce + neighbor->skin : 0.0);
  if (need <= have) return;
  comm->cutghostuser = need;
  if (comm->me == 0)
    utils::logmesg(lmp, "Fix lb/ibb: raised the ghost cutoff from {:.6g} to {:.6g} ({} + skin)\n",
                   have, need, clumps ? "twice the largest radius" : "largest radius + 2 dx");
}

// rules that need the state at the start of a run: variables, radii
void FixLbIbb::review_setup()
{
  const Drive now = evaluate_all();
  if (!has_started()) {    // later values wait for the next fluid step
    drive = now;
    drive_fluid(now);
    fluid->fill(0.0);    // at rest under the force that acts
  }
  lbm::Plan plan{units,
                 options.nu,
                 nevery,
                 now.pressure_difference,
                 now.face_speed,
                 0.0,
                 std::hypot(now.force[0], now.force[1], now.force[2]) / options.rho,
                 obstacle_speed()};
  const double largest = largest_radius(plan.smallest_radius);
  if (plan.smallest_radius <= 0.0 && atom->radius_flag && group->count(igroup) > 0)
    error->all(
        FLERR,
        "Fix lb/ibb: smallest hydrodynamic radius is {} (atom radius - shrink {}): it must be "
        "larger than 0",
        plan.smallest_radius, options.shrink);
  for (const auto &finding : lbm::review(plan)) {
    if (finding.fatal)
      error->all(FLERR, "Fix lb/ibb: {} (see doc/src/Howto_lbm_ibb.rst)", finding.text);
    if (comm->me == 0) error->warning(FLERR, "Fix lb/ibb: {}", finding.text);
  }
  warn_of_loose();
  print_summary(plan.smallest_radius, largest, now.pressure_difference);
}
