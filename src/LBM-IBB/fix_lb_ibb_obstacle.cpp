/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Obstacles of fix lb/ibb: regions handed to the fluid as shapes, what is refused of them, and what
// the fluid does to them.

#include "fix_lb_ibb.h"

#include "lbm_rules.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "region.h"

#include <cmath>

using namespace LAMMPS_NS;
using lbm::Vec3;

// regions by their present definition; in two dimensions nodes lie at z = 0, as atoms do
std::vector<lbm::Shape> FixLbIbb::shapes()
{
  std::vector<lbm::Shape> list;
  for (const LBObstacle &o : options.obstacles) {
    Region *region = domain->get_region_by_id(o.region);
    if (!region)
      error->all(FLERR,
                 "Fix lb/ibb keyword obstacle: region {} does not exist: define it before the run, "
                 "and keep it",
                 o.region);
    if (region->dynamic || region->moveflag || region->rotateflag || region->varshape)
      error->all(FLERR,
                 "Fix lb/ibb keyword obstacle: region {} moves, turns or changes its shape: an "
                 "obstacle stays where it is, and its surface may move along itself with velocity "
                 "and omega; what moves through the fluid has to be made of grains (fix move)",
                 o.region);
    if (region->openflag)
      error->all(
          FLERR,
          "Fix lb/ibb keyword obstacle: region {} has open faces and so no inside: define one "
          "without open for the fluid",
          o.region);
    region->init();
    region->prematch();
    lbm::Shape shape;
    shape.inside = [this, region](const Vec3 &x) {
      Vec3 place{};
      for (int d = 0; d < domain->dimension; d++) place[d] = domain->boxlo[d] + x[d] * options.dx;
      return region->match(place[0], place[1], place[2]) == 1;
    };
    const double lo[3] = {region->extent_xlo, region->extent_ylo, region->extent_zlo};
    const double hi[3] = {region->extent_xhi, region->extent_yhi, region->extent_zhi};
    for (int d = 0; d < domain->dimension; d++) {
      // sides at INF, 1e20 or 1e200 as LAMMPS's versions have it, count as those of the box
      const bool from = region->bboxflag && std::fabs(lo[d]) < 1e20;
      const bool to = region->bboxflag && std::fabs(hi[d]) < 1e20;
      const double middle =
          0.5 * ((from ? lo[d] : domain->boxlo[d]) + (to ? hi[d] : domain->boxhi[d]));
      shape.velocity[d] = o.velocity[d] / units.velocity();
      shape.about[d] = ((o.has_about ? o.about[d] : middle) - domain->boxlo[d]) / options.dx;
    }
    for (int d = 0; d < 3; d++) shape.spin[d] = o.omega[d] / units.spin();
    list.push_back(shape);
  }
  return list;
}

void FixLbIbb::make_obstacles()
{
  if (options.obstacles.empty()) return;
  found = fluid->set_obstacles(shapes());
}

// at the start of every run; all ranks have found the same
void FixLbIbb::check_obstacles()
{
  if (options.obstacles.empty()) return;
  if (has_started()) {
    const auto now = fluid->review(shapes());
    for (std::size_t k = 0; k < now.size(); k++)
      if (now[k].checksum != found[k].checksum)
        error->all(FLERR,
                   "Fix lb/ibb keyword obstacle: region {} has changed since the fluid was made: "
                   "define it as it was, or define the fix anew",
                   options.obstacles[k].region);
    return;
  }
  double covered = 0.0;
  for (std::size_t k = 0; k < found.size(); k++) {
    const lbm::ShapeReview &f = found[k];
    const std::string &name = options.obstacles[k].region;
    covered += f.covered;
    if (f.covered == 0.0)
      error->all(
          FLERR,
          "Fix lb/ibb keyword obstacle: region {} covers no node of the lattice{}: see where "
          "it lies, and in which units (keyword units of region)",
          name, f.missed > 0.0 ? ", as it is thinner than dx and lies between nodes" : "");
    if (f.leaving > 0.0)
      error->all(FLERR,
                 "Fix lb/ibb keyword obstacle: the motion of region {} would take its surface "
                 "elsewhere, at {:.0f} of {:.0f} links: it must move along itself, as a cylinder "
                 "that turns about its axis",
                 name, f.leaving, f.links);
    if (comm->me) continue;
    if (f.thin > 0.0)
      error->warning(
          FLERR,
          "Fix lb/ibb keyword obstacle: {:.0f} of {:.0f} surface nodes of region {} lie in "
          "parts thinner than 2 dx = {:.4g}, which the lattice does not resolve: use a "
          "smaller dx, or thicker parts",
          f.thin, f.surface, name, 2.0 * options.dx);
    if (f.missed > 0.0)
      error->warning(
          FLERR,
          "Fix lb/ibb keyword obstacle: the fluid passes through parts of region {} that "
          "are thinner than dx = {:.4g} and lie between nodes, at {:.0f} links: use a "
          "smaller dx, or thicker parts",
          name, options.dx, f.missed);
  }
  if (covered >= double(nodes[0]) * nodes[1] * nodes[2])
    error->all(
        FLERR,
        "Fix lb/ibb keyword obstacle: region {} covers all nodes and leaves none to the fluid: "
        "is its side the right one?",
        options.obstacles[0].region);
}

// physical
double FixLbIbb::obstacle_speed() const
{
  double speed = 0.0;
  for (const lbm::ShapeReview &f : found) speed = std::max(speed, f.speed * units.velocity());
  return speed;
}

std::string FixLbIbb::describe_obstacles()
{
  std::string text;
  for (std::size_t k = 0; k < found.size(); k++) {
    text += fmt::format("  obstacle {}: {:.0f} solid nodes, {:.0f} links",
                        options.obstacles[k].region, found[k].covered, found[k].links);
    if (found[k].speed > 0.0)
      text += fmt::format(", surface moves at up to {:.4g}, Ma = {:.3g}",
                          found[k].speed * units.velocity(), lbm::mach(found[k].speed));
    text += fmt::format("; force and torque are f_{}[{}] to [{}]\n", id,
                        NUMBERS + 1 + LOAD * int(k), NUMBERS + LOAD * (int(k) + 1));
  }
  return text;
}

// mean of the last two fluid steps if that of grains is; the same on all ranks
double FixLbIbb::obstacle_load(int n)
{
  const lbm::ObstacleState &s = fluid->obstacles()[n / LOAD];
  const int c = n % LOAD;
  const auto part = [c](const lbm::Load &load) {
    return c < 3 ? load.force[c] : load.torque[c - 3];
  };
  const double old = options.average && s.steps > 1.0 ? 0.5 : 0.0;
  const double load = (1.0 - old) * part(s.last) + old * part(s.before);
  if (!std::isfinite(load)) take_survey();
  return load * (c < 3 ? units.force() : units.torque());
}
