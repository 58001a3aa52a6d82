/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// lb/plan: the command line, and what box and grains say.

#include "lb_plan.h"

#include "gran_lsd_material.h"
#include "lb_ibb_accuracy.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

void LBPlan::command(int n, char **words)
{
  narg = n;
  arg = words;
  parse();
  if (force->ftm2v != 1.0 || force->nktv2p != 1.0)
    error->all(FLERR,
               "lb/plan: units {} have hidden conversion factors: use units si, cgs, lj, micro "
               "or nano",
               update->unit_style);
  wish.dimension = domain->dimension;
  look_at_box();
  look_at_grains();
  check();
  find_contact();

  std::string why;
  const lbm::Accuracy accuracy = read_accuracy(lmp, why);
  if (wish.quantity.empty()) wish.quantity = wish.fraction >= lbm::DENSE ? "permeability" : "drag";
  const bool known = wish.dimension == 3 && accuracy.knows(wish.quantity);
  if (!known && (has("error") || has("quantity"))) {
    if (wish.dimension == 2) why = "the errors known are those of spheres";
    if (why.empty()) why = fmt::format("'{}' is none of {}", wish.quantity, accuracy.quantities());
    error->all(FLERR, "lb/plan: no error of {} is known, {}: give dx instead", wish.quantity, why);
  }
  if (!known) wish.quantity.clear();

  const lbm::Advice advice = lbm::advise(wish, accuracy);
  if (!advice.refusal.empty()) error->all(FLERR, "lb/plan: {}", advice.refusal);
  const Cost found = cost(advice);
  if (comm->me == 0) {
    utils::logmesg(lmp, report(advice, found, accuracy));
    if (!why.empty()) utils::logmesg(lmp, "  errors to expect are not known: {}\n", why);
  }
  define(advice, found);
}

// ---------------------------------------------------------------------- the command line

const char *LBPlan::next(const std::string &what)
{
  if (++iarg >= narg) utils::missing_cmd_args(FLERR, "lb/plan " + what, error);
  return arg[iarg];
}

double LBPlan::positive(const std::string &what)
{
  const double x = utils::numeric(FLERR, next(what), false, lmp);
  if (!(x > 0.0) || !std::isfinite(x))
    error->all(FLERR, iarg, "lb/plan: {} = {} must be a number larger than 0", what, x);
  return x;
}

bool LBPlan::chosen(const std::string &what, const char *yes, const char *no)
{
  const std::string word = next(what);
  if (word != yes && word != no)
    error->all(FLERR, iarg, "lb/plan {}: '{}' is neither {} nor {}", what, word, yes, no);
  return word == yes;
}

void LBPlan::parse()
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "lb/plan", error);
  iarg = -1;
  for (auto [name, place] :
       {std::pair<const char *, double *>{"nu", &wish.nu}, {"rho", &wish.rho}}) {
    if (next(name) != std::string(name))
      error->all(FLERR, iarg, "lb/plan: expected '{}', not '{}': lb/plan nu ... rho ...", name,
                 arg[iarg]);
    *place = positive(name);
  }
  while (++iarg < narg) {
    const std::string name = arg[iarg];
    if (!given.insert(name).second)
      error->all(FLERR, iarg, "lb/plan: '{}' is given twice: remove one of them", name);
    keyword(name);
  }
}

// leaves iarg at the last word of the keyword
void LBPlan::keyword(const std::string &name)
{
  static const std::map<std::string, double lbm::Wish::*> numbers = {
      {"dx", &lbm::Wish::dx},
      {"error", &lbm::Wish::error},
      {"tau", &lbm::Wish::tau},
      {"speed", &lbm::Wish::speed},
      {"pressure", &lbm::Wish::pressure},
      {"permeability", &lbm::Wish::permeability},
      {"time", &lbm::Wish::time}};
  const auto number = numbers.find(name);
  if (number != numbers.end()) {
    wish.*(number->second) = positive(name);
  } else if (name == "quantity") {
    wish.quantity = next(name);
  } else if (name == "group") {
    group_name = next(name);
  } else if (name == "diameter") {
    wish.smallest = 0.5 * positive("smallest diameter");
    wish.mean = 0.5 * positive("mean diameter");
    if (wish.smallest > wish.mean)
      error->all(FLERR, iarg, "lb/plan: the smallest diameter {} is larger than the mean {}",
                 2.0 * wish.smallest, 2.0 * wish.mean);
  } else if (name == "density") {
    density = positive(name);
  } else if (name == "contact") {
    iarg++;
    material = GranLSDMaterial::parse(lmp, "lb/plan contact", narg, arg, iarg);
    iarg += GranLSDMaterial::NWORDS - 1;
  } else if (name == "bed") {
    wish.fraction = positive("solid fraction of the bed");
    if (wish.fraction >= 1.0)
      error->all(FLERR, iarg, "lb/plan: solid fraction {} of the bed must be below 1",
                 wish.fraction);
    wish.height = positive("height of the bed");
  } else if (name == "box") {
    for (int d = 0; d < domain->dimension; d++) wish.box[d] = positive("length of the box");
  } else if (name == "precision") {
    single = chosen(name, "single", "double");
  } else if (name == "grains") {
    moving = chosen(name, "moving", "still");
  } else if (name == "measure") {
    measure = utils::logical(FLERR, next(name), false, lmp) == 1;
  } else if (name == "prefix") {
    prefix = next(name);
    if (!utils::is_id(prefix))
      error->all(FLERR, iarg, "lb/plan: prefix '{}' may have letters, digits and _ only", prefix);
  } else {
    error->all(
        FLERR, iarg,
        "lb/plan: unknown keyword '{}'; known are dx, error, quantity, tau, speed, pressure, "
        "diameter, group, density, contact, bed, permeability, box, time, precision, grains, "
        "measure, prefix",
        name);
  }
}

