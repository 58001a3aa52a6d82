/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// lb/plan: what the run will cost, what is printed, and the variables.

#include "lb_plan.h"

#include "lb_plan_granular.h"
#include "lbm_neighbours_mpi.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "input.h"
#include "variable.h"

#include <cmath>

using namespace LAMMPS_NS;

// ---------------------------------------------------------------------- the cost

// as the box is cut, or with the least surface if there is none yet
lbm::Int3 LBPlan::local_nodes(const lbm::Int3 &nodes) const
{
  auto share = [&](const int *grid) {
    lbm::Int3 n;
    for (int d = 0; d < 3; d++) n[d] = (nodes[d] + grid[d] - 1) / grid[d];
    return n;
  };
  if (domain->box_exist) return share(comm->procgrid);
  lbm::Int3 best = nodes;
  double least = 1e300;
  for (int x = 1; x <= comm->nprocs; x++)
    for (int y = 1; x * y <= comm->nprocs; y++) {
      if (comm->nprocs % (x * y)) continue;
      const int grid[3] = {x, y, comm->nprocs / (x * y)};
      if (wish.dimension == 2 && grid[2] > 1) continue;
      const lbm::Int3 n = share(grid);
      const double surface = double(n[0]) * n[1] + double(n[1]) * n[2] + double(n[0]) * n[2];
      if (surface >= least) continue;
      least = surface;
      best = n;
    }
  return best;
}

lbm::Pace LBPlan::pace(const lbm::Advice &advice, const lbm::Int3 &n)
{
  lbm::PaceSample sample;
  sample.dimension = wish.dimension;
  sample.single = single;
  sample.tau = advice.tau;
  sample.n = n;
  sample.radius = wish.mean / advice.units.dx;
  sample.fraction = std::max(0.05, wish.fraction);
  sample.moving = moving;
  std::array<std::array<int, 2>, 3> rank{};
  rank.fill({comm->me, comm->me});
  rank[wish.dimension - 1] = {(comm->me + comm->nprocs - 1) % comm->nprocs,
                              (comm->me + 1) % comm->nprocs};
  lbm::MpiNeighbours neighbours(world, rank);
  try {
    return lbm::measure_pace(sample, comm->me, comm->nprocs, neighbours);
  } catch (std::exception &failure) {
    error->one(FLERR, "lb/plan: the speed cannot be measured ({}): use measure no", failure.what());
  }
}

LBPlan::Cost LBPlan::cost(const lbm::Advice &advice)
{
  Cost c;
  if (!advice.nodes[0] || !measure) return c;
  const lbm::Int3 n = local_nodes(advice.nodes);
  const double dx = advice.units.dx;
  c.pace = pace(advice, n);
  c.work.nodes = double(n[0]) * n[1] * n[2];
  // proportional to the square of the radius in 3d, to the radius in 2d
  const double mean_square = wish.dimension == 2 ? wish.mean * wish.mean : square / grains;
  c.work.links = lbm::links_of_sphere(std::sqrt(mean_square) / dx, wish.dimension) * grains *
      (square > 0.0 ? crowded / square : 0.0);
  if (has("contact") && moving) c.work.granular = seconds_of_granular_step(lmp, grains);
  c.memory = c.pace.bytes * double(lbm::Layout({}, n, wish.dimension).size) / 1048576.0;
  c.seconds = lbm::seconds_of_run(advice, c.work, c.pace);
  return c;
}

// ---------------------------------------------------------------------- what is printed

