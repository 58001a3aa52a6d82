/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "fix_lb_ibb_vtk.h"

#include "fix_lb_ibb.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "platform.h"
#include "region.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

using namespace LAMMPS_NS;
using namespace FixConst;

namespace {
const std::set<std::string> KEYWORDS{"fields", "grains", "region", "stride", "encoding"};
constexpr const char *DEFAULT_FIELDS[] = {"pressure", "velocity", "solid"};
}    // namespace

// ---------------------------------------------------------------------- what the user wrote

FixLbIbbVtk::FixLbIbbVtk(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), fluid(nullptr), has_grains(atom->radius_flag), stride(1),
    encoding(lbm::vtk_has_zlib() ? lbm::VtkEncoding::ZLIB : lbm::VtkEncoding::RAW), goes_on(false),
    written(-1), nodes{}, lo{}, hi{}
{
  if (narg < 6) utils::missing_cmd_args(FLERR, "fix lb/ibb/vtk", error);
  nevery = utils::inumeric(FLERR, arg[3], false, lmp);
  if (nevery < 1) refuse(3, fmt::format("every {} time steps: at least 1 is needed", nevery));
  fluid_id = arg[4];
  find_fluid();
  check_interval();
  prefix = arg[5];
  const std::string file = platform::path_basename(prefix);
  if (const auto bad = file.find_first_of("&<>\""); bad != std::string::npos)
    refuse(5,
           fmt::format("name '{}' has a {} in it, which XML keeps for itself: use letters, "
                       "digits, - and _",
                       file, file[bad]));
  for (auto *other : modify->get_fix_by_style("^lb/ibb/vtk$"))
    if (static_cast<FixLbIbbVtk *>(other)->prefix == prefix)
      refuse(5, fmt::format("fix {} writes files of that name already", other->id));
  for (const char *name : DEFAULT_FIELDS) {
    int columns;
    const int index = fluid->get_griddata_by_name(0, name, columns);
    fields.push_back({name, index, columns});
  }
  parse(narg, arg);
  if (fields.empty() && !has_grains)
    error->all(FLERR, "Fix lb/ibb/vtk: neither fields nor grains: nothing to write");
  choose_nodes();
  if (!fields.empty()) fluid_series = std::make_unique<lbm::VtkSeries>(prefix + "-fluid", "vti");
  if (has_grains) grain_series = std::make_unique<lbm::VtkSeries>(prefix + "-grains", "vtp");
  restart_global = 1;
}

void FixLbIbbVtk::refuse(int iarg, const std::string &why)
{
  error->all(FLERR, iarg, "Fix lb/ibb/vtk: {}", why);
}

void FixLbIbbVtk::parse(int narg, char **arg)
{
  std::set<std::string> seen;
  for (int iarg = 6; iarg < narg;) {
    const std::string name = arg[iarg];
    if (!KEYWORDS.count(name))
      refuse(iarg,
             fmt::format("unknown keyword '{}'; known are encoding, fields, grains, region, "
                         "stride",
                         name));
    if (!seen.insert(name).second)
      refuse(iarg, fmt::format("'{}' is given twice: remove one of them", name));
    if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "fix lb/ibb/vtk " + name, error);
    const std::string value = arg[iarg + 1];
    if (name == "fields") {
      iarg = parse_fields(iarg + 1, narg, arg);
      continue;
    }
    if (name == "grains") {
      has_grains = utils::logical(FLERR, value, false, lmp) == 1;
      if (has_grains && !atom->radius_flag)
        refuse(iarg, fmt::format("no radii with atom_style {}: say grains no", atom->atom_style));
    } else if (name == "region") {
      region_id = value;
    } else if (name == "stride") {
      stride = utils::inumeric(FLERR, value, false, lmp);
      if (stride < 1) refuse(iarg + 1, fmt::format("stride {}: at least 1 is needed", stride));
    } else if (value == "zlib") {
      encoding = lbm::VtkEncoding::ZLIB;
      if (!lbm::vtk_has_zlib())
        refuse(iarg + 1,
               "this LAMMPS was built without zlib: use encoding raw, or build it anew "
               "where zlib.h is");
    } else if (value == "raw") {
      encoding = lbm::VtkEncoding::RAW;
    } else if (value == "base64") {
      encoding = lbm::VtkEncoding::BASE64;
    } else {
      refuse(iarg + 1, fmt::format("encoding '{}' is none of zlib, raw, base64", value));
    }
    iarg += 2;
  }
}

// names up to the next keyword, or none; returns where that is
int FixLbIbbVtk::parse_fields(int iarg, int narg, char **arg)
{
  fields.clear();
  const int first = iarg;
  for (; iarg < narg && !KEYWORDS.count(arg[iarg]); iarg++) {
    const std::string name = arg[iarg];
    const bool alone = iarg == first && (iarg + 1 == narg || KEYWORDS.count(arg[iarg + 1]));
    if (name == "none" && alone) return iarg + 1;
    int columns;
    const int index = fluid->get_griddata_by_name(0, name, columns);
    if (index < 0)
      refuse(iarg,
             fmt::format("fix lb/ibb has no field '{}': it has density, pressure, velocity, "
                         "solid",
                         name));
    for (const Field &other : fields)
      if (other.name == name) refuse(iarg, fmt::format("field {} is named twice", name));
    fields.push_back({name, index, columns});
  }
  if (iarg == first) refuse(iarg - 1, "names of fields must follow, or none");
  return iarg;
}

