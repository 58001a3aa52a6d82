/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Restart files of fix lb/ibb. LAMMPS's own file holds numbers and the grains' memory of the fluid;
// the fluid itself is in FILE.lbibb next to it. Either names the other by step and checksum.

#include "fix_lb_ibb.h"

#include "lbm_neighbours_mpi.h"
#include "lbm_state_file.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <cstddef>
#include <cstring>

using namespace LAMMPS_NS;

// As it is in the file: plain bytes, which LAMMPS reads only on machines of the same kind.
// has_fluid is 0 before the fluid has moved: then it starts anew.
struct FixLbIbb::Saved {
  static constexpr int VERSION = 3;
  int version = VERSION, bytes = sizeof(Saved);
  int has_fluid = 0, columns = SHOWN + COLUMNS, every = 0, obstacles = 0;
  double dx = 0.0, nu = 0.0, rho = 0.0, dt = 0.0;
  bigint fluid_steps = 0, first_step = 0, last_step = 0;
  Drive drive{};
  lbm::Vec3 buoyancy_before{};
  Fastest fastest{};
  std::uint64_t grains_known = 0;
  lbm::Balance::State balance{};
  lbm::StateHeader fluid{};
  std::uint64_t check = 0;    // of all that is before it

  std::uint64_t right_check() const { return lbm::checksum(this, offsetof(Saved, check) / 8); }
};

namespace {

std::string fluid_file(const std::string &restart_file)
{
  return restart_file + ".lbibb";
}

}    // namespace

// ---------------------------------------------------------------------- writing

void FixLbIbb::write_restart(FILE *fp)
{
  auto s = std::make_shared<Saved>();
  if (fluid && has_started()) {
    find_fastest();
    fluid->settle();    // as a run that goes on from here will
    s->has_fluid = 1;
    s->every = nevery;
    s->dx = options.dx;
    s->nu = options.nu;
    s->rho = options.rho;
    s->dt = units.dt;
    s->fluid_steps = fluid_steps;
    s->first_step = first_step;
    s->last_step = last_step;
    s->drive = drive;
    s->buoyancy_before = buoyancy_before;
    s->fastest = fastest;
    s->grains_known = grains_known;
    if (balance) s->balance = balance->settle(*neighbours);
    s->fluid = lbm::describe(*fluid, nodes, update->ntimestep, world);
    s->obstacles = int(found.size());
  }
  s->check = s->right_check();
  to_write = s;
  if (comm->me) return;
  std::vector<SavedObstacle> solid(s->obstacles);
  for (int k = 0; k < s->obstacles; k++) solid[k] = {fluid->obstacles()[k], found[k].checksum};
  const std::uint64_t check =
      lbm::checksum(solid.data(), solid.size() * sizeof(SavedObstacle) / sizeof check);
  const std::size_t more = solid.empty() ? 0 : solid.size() * sizeof(SavedObstacle) + sizeof(check);
  const int bytes = int(sizeof(Saved) + more);
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(s.get(), sizeof(Saved), 1, fp);
  if (solid.empty()) return;
  fwrite(solid.data(), sizeof(SavedObstacle), solid.size(), fp);
  fwrite(&check, sizeof(check), 1, fp);
}

// LAMMPS has closed its own file by then
void FixLbIbb::write_restart_file(const char *file)
{
  const auto s = std::move(to_write);
  if (!s || !s->has_fluid) return;
  const std::string why = lbm::write_state(fluid_file(file), *fluid, s->fluid, world);
  if (!why.empty()) error->all(FLERR, "Fix lb/ibb: the fluid's restart file: {}", why);
}

int FixLbIbb::maxsize_restart()
{
  return 1 + SHOWN + COLUMNS;
}

int FixLbIbb::size_restart(int)
{
  return maxsize_restart();
}

int FixLbIbb::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);
  return 1 + pack_exchange(i, buf + 1);
}

// ---------------------------------------------------------------------- reading