std::string LBPlan::report(const lbm::Advice &a, const Cost &c, const lbm::Accuracy &accuracy) const
{
  const double dx = a.units.dx, cs = a.units.sound_speed();
  const int D = wish.dimension;
  std::string text = fmt::format("lb/plan: dx = {:.8g}: {}\n", dx, a.binds_dx);
  text += fmt::format("  grains: {:.4g} cells per smallest diameter, {:.4g} per mean\n",
                      2.0 * wish.smallest / dx, 2.0 * wish.mean / dx);
  text += fmt::format("  fluid step = {:.6g}, tau = {:.5f}: {}\n", a.units.dt, a.tau, a.binds_dt);
  if (wish.contact > 0.0)
    text += fmt::format("  every = {}, timestep = {:.6g}: a contact lasts {:.4g}, a step at most a "
                        "fiftieth of it for restitution right to a percent\n",
                        a.every, a.step, wish.contact / GranLSD::STEP_GOOD);
  else
    text += fmt::format("  every = 1, timestep = {:.6g}: no contacts are known\n", a.step);
  if (a.speed > 0.0)
    text += fmt::format("  Ma = {:.4g} at speed {:.4g}; Ma = 0.1 at {:.4g}\n", a.mach, a.speed,
                        lbm::MACH_WARN * cs);
  if (wish.pressure > 0.0)
    text += fmt::format("  density change {:.3g} % by the pressure {:.6g}; 5 % by {:.4g}\n",
                        100.0 * a.excess, wish.pressure, a.units.gauge_pressure(lbm::EXCESS_WARN));
  if (a.grid_error > 0.0) {
    text += fmt::format("  expected error of {}: {:.3g} %, of it {:.3g} by the lattice, {:.3g} by "
                        "compressibility\n",
                        wish.quantity, 100.0 * a.error(), 100.0 * a.grid_error,
                        100.0 * a.compressibility);
    if (moving && accuracy.knows("moving_rms"))
      text += fmt::format("  force on a moving grain fluctuates by {:.3g} % (rms) of its drag\n",
                          100.0 * accuracy.error("moving_rms", wish.smallest / dx, wish.fraction));
  }
  if (a.diffusion > 0.0)
    text += fmt::format("  pressure takes {:.4g} through the bed of height {:.4g} and permeability "
                        "{:.3g}: what is to be seen must be slower\n",
                        a.diffusion, wish.height, a.permeability);
  if (a.nodes[0]) {
    double longest = 0.0;
    for (int d = 0; d < D; d++) longest = std::max(longest, wish.box[d]);
    text +=
        fmt::format("  sound takes {:.4g} through the box: ramp pressures and speeds over {:.4g}\n",
                    longest / cs, 5.0 * longest / cs);
    text += fmt::format("  {} x {} x {} nodes, {:.4g} M\n", a.nodes[0], a.nodes[1], a.nodes[2],
                        1e-6 * a.nodes[0] * a.nodes[1] * a.nodes[2]);
  } else {
    text += "  no box: nodes, memory and seconds are not known\n";
  }
  if (c.pace.node > 0.0) {
    text += fmt::format("  memory {:.4g} MiB on the fullest of {} ranks\n", c.memory, comm->nprocs);
    text += fmt::format("  measured on {} ranks: {:.3g} ns a node, {:.3g} ns a link, {:.3g} us a "
                        "granular step\n",
                        comm->nprocs, 1e9 * c.pace.node, 1e9 * c.pace.link, 1e6 * c.work.granular);
    if (wish.time > 0.0)
      text += fmt::format("  {:.6g} fluid steps for a time of {:.6g}: {:.3g} s, without output\n",
                          a.fluid_steps, wish.time, c.seconds);
  }
  for (const std::string &note : a.notes) text += "  note: " + note + "\n";
  text +=
      fmt::format("  take: timestep ${{{0}_dt}}; fix ID group lb/ibb dx ${{{0}_dx}} nu {1:.8g} rho "
                  "{2:.8g} every ${{{0}_every}} ...\n",
                  prefix, wish.nu, wish.rho);
  return text;
}

// all of them, also those that are not known: what an earlier call left would be wrong
void LBPlan::define(const lbm::Advice &a, const Cost &c)
{
  const std::pair<const char *, double> values[] = {
      {"dx", a.units.dx},
      {"dt", a.step},
      {"every", a.every},
      {"tau", a.tau},
      {"dt_fluid", a.units.dt},
      {"mach", a.mach},
      {"excess", a.excess},
      {"error", a.error()},
      {"lattice", a.grid_error},
      {"diffusion", a.diffusion},
      {"steps", a.fluid_steps * a.every},
      {"nodes", double(a.nodes[0]) * a.nodes[1] * a.nodes[2]},
      {"memory", c.memory},
      {"seconds", c.seconds}};
  Variable *variable = input->variable;
  for (const auto &[name, value] : values) {
    const std::string full = prefix + "_" + name;
    const int there = variable->find(full.c_str());
    if (there >= 0 && !variable->internalstyle(there))
      error->all(FLERR,
                 "lb/plan: variable {} is there and of another style: delete it, or use prefix",
                 full);
    if (there >= 0)    // "variable internal" would not change it
      variable->internal_set(there, value);
    else
      variable->set(fmt::format("{} internal {:.17g}", full, value));
  }
}
