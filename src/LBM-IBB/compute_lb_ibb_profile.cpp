/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "compute_lb_ibb_profile.h"

#include "fix_lb_ibb.h"
#include "lbm_profile.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "memory.h"
#include "modify.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

ComputeLbIbbProfile::ComputeLbIbbProfile(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), fix(nullptr), axis(-1), width(0), height(0.0), has_gravity(false),
    has_critical(false), gravity(0.0), critical(0.0)
{
  if (narg < 7) utils::missing_cmd_args(FLERR, "compute lb/ibb/profile", error);
  fix_id = arg[3];
  find_fix();
  const std::string name = arg[4];
  for (int d = 0; d < domain->dimension; d++)
    if (name == std::string(1, "xyz"[d])) axis = d;
  if (axis < 0)
    error->all(FLERR, 4, "Compute lb/ibb/profile: '{}' is no axis of this box: use {}", name,
               domain->dimension == 2 ? "x or y" : "x, y or z");
  parse_layers(5, arg);
  parse_keywords(7, narg, arg);

  array_flag = 1;
  size_array_rows = fix->lattice_nodes()[axis] / width;
  size_array_cols = COLUMNS;
  extarray = 0;
  memory->create(array, size_array_rows, size_array_cols, "lb/ibb/profile:array");
}

ComputeLbIbbProfile::~ComputeLbIbbProfile()
{
  memory->destroy(array);
}

void ComputeLbIbbProfile::find_fix()
{
  fix = dynamic_cast<FixLbIbb *>(modify->get_fix_by_id(fix_id));
  if (!fix)
    error->all(FLERR,
               "Compute lb/ibb/profile: there is no fix lb/ibb with ID {}: define it before the "
               "compute",
               fix_id);
}

// layers are whole numbers of nodes, all equal
void ComputeLbIbbProfile::parse_layers(int iarg, char **arg)
{
  const std::string how = arg[iarg];
  const int n = fix->lattice_nodes()[axis];
  const double dx = fix->spacing();
  double wanted = 0.0;
  if (how == "layers") {
    const int count = utils::inumeric(FLERR, arg[iarg + 1], false, lmp);
    if (count < 1)
      error->all(FLERR, iarg + 1, "Compute lb/ibb/profile: {} layers: at least 1 is needed", count);
    wanted = double(n) / count;
  } else if (how == "width") {
    wanted = utils::numeric(FLERR, arg[iarg + 1], false, lmp) / dx;
    if (!(wanted > 0.0))
      error->all(FLERR, iarg + 1, "Compute lb/ibb/profile: width {} must be larger than 0",
                 arg[iarg + 1]);
  } else {
    error->all(FLERR, iarg, "Compute lb/ibb/profile: expected 'layers' or 'width', not '{}'", how);
  }
  const double whole = std::nearbyint(wanted);
  const bool fits = std::fabs(wanted - whole) <= 1e-6 * wanted && whole <= n;
  if (!fits || n % int(whole)) {
    int below = int(std::min(std::floor(wanted * (1.0 + 1e-9)), double(n)));
    while (below > 1 && n % below) below--;
    below = std::max(below, 1);
    int above = below + 1;
    while (above < n && n % above) above++;
    above = std::min(above, n);
    error->all(FLERR, iarg,
               "Compute lb/ibb/profile: {} {} makes layers of {:.6g} of the {} nodes along {}: "
               "layers are whole numbers of nodes, all equal; nearest are layers {} or {}, width "
               "{:.10g} or {:.10g}",
               how, arg[iarg + 1], wanted, n, "xyz"[axis], n / below, n / above, below * dx,
               above * dx);
  }
  width = int(whole);
  height = width * dx;
}