void FixLbIbb::restart(char *buf)
{
  Saved s;
  was_saved = true;
  int head[2];
  std::memcpy(head, buf, sizeof head);
  if (head[0] != Saved::VERSION || head[1] != int(sizeof(Saved)))
    error->all(FLERR,
               "Fix lb/ibb: the restart file has version {} of this fix's data with {} bytes, it "
               "must be version {} with {}: it was written by another version of this package",
               head[0], head[1], int(Saved::VERSION), sizeof(Saved));
  static_assert(std::is_trivially_copyable_v<Saved>);
  std::memcpy(static_cast<void *>(&s), buf, sizeof(Saved));
  if (s.check != s.right_check())
    error->all(FLERR,
               "Fix lb/ibb: the restart file is damaged: the checksum of this fix's data is wrong; "
               "go on from an older one");
  if (s.columns != SHOWN + COLUMNS)
    error->all(FLERR, "Fix lb/ibb: the restart file has {} numbers for each grain, it must be {}",
               s.columns, SHOWN + COLUMNS);
  starts_anew = options.restart == LBOptions::NONE;
  if (starts_anew) return;
  if (!s.has_fluid) {
    if (comm->me == 0)
      utils::logmesg(lmp,
                     "Fix lb/ibb: the restart file was written before the first run: the fluid "
                     "starts at rest\n");
    return;
  }
  if (options.restart.empty())
    error->all(FLERR,
               "Fix lb/ibb: the restart file has a fluid of step {}: name the file with keyword "
               "restart to go on with it, or use restart none to start anew, at rest",
               s.fluid.step);
  auto same = [&](const char *what, double was, double is) {
    if (was != is)
      error->all(FLERR,
                 "Fix lb/ibb: {} was {:.16g} when the restart file was written, now it is {:.16g}: "
                 "keep it, or start anew with restart none",
                 what, was, is);
  };
  same("dx", s.dx, options.dx);
  same("nu", s.nu, options.nu);
  same("rho", s.rho, options.rho);
  same("every", s.every, nevery);
  same("the number of populations of a node", s.fluid.directions, domain->dimension == 2 ? 9 : 19);
  same("the number of bytes of a population (precision)", s.fluid.bytes_of_population,
       options.single ? sizeof(float) : sizeof(double));
  for (int d = 0; d < 3; d++) same("the number of nodes along a side", s.fluid.nodes[d], nodes[d]);
  same("the number of obstacles", s.obstacles, double(options.obstacles.size()));
  same("the step (reset_timestep)", double(s.fluid.step), double(update->ntimestep));
  units.dt = s.dt;
  fluid_steps = s.fluid_steps;
  first_step = s.first_step;
  last_step = s.last_step;
  drive = s.drive;
  buoyancy_before = s.buoyancy_before;
  fastest = s.fastest;
  grains_known = s.grains_known;
  if (balance) balance->resume(s.balance);
  to_go_on = std::make_shared<Saved>(s);
  if (!s.obstacles) return;
  const char *solid = buf + sizeof(Saved);
  obstacles_to_go_on.resize(s.obstacles);
  const std::size_t bytes = obstacles_to_go_on.size() * sizeof(SavedObstacle);
  std::memcpy(static_cast<void *>(obstacles_to_go_on.data()), solid, bytes);
  std::uint64_t check;
  std::memcpy(&check, solid + bytes, sizeof(check));
  if (check != lbm::checksum(obstacles_to_go_on.data(), bytes / sizeof(check)))
    error->all(
        FLERR,
        "Fix lb/ibb: the restart file is damaged: the checksum of its obstacles is wrong; go "
        "on from an older one");
}

void FixLbIbb::unpack_restart(int nlocal, int nth)
{
  if (starts_anew) return;
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(extra[0]);
  unpack_exchange(nlocal, extra + 1);
}

// once there is a lattice to read it into; a * in the name stands for the step
void FixLbIbb::read_fluid()
{
  if (!options.restart.empty() && !starts_anew && !was_saved && !has_started())
    error->all(FLERR,
               "Fix lb/ibb: no restart file was read that has a fluid of a fix with ID {}: use "
               "read_restart before, and the ID that the fix had, or remove keyword restart",
               id);
  if (!to_go_on) return;
  std::string name = options.restart;
  const auto star = name.find('*');
  if (star != std::string::npos) name.replace(star, 1, std::to_string(to_go_on->fluid.step));
  name = fluid_file(name);
  const std::string why = lbm::read_state(name, *fluid, to_go_on->fluid, world);
  if (!why.empty()) error->all(FLERR, "Fix lb/ibb: cannot go on from {}: {}", name, why);
  fluid->settle();
  drive_fluid(drive);
  if (comm->me == 0)
    utils::logmesg(lmp, "Fix lb/ibb: goes on from {}, step {}, fluid step {}\n", name,
                   to_go_on->fluid.step, fluid_steps);
  go_on_with_obstacles();
  to_go_on.reset();
}

// what was solid holds no fluid: the shapes must be those of the file
void FixLbIbb::go_on_with_obstacles()
{
  std::vector<lbm::ObstacleState> states;
  for (std::size_t k = 0; k < obstacles_to_go_on.size(); k++) {
    if (obstacles_to_go_on[k].shape != found[k].checksum)
      error->all(FLERR,
                 "Fix lb/ibb keyword obstacle: region {} is not what it was when the restart file "
                 "was written: define it as it was, or start anew with restart none",
                 options.obstacles[k].region);
    states.push_back(obstacles_to_go_on[k].state);
  }
  fluid->resume_obstacles(states);
  obstacles_to_go_on.clear();
}
