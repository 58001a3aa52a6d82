/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_options.h"

#include "domain.h"
#include "error.h"
#include "utils.h"

#include <cmath>
#include <set>

using namespace LAMMPS_NS;
using lbm::FaceKind;

LBOptionsParser::LBOptionsParser(LAMMPS *lmp, int narg_, char **arg_) :
    Pointers(lmp), narg(narg_), iarg(3), arg(arg_)
{
}

void LBOptionsParser::refuse(int at, const std::string &why) const
{
  error->all(FLERR, at, "Fix lb/ibb keyword {}: {} (see doc/src/fix_lb_ibb.rst)", arg[at], why);
}

LBOptions LBOptionsParser::parse()
{
  if (narg < 9) utils::missing_cmd_args(FLERR, "fix lb/ibb", error);
  for (auto [name, place] :
       {std::pair<const char *, double *>{"dx", &o.dx}, {"nu", &o.nu}, {"rho", &o.rho}}) {
    if (arg[iarg] != std::string(name))
      error->all(FLERR, iarg,
                 "Fix lb/ibb: expected '{}', not '{}': fix ID group lb/ibb dx ... nu ... rho ...",
                 name, arg[iarg]);
    *place = positive(name);
    iarg++;
  }
  std::set<std::string> seen;
  while (iarg < narg) {
    std::string name = arg[iarg];
    if ((name == "face" || name == "obstacle") && iarg + 1 < narg)
      name += std::string(" ") + arg[iarg + 1];
    if (!seen.insert(name).second)
      error->all(FLERR, iarg, "Fix lb/ibb: '{}' is given twice: remove one of them", name);
    keyword();
    iarg++;
  }
  check_faces();
  check_radius();
  return o;
}

// arg[iarg] is a keyword; leaves iarg at its last word
void LBOptionsParser::keyword()
{
  const std::string name = arg[iarg];
  if (name == "every") {
    o.every = count("fluid step interval");
  } else if (name == "check") {
    o.check = count("interval of the stability check");
  } else if (name == "collision") {
    const int at = iarg;
    const std::string rule = next("trt, bgk or regularised");
    if (rule != "trt" && rule != "bgk" && rule != "regularised")
      refuse(at, "'" + rule + "' is none of trt, bgk, regularised");
    o.bgk = rule == "bgk";
    o.regularised = rule == "regularised";
    if (rule == "trt" && follows_number()) o.magic = positive("trt Lambda");
  } else if (name == "precision") {
    const int at = iarg;
    const std::string precision = next("double or single");
    if (precision != "double" && precision != "single")
      refuse(at, "'" + precision + "' is neither double nor single");
    o.single = precision == "single";
  } else if (name == "link") {
    const int at = iarg;
    const std::string rule = next("cli, zhao, bouzidi or halfway");
    if (rule == "cli")
      o.link = lbm::LinkRule::CLI;
    else if (rule == "zhao")
      o.link = lbm::LinkRule::ZHAO;
    else if (rule == "bouzidi")
      o.link = lbm::LinkRule::BOUZIDI;
    else if (rule == "halfway")
      o.link = lbm::LinkRule::HALFWAY;
    else
      refuse(at, "'" + rule + "' is none of cli, zhao, bouzidi, halfway");
  } else if (name == "refill") {
    const int at = iarg;
    const std::string rule = next("grad, normal, local or equilibrium");
    if (rule == "grad")
      o.refill = lbm::RefillRule::GRAD;
    else if (rule == "normal")
      o.refill = lbm::RefillRule::NORMAL;
    else if (rule == "local")
      o.refill = lbm::RefillRule::LOCAL;
    else if (rule == "equilibrium")
      o.refill = lbm::RefillRule::EQUILIBRIUM;
    else
      refuse(at, "'" + rule + "' is none of grad, normal, local, equilibrium");
  } else if (name == "average") {
    o.average = utils::logical(FLERR, next("yes or no"), false, lmp) == 1;
  } else if (name == "conserve") {
    o.conserve = utils::logical(FLERR, next("yes or no"), false, lmp) == 1;
  } else if (name == "coupling") {
    const int at = iarg;
    const std::string how = next("auto, explicit or implicit");
    if (how == "auto")
      o.coupling = LBOptions::AUTO;
    else if (how == "explicit")
      o.coupling = LBOptions::EXPLICIT;
    else if (how == "implicit")
      o.coupling = LBOptions::IMPLICIT;
    else
      refuse(at, "'" + how + "' is none of auto, explicit, implicit");
  } else if (name == "radius") {
    const int at = iarg;
    const std::string how = next("given or calibrated");
    if (how != "given" && how != "calibrated")
      refuse(at, "'" + how + "' is neither given nor calibrated");
    o.calibrated = how == "calibrated";
  } else if (name == "shrink") {
    const int at = iarg;
    o.shrink = number("shrink");
    if (o.shrink < 0.0) refuse(at, fmt::format("{} must not be negative", o.shrink));
  } else if (name == "accel") {
    o.accel = drive(name);
  } else if (name == "gradp") {
    o.gradp = drive(name);
    o.has_gradp = true;
  } else if (name == "buoyancy") {
    o.buoyancy = drive(name);
    o.has_buoyancy = true;
  } else if (name == "restart") {
    o.restart = next("name of the restart file or none");
  } else if (name == "face") {
    face();
  } else if (name == "obstacle") {
    obstacle();
  } else {
    error->all(
        FLERR, iarg,
        "Fix lb/ibb (see doc/src/fix_lb_ibb.rst): unknown keyword '{}'; known are every, "
        "collision, precision, link, refill, face, obstacle, accel, gradp, buoyancy, shrink, "
        "radius, average, conserve, coupling, check, restart",
        name);
  }
}