void ComputeLbIbbProfile::parse_keywords(int iarg, int narg, char **arg)
{
  for (; iarg < narg; iarg += 2) {
    const std::string name = arg[iarg];
    if (name != "gravity" && name != "critical")
      error->all(FLERR, iarg,
                 "Compute lb/ibb/profile: unknown keyword '{}'; known are gravity, critical (see "
                 "doc/src/compute_lb_ibb_profile.rst)",
                 name);
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "compute lb/ibb/profile " + name, error);
    if ((name == "gravity" && has_gravity) || (name == "critical" && has_critical))
      error->all(FLERR, iarg, "Compute lb/ibb/profile: {} is given twice: remove one of them",
                 name);
    const double value = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
    if (name == "gravity") {
      if (!(std::fabs(value) <= 1e100))    // products of it have to be numbers
        error->all(FLERR, iarg + 1, "Compute lb/ibb/profile: gravity = {}, limit 1e100 either way",
                   value);
      gravity = value;
      has_gravity = true;
    } else {
      if (!(value > 0.0))
        error->all(FLERR, iarg + 1, "Compute lb/ibb/profile: critical = {} must be larger than 0",
                   value);
      if (value < 1e-100)    // a gradient over it has to be a number
        error->all(FLERR, iarg + 1, "Compute lb/ibb/profile: critical = {}, limit 1e-100", value);
      critical = value;
      has_critical = true;
    }
  }
}

void ComputeLbIbbProfile::init()
{
  find_fix();    // it may have been defined anew, on another lattice
  if (fix->lattice_nodes()[axis] != width * size_array_rows ||
      std::fabs(width * fix->spacing() - height) > 1e-9 * height)
    error->all(FLERR,
               "Compute lb/ibb/profile: the lattice of fix {} has changed since the compute was "
               "defined; define it anew",
               fix_id);
}

// Of the grains' parts in each layer: what they weigh more than the fluid they displace, along g
std::vector<double> ComputeLbIbbProfile::submerged_weights(double g) const
{
  const int n = size_array_rows;
  std::vector<double> weight(n, 0.0);
  if (g == 0.0 || !atom->radius_flag) return weight;
  const double origin = domain->boxlo[axis];
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double r = fix->hydrodynamic_radius(i), x = atom->x[i][axis] - origin;
    if (!(r > 0.0)) continue;
    const double volume = lbm::volume_below(r, r, domain->dimension);
    const double excess = std::fabs(g) * (atom->rmass[i] / volume - fix->density());
    double below = 0.0;
    for (int k = int(std::floor((x - r) / height)); k * height < x + r; k++) {
      const double next = lbm::volume_below((k + 1) * height - x, r, domain->dimension);
      if (domain->periodicity[axis])
        weight[((k % n) + n) % n] += excess * (next - below);
      else if (k >= 0 && k < n)
        weight[k] += excess * (next - below);
      below = next;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, weight.data(), n, MPI_DOUBLE, MPI_SUM, world);
  return weight;
}

void ComputeLbIbbProfile::compute_array()
{
  invoked_array = update->ntimestep;
  find_fix();    // between runs it may be gone
  if (!fix->has_fluid())
    error->all(FLERR,
               "Compute lb/ibb/profile: the fluid exists from the first run on: use run 0 before");
  const auto layers = fix->profile(axis, width);
  const double g = has_gravity ? gravity : fix->gravity()[axis];
  const auto weight = submerged_weights(g);
  const double up = g > 0.0 ? -1.0 : 1.0;    // along the axis
  const int n = size_array_rows;
  double across = 1.0;    // section of the box
  for (int d = 0; d < domain->dimension; d++)
    if (d != axis) across *= domain->prd[d];

  double above = 0.0;    // effective stress at the upper side of a layer
  for (int j = 0; j < n; j++) {
    const int k = up > 0.0 ? n - 1 - j : j;    // from the top down
    const lbm::Layer &l = layers[k];
    const double drive = up * l.gradient, unit_weight = weight[k] / (across * height);
    const double reference = has_critical ? critical : unit_weight;
    double *row = array[k];
    row[PLACE] = domain->boxlo[axis] + (k + 0.5) * height;
    row[POROSITY] = l.porosity;
    row[PRESSURE] = l.pressure;
    row[GRADIENT] = l.gradient;
    row[RATIO] = reference != 0.0 ? drive / reference : 0.0;
    row[FLUX] = l.flux;
    row[PERMEABILITY] = l.gradient != 0.0 ? l.flux * fix->viscosity() * fix->density() / l.gradient
                                          : 0.0;
    const double added = weight[k] / across - drive * l.length;
    row[STRESS] = g != 0.0 ? above + 0.5 * added : 0.0;
    above += added;
  }
}

double ComputeLbIbbProfile::memory_usage()
{
  return double(size_array_rows) * COLUMNS * sizeof(double);
}
