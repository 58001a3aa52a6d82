/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What fix lb/ibb writes to the log before and after a run.

#include "fix_lb_ibb.h"

#include "lb_ibb_accuracy.h"
#include "lbm_neighbours_mpi.h"

#include "comm.h"
#include "domain.h"
#include "group.h"
#include "platform.h"
#include "update.h"

using namespace LAMMPS_NS;

// of the coarsest grain; the table was measured with the default rules
std::string FixLbIbb::expected_errors(double smallest)
{
  if (domain->dimension == 2 || options.bgk || options.link != lbm::LinkRule::CLI || radii)
    return "";
  std::string why;
  const lbm::Accuracy accuracy = read_accuracy(lmp, why);
  if (accuracy.empty()) return fmt::format("  errors to expect are not known: {}\n", why);
  const double r = smallest / options.dx;
  return fmt::format(
      "  errors to expect at {:.3g} cells per radius, from lone grains to dense beds: {}\n", r,
      accuracy.errors(r));
}

// what the run will do, what it will cost, and what it leaves out
void FixLbIbb::print_summary(double smallest, double largest, double pressure_difference)
{
  static const char *refill[] = {"grad", "normal", "local", "equilibrium"};
  double bytes = fluid->bytes(), most;
  MPI_Allreduce(&bytes, &most, 1, MPI_DOUBLE, MPI_MAX, world);
  const bool grains = group->count(igroup) > 0 || largest > 0.0;

  std::string text = fmt::format(
      "Fix lb/ibb: {} x {} x {} nodes of dx = {:.6g}, {}{}, collision {}\n"
      "  fluid step = {} x timestep = {:.6g}, tau = {:.5f}; Ma = 0.1 at speed {:.4g}, limit 0.3 at "
      "{:.4g}\n",
      nodes[0], nodes[1], nodes[2], options.dx, domain->dimension == 2 ? "D2Q9" : "D3Q19",
      options.single ? " in single precision" : "",
      options.bgk               ? "bgk"
          : options.regularised ? "regularised"
                                : fmt::format("trt, Lambda = {:.5g}", options.magic),
      nevery, units.dt, units.tau(options.nu), 0.1 * units.sound_speed(),
      0.3 * units.sound_speed());
  for (int d = 0; d < domain->dimension; d++)
    if (options.face[d][0].kind == lbm::FaceKind::PRESSURE &&
        options.face[d][1].kind == lbm::FaceKind::PRESSURE)
      text += fmt::format("  pressure planes along {} are {:.8g} apart (box length - dx){}\n",
                          "xyz"[d], domain -> prd[d] - options.dx,
                          // measured: a staggered momentum (-1)^(x+t) is then never damped
                          nodes[d] % 2 == 0 ? ""
                                            : "; start slowly: with an odd number of nodes between "
                                              "them a sudden start rings on every step");
  if (pressure_difference > 0.0)
    text += fmt::format("  pressure difference now {:.6g}: density change {:.3g} %\n",
                        pressure_difference, 100.0 * units.density_excess(pressure_difference));
  if (grains)
    text += fmt::format(
        "  grains: {:.4g} to {:.4g} cells per diameter; links {}, refill {}, force {}{}{}\n",
        2.0 * smallest / options.dx, 2.0 * largest / options.dx, options.link_name(),
        refill[(int) options.refill],
        options.average ? "mean of two fluid steps" : "of the last fluid step",
        options.link == lbm::LinkRule::HALFWAY ? ""
            : options.conserve                 ? "; mass that links swallow given back"
                                               : "; mass that links swallow lost",
        keeps_momentum() ? "; momentum of the whole kept" : "");
  if (smallest > 0.0) text += expected_errors(smallest);
  if (grains && radii)
    text += fmt::format(
        "  radii calibrated: the fluid takes {:.5g} cells for {:.5g}, {:.5g} for {:.5g}\n",
        radii->drawn(smallest / options.dx), smallest / options.dx,
        radii->drawn(largest / options.dx), largest / options.dx);

  if (const bigint yielding = light_grains())
    text += fmt::format(
        "  {} light grains answer to the fluid within its step: implicit coupling\n", yielding);

  text += describe_obstacles();

  std::string absent;
  auto has = [&](bool present, const char *name) {
    if (!present) absent += std::string(name) + ", ";
  };
  bool wall = false, open = false, force = options.has_gradp;
  for (int d = 0; d < 3; d++) {
    force = force || !options.accel[d].zero();
    for (const LBFace &face : options.face[d]) {
      wall = wall || face.kind == lbm::FaceKind::WALL;
      open = open || face.kind == lbm::FaceKind::PRESSURE || face.kind == lbm::FaceKind::VELOCITY;
    }
  }
  has(grains, "grains");
  has(wall, "walls");
  has(open, "open faces");
  has(force, "body force");
  has(options.has_buoyancy, "buoyancy");
  has(comm->nprocs > 1, "messages between ranks");
  text +=
      fmt::format("  memory {:.4g} MiB on the fullest rank{}; left out: {}fields until asked for\n",
                  most / 1048576.0, grains && !has_started() ? " without grains" : "", absent);
  if (comm->me == 0) utils::logmesg(lmp, text);
}

void FixLbIbb::start_clock()
{
  clock = {true, fluid_steps, platform::walltime()};
}

double FixLbIbb::speed() const
{
  const double seconds = clock.running ? platform::walltime() - clock.start : clock.loop;
  const double updates = double(fluid_steps - clock.first) * nodes[0] * double(nodes[1]) * nodes[2];
  return seconds > 0.0 ? updates / seconds * 1e-6 : 0.0;
}

// LAMMPS's own timers know no fluid: it is part of "Modify" there
void FixLbIbb::post_run()
{
  if (!clock.running) return;
  clock.running = false;
  clock.loop = platform::walltime() - clock.start;
  const auto steps = double(fluid_steps - clock.first);
  if (steps < 1.0) return;
  double mine[3] = {clock.fluid, clock.grains, fluid->bytes()}, most[3];
  MPI_Allreduce(mine, most, 3, MPI_DOUBLE, MPI_MAX, world);
  const double links = compute_vector(12);
  const lbm::RefillCount &r = fluid->refilled();
  double refilled[3] = {double(r.grad), double(r.equilibrium), double(r.deep)};
  const std::string ledger = ledger_report();
  double gaps = fluid->gaps();
  neighbours->sum(refilled, 3);
  neighbours->sum(&gaps, 1);
  if (comm->me) return;
  std::string text =
      fmt::format("Fix lb/ibb: {:.0f} fluid steps, {:.4g} M nodes/s over the whole loop; fluid "
                  "{:.1f} %, grains in and "
                  "out {:.1f} % of the time\n",
                  steps, speed(), 100.0 * most[0] / clock.loop, 100.0 * most[1] / clock.loop);
  if (links > 0.0) {
    text += fmt::format(
        "  {:.0f} cut links, {:.0f} of them closed in pairs in gaps of one node; nodes refilled so "
        "far: {:.0f} by rule, {:.0f} by arriving density, {:.0f} at that around a grain; memory "
        "{:.4g} "
        "MiB on the fullest rank\n",
        links, 2.0 * gaps, refilled[0], refilled[1], refilled[2], most[2] / 1048576.0);
    text += ledger;
  }
  utils::logmesg(lmp, text);
}