void FixLbIbbVtk::find_fluid()
{
  fluid = dynamic_cast<FixLbIbb *>(modify->get_fix_by_id(fluid_id));
  if (!fluid)
    error->all(FLERR,
               "Fix lb/ibb/vtk: there is no fix lb/ibb with ID {}: define it before this fix",
               fluid_id);
}

// files are to show the fluid of their own time
void FixLbIbbVtk::check_interval()
{
  const int step = fluid->nevery, below = nevery - nevery % step;
  if (nevery % step)
    error->all(FLERR, "Fix lb/ibb/vtk: every {} time steps, but the fluid moves every {}: use {}{}",
               nevery, step, below ? fmt::format("{} or ", below) : "", below + step);
}

// nodes in the box that encloses the region, both faces included
void FixLbIbbVtk::choose_nodes()
{
  for (int d = 0; d < 3; d++) {
    lo[d] = -INFINITY;
    hi[d] = INFINITY;
  }
  if (!region_id.empty()) {
    Region *region = domain->get_region_by_id(region_id);
    if (!region) error->all(FLERR, "Fix lb/ibb/vtk: there is no region {}", region_id);
    if (region->dynamic_check())
      error->all(FLERR, "Fix lb/ibb/vtk: region {} moves or changes; only one at rest can be used",
                 region_id);
    if (!region->bboxflag)
      error->all(
          FLERR,
          "Fix lb/ibb/vtk: region {} has no bounding box, as with side out: use one that has",
          region_id);
    const double from[3] = {region->extent_xlo, region->extent_ylo, region->extent_zlo};
    const double to[3] = {region->extent_xhi, region->extent_yhi, region->extent_zhi};
    std::copy_n(from, domain->dimension, lo);
    std::copy_n(to, domain->dimension, hi);
  }
  const double dx = fluid->spacing();
  const lbm::Int3 all = fluid->lattice_nodes();
  nodes.stride = stride;
  for (int d = 0; d < 3; d++) {
    constexpr double ROUNDING = 1e-6;
    const double first = std::ceil((lo[d] - domain->boxlo[d]) / dx - 0.5 - ROUNDING);
    const double last = std::floor((hi[d] - domain->boxlo[d]) / dx - 0.5 + ROUNDING);
    const int from = int(std::max(first, 0.0)), to = int(std::min(last, all[d] - 1.0));
    if (last < 0.0 || first > all[d] - 1.0 || from > to)
      error->all(
          FLERR,
          "Fix lb/ibb/vtk: region {} holds no node along {}: it reaches from {:.8g} to {:.8g}; "
          "nodes are at {:.8g} + k {:.8g}, k = 0 to {}",
          region_id, "xyz"[d], lo[d], hi[d], domain -> boxlo[d] + 0.5 * dx, dx, all[d] - 1);
    nodes.lo[d] = from;
    nodes.n[d] = (to - from) / stride + 1;
  }
}

// ---------------------------------------------------------------------- life of the fix

int FixLbIbbVtk::setmask()
{
  return END_OF_STEP;
}

void FixLbIbbVtk::init()
{
  find_fluid();    // it may have been defined anew
  check_interval();
  choose_nodes();
  for (auto *other : modify->get_fix_list()) {
    if (other == fluid) break;
    if (other == this)
      error->all(FLERR, "Fix lb/ibb/vtk: fix {} was defined anew after this fix: so must this be",
                 fluid_id);
  }
}

// the state a run starts from, unless it is that which the last one ended with
void FixLbIbbVtk::setup(int)
{
  keep_time();
  if (goes_on && written < 0) {
    int has = 0;
    if (comm->me == 0)
      for (auto *series : {fluid_series.get(), grain_series.get()})
        if (series) {
          series->resume(update->ntimestep);
          has = series->has(update->ntimestep);
        }
    MPI_Bcast(&has, 1, MPI_INT, 0, world);
    if (has) written = update->ntimestep;
  }
  if (update->ntimestep % nevery == 0 && update->ntimestep != written) write();
}

void FixLbIbbVtk::end_of_step()
{
  write();
}

// what was written is on disk, in the lists of files
void FixLbIbbVtk::write_restart(FILE *fp)
{
  if (comm->me) return;
  fwrite(&known.bytes, sizeof(int), 1, fp);
  fwrite(&known, sizeof known, 1, fp);
}

void FixLbIbbVtk::restart(char *buf)
{
  Moment saved;
  int head[2];
  std::memcpy(head, buf, sizeof head);
  if (head[0] != saved.version || head[1] != saved.bytes)
    error->all(FLERR,
               "Fix lb/ibb/vtk: the restart file was written by another version of this package: "
               "give this fix another ID, and another name to its files");
  std::memcpy(&saved, buf, sizeof saved);
  known = saved;
  goes_on = true;
}