// in two dimensions nothing can be driven along z
LBVector LBOptionsParser::drive(const std::string &what)
{
  const int at = iarg;
  LBVector values = vector(what);
  if (domain->dimension == 2 && !values[2].zero())
    refuse(at,
           fmt::format("its z component is {}, it must be 0 with dimension 2", values[2].text()));
  return values;
}

void LBOptionsParser::face()
{
  const int at = iarg;
  const std::string name = next("face");
  int d = 0, side = 0;
  for (d = 0; d < 3; d++) {
    for (side = 0; side < 2; side++)
      if (name == LBOptions::FACES[d][side]) break;
    if (side < 2) break;
  }
  if (d == 3) refuse(at, "'" + name + "' is none of xlo, xhi, ylo, yhi, zlo, zhi");
  if (d == 2 && domain->dimension == 2)
    refuse(at, name + " has no meaning with dimension 2: remove it");
  if (domain->periodicity[d])
    refuse(at,
           name +
               " is on a periodic direction: make it non-periodic with the boundary command (f)");

  LBFace &f = o.face[d][side];
  const std::string kind = next("wall, pressure or velocity");
  if (kind == "wall") {
    f.kind = FaceKind::WALL;
    if (follows_number()) f.u = vector(name + " wall");
    if (!f.u[d].zero())
      refuse(at,
             fmt::format("{} wall moves with {} along {}, through itself: this component must be "
                         "the number 0; fluid enters through a velocity face",
                         name, f.u[d].text(), "xyz"[d]));
  } else if (kind == "pressure") {
    f.kind = FaceKind::PRESSURE;
    f.p = value(name + " pressure");
  } else if (kind == "velocity") {
    f.kind = FaceKind::VELOCITY;
    f.u = vector(name + " velocity");
    f.parabolic = iarg + 1 < narg && arg[iarg + 1] == std::string("parabolic");
    if (f.parabolic) iarg++;
  } else {
    refuse(at, name + ": '" + kind + "' is none of wall, pressure, velocity");
  }
  if (domain->dimension == 2 && !f.u[2].zero())
    refuse(at,
           fmt::format("{}: the z component of the velocity is {}, it must be 0 with dimension 2",
                       name, f.u[2].text()));
}

void LBOptionsParser::obstacle()
{
  const int at = iarg;
  LBObstacle solid;
  solid.region = next("region of an obstacle");
  std::set<std::string> given;
  while (iarg + 1 < narg) {
    const std::string word = arg[iarg + 1];
    if (word != "velocity" && word != "omega" && word != "about") break;
    if (!given.insert(word).second)
      refuse(at,
             fmt::format("region {}: '{}' is given twice: remove one of them", solid.region, word));
    iarg++;
    (word == "velocity"    ? solid.velocity
         : word == "omega" ? solid.omega
                           : solid.about) = numbers(solid.region + " " + word);
  }
  solid.has_about = given.count("about") > 0;
  if (solid.omega != lbm::Vec3{} && !solid.has_about)
    refuse(at,
           fmt::format("region {}: omega needs a point of its axis: about cx cy cz", solid.region));
  if (domain->dimension == 2 &&
      (solid.velocity[2] != 0.0 || solid.omega[0] != 0.0 || solid.omega[1] != 0.0))
    refuse(at,
           fmt::format("region {}: with dimension 2 the z component of velocity and the x and y "
                       "components of omega must be 0",
                       solid.region));
  o.obstacles.push_back(solid);
}

// ---------------------------------------------------------------------- words and numbers

const char *LBOptionsParser::next(const std::string &what)
{
  if (++iarg >= narg) utils::missing_cmd_args(FLERR, "fix lb/ibb " + what, error);
  return arg[iarg];
}

double LBOptionsParser::number(const std::string &what)
{
  const double x = utils::numeric(FLERR, next(what), false, lmp);
  if (!std::isfinite(x))
    error->all(FLERR, iarg, "Fix lb/ibb: {} = {} is not a finite number", what, x);
  return x;
}

double LBOptionsParser::positive(const std::string &what)
{
  const double x = number(what);
  if (x <= 0.0) error->all(FLERR, iarg, "Fix lb/ibb: {} = {} must be larger than 0", what, x);
  return x;
}

int LBOptionsParser::count(const std::string &what)
{
  const int at = iarg;
  const int n = utils::inumeric(FLERR, next(what), false, lmp);
  if (n < 1) refuse(at, std::to_string(n) + " must be at least 1");
  return n;
}

// is the next word a number or a variable, and so still part of this keyword?
bool LBOptionsParser::follows_number() const
{
  if (iarg + 1 >= narg) return false;
  const std::string word = arg[iarg + 1];
  return utils::is_double(word) || utils::strmatch(word, "^v_") ||
      utils::strmatch(word, "^[+-]?nan") || utils::strmatch(word, "^[+-]?inf");
}

LBValue LBOptionsParser::value(const std::string &what)
{
  LBValue v;
  if (iarg + 1 < narg && utils::strmatch(arg[iarg + 1], "^v_"))
    v.variable = next(what) + 2;
  else
    v.constant = number(what);
  return v;
}

LBVector LBOptionsParser::vector(const std::string &what)
{
  LBVector v;
  for (auto &component : v) component = value(what);
  return v;
}

lbm::Vec3 LBOptionsParser::numbers(const std::string &what)
{
  lbm::Vec3 v;
  for (double &component : v) component = number(what);
  return v;
}