void LBPlan::check()
{
  if (!has("dx") && !has("error"))
    error->all(FLERR, "lb/plan: give dx, or the error that is wanted");
  if (has("dx") && has("error"))
    error->all(FLERR,
               "lb/plan: dx and error are given, but one follows from the other: remove one");
  if (wish.error >= 0.5)
    error->all(FLERR, "lb/plan: an error of {} is no wish: it is a fraction, 0.02 are 2 %",
               wish.error);
  if (wish.smallest <= 0.0)
    error->all(FLERR, "lb/plan: no grains are known: give diameter, or group once there are some");
  if (!has("speed") && !has("pressure"))
    error->all(
        FLERR,
        "lb/plan: give the largest speed that is expected, or the pressure difference, or both: "
        "they limit the time step");
  if (has("contact") && density <= 0.0 && lightest <= 0.0)
    error->all(FLERR,
               "lb/plan: how long a contact lasts depends on the density of the grains: give it");
  if (has("precision") && !measure)
    error->all(FLERR, "lb/plan: precision has no use with measure no: remove one");
}

// ---------------------------------------------------------------------- what is there

void LBPlan::look_at_box()
{
  if (!domain->box_exist) {
    if (domain->dimension == 2) wish.box[2] = 0.0;
    return;
  }
  if (has("box")) error->all(FLERR, "lb/plan: there is a box: remove keyword box");
  if (domain->triclinic) error->all(FLERR, "lb/plan: fix lb/ibb does not support triclinic boxes");
  if (domain->nonperiodic == 2)
    error->all(FLERR,
               "lb/plan: fix lb/ibb does not support shrink-wrapped boxes: use boundary style f");
  for (int d = 0; d < domain->dimension; d++) wish.box[d] = domain->prd[d];
}

void LBPlan::look_at_grains()
{
  const int D = domain->dimension;
  if (!has("group")) {
    const lbm::Units unit{1.0, 1.0, 1.0, D};
    if (has("bed") && wish.mean > 0.0 && wish.box[0] > 0.0) {
      double section = 1.0;
      for (int d = 0; d < D - 1; d++) section *= wish.box[d];
      grains = std::max(1.0, wish.fraction * section * wish.height / unit.grain_volume(wish.mean));
    }
    square = grains * wish.mean * wish.mean;
    crowded = square / comm->nprocs;
    return;
  }
  if (has("diameter"))
    error->all(FLERR, "lb/plan: diameter and group are given: remove one of them");
  const int igroup = group->find(group_name);
  if (igroup < 0) error->all(FLERR, "lb/plan: group {} does not exist", group_name);
  if (!domain->box_exist || group->count(igroup) == 0)
    error->all(FLERR, "lb/plan: there are no grains in group {}: give diameter instead",
               group_name);
  if (!atom->radius_flag) error->all(FLERR, "lb/plan: grains need a radius: use atom_style sphere");

  // sums of 1, r, r^2, volume; largest of -r, -mass, -density, -lowest and highest point, own r^2
  const int up = D - 1;
  double sum[4] = {}, most[6] = {-1e300, -1e300, -1e300, -1e300, -1e300, 0.0};
  const lbm::Units unit{1.0, 1.0, 1.0, D};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & group->bitmask[igroup])) continue;
    const double r = atom->radius[i], volume = unit.grain_volume(r), mass = atom->rmass[i];
    const double add[4] = {1.0, r, r * r, volume};
    for (int k = 0; k < 4; k++) sum[k] += add[k];
    const double of[5] = {-r, -mass, -mass / volume, r - atom->x[i][up], r + atom->x[i][up]};
    for (int k = 0; k < 5; k++) most[k] = std::max(most[k], of[k]);
  }
  most[5] = sum[2];
  MPI_Allreduce(MPI_IN_PLACE, sum, 4, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, most, 6, MPI_DOUBLE, MPI_MAX, world);
  grains = sum[0];
  wish.mean = sum[1] / grains;
  square = sum[2];
  crowded = most[5];
  wish.smallest = -most[0];
  lightest = -most[1];
  if (!has("density")) wish.ratio = -most[2] / wish.rho;
  if (has("bed")) return;
  // grains that stick out of a periodic box fill it
  wish.height = std::min(most[3] + most[4], domain->prd[up]);
  wish.fraction =
      std::min(0.9, sum[3] / (wish.height * domain->prd[0] * (D == 3 ? domain->prd[1] : 1.0)));
}

void LBPlan::find_contact()
{
  if (density > 0.0) wish.ratio = density / wish.rho;
  if (!has("contact")) return;
  double mass = lightest;
  if (density > 0.0)
    mass = density * lbm::Units{1.0, 1.0, 1.0, wish.dimension}.grain_volume(wish.smallest);
  wish.contact = GranLSD::STEP_GOOD * GranLSD::contact_time(material, 0.5 * mass);
}
