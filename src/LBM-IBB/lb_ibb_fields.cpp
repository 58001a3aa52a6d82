/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_fields.h"

#include "domain.h"
#include "error.h"
#include "grid2d.h"
#include "grid3d.h"
#include "memory.h"

#include <algorithm>

using namespace LAMMPS_NS;

namespace {
enum { DENSITY, PRESSURE, VELOCITY, SOLID };
struct Name {
  const char *name;
  int ncol;
};
constexpr Name NAMES[] = {{"density", 0}, {"pressure", 0}, {"velocity", 3}, {"solid", 0}};

// bounds of the owned cells as LAMMPS's grid classes give them
template <class Grid> void bounds(Grid &grid, lbm::Int3 &lo, lbm::Int3 &hi)
{
  if constexpr (std::is_same_v<Grid, Grid3d>)
    grid.get_bounds_owned(lo[0], hi[0], lo[1], hi[1], lo[2], hi[2]);
  else
    grid.get_bounds_owned(lo[0], hi[0], lo[1], hi[1]);
}

// LAMMPS's grids count cells in 32 bits; what they do when there are more ends in a destructor that
// reads what was never set. Collective.
void check_size(LAMMPS *lmp, MPI_Comm world, const lbm::Int3 &n)
{
  const Domain *domain = lmp->domain;
  double nodes = 1.0, most;    // of a rank, with its ghosts
  for (int d = 0; d < domain->dimension; d++)
    nodes *= n[d] * (domain->subhi[d] - domain->sublo[d]) / domain->prd[d] + 4.0;
  MPI_Allreduce(&nodes, &most, 1, MPI_DOUBLE, MPI_MAX, world);
  if (most > MAXSMALLINT)
    lmp->error->all(FLERR,
                    "Fix lb/ibb: {:.3g} lattice nodes on one rank, limit 2^31: use more ranks or a "
                    "larger dx",
                    most);
}

std::unique_ptr<Grid3d> cut3(LAMMPS *lmp, MPI_Comm world, const lbm::Int3 &n)
{
  auto grid = std::make_unique<Grid3d>(lmp, world, n[0], n[1], n[2]);
  int t[12];
  grid->setup_grid(t[0], t[1], t[2], t[3], t[4], t[5], t[6], t[7], t[8], t[9], t[10], t[11]);
  return grid;
}

std::unique_ptr<Grid2d> cut2(LAMMPS *lmp, MPI_Comm world, const lbm::Int3 &n)
{
  auto grid = std::make_unique<Grid2d>(lmp, world, n[0], n[1]);
  int t[8];
  grid->setup_grid(t[0], t[1], t[2], t[3], t[4], t[5], t[6], t[7]);
  return grid;
}
}    // namespace

// storage of one field in the shape that LAMMPS's per-grid data has: [z][y][x][column]
struct LBFields::Field {
  Memory *memory;
  lbm::Int3 lo, n;
  int dimension, ncol;
  double **d2 = nullptr, ***d3 = nullptr, ****d4 = nullptr;

  Field(Memory *memory_, const lbm::Int3 &lo_, const lbm::Int3 &n_, int dimension_, int ncol_) :
      memory(memory_), lo(lo_), n(n_), dimension(dimension_), ncol(ncol_)
  {
    const int hi[3] = {lo[0] + n[0] - 1, lo[1] + n[1] - 1, lo[2] + n[2] - 1};
    const char *name = "lb/ibb:field";
    if (dimension == 2 && !ncol)
      memory->create2d_offset(d2, lo[1], hi[1], lo[0], hi[0], name);
    else if (dimension == 2)
      memory->create3d_offset_last(d3, lo[1], hi[1], lo[0], hi[0], ncol, name);
    else if (!ncol)
      memory->create3d_offset(d3, lo[2], hi[2], lo[1], hi[1], lo[0], hi[0], name);
    else
      memory->create4d_offset_last(d4, lo[2], hi[2], lo[1], hi[1], lo[0], hi[0], ncol, name);
  }
  ~Field()
  {
    if (d2) memory->destroy2d_offset(d2, lo[1], lo[0]);
    if (d3 && dimension == 2) memory->destroy3d_offset_last(d3, lo[1], lo[0]);
    if (d3 && dimension == 3) memory->destroy3d_offset(d3, lo[2], lo[1], lo[0]);
    if (d4) memory->destroy4d_offset_last(d4, lo[2], lo[1], lo[0]);
  }
  double *at(int x, int y, int z)
  {
    if (d2) return &d2[y][x];
    if (d3) return dimension == 2 ? d3[y][x] : &d3[z][y][x];
    return d4[z][y][x];
  }
  void *data() { return d2 ? (void *) d2 : d3 ? (void *) d3 : (void *) d4; }
};

LBFields::LBFields(LAMMPS *lmp, const lbm::Int3 &global_) : Pointers(lmp), global(global_)
{
  lbm::Int3 hi{0, 0, 0};
  check_size(lmp, world, global);
  if (domain->dimension == 2) {
    grid2 = cut2(lmp, world, global);
    bounds(*grid2, lo_, hi);
  } else {
    grid3 = cut3(lmp, world, global);
    bounds(*grid3, lo_, hi);
  }
  for (int d = 0; d < 3; d++) n_[d] = hi[d] - lo_[d] + 1;
}

LBFields::~LBFields() = default;

bool LBFields::cut_changed() const
{
  lbm::Int3 lo{0, 0, 0}, hi{0, 0, 0};
  if (grid2)
    bounds(*cut2(lmp, world, global), lo, hi);
  else
    bounds(*cut3(lmp, world, global), lo, hi);
  int changed = 0;
  for (int d = 0; d < 3; d++)
    if (lo[d] != lo_[d] || hi[d] - lo[d] + 1 != n_[d]) changed = 1;
  MPI_Allreduce(MPI_IN_PLACE, &changed, 1, MPI_INT, MPI_MAX, world);
  return changed == 1;
}

void *LBFields::grid() const
{
  return grid2 ? (void *) grid2.get() : (void *) grid3.get();
}

int LBFields::find(const std::string &name, int &ncol)
{
  for (int i = 0; i < 4; i++)
    if (name == NAMES[i].name) {
      ncol = NAMES[i].ncol;
      return i;
    }
  return -1;
}

// at a node counted from the first of this rank
template <class Real>
static void evaluate(int index, const lbm::Fluid &fluid, const lbm::Units &units, int x, int y,
                     int z, Real *value)
{
  const bool solid = fluid.solid(x, y, z);
  if (index == SOLID) {
    *value = solid;
    return;
  }
  const lbm::Moments m = solid ? lbm::Moments{0.0, {}} : fluid.moments(x, y, z);
  if (index == DENSITY) *value = Real(units.rho * (1.0 + m.drho));
  if (index == PRESSURE) *value = Real(units.gauge_pressure(m.drho));
  if (index == VELOCITY)
    for (int d = 0; d < 3; d++) value[d] = Real(m.u[d] * units.velocity());
}

void *LBFields::compute(int index, const lbm::Fluid &fluid, const lbm::Units &units)
{
  auto &field = fields[index];
  if (!field) field = std::make_unique<Field>(memory, lo_, n_, grid2 ? 2 : 3, NAMES[index].ncol);
  for (int z = 0; z < n_[2]; z++)
    for (int y = 0; y < n_[1]; y++)
      for (int x = 0; x < n_[0]; x++)
        evaluate(index, fluid, units, x, y, z, field->at(lo_[0] + x, lo_[1] + y, lo_[2] + z));
  return field->data();
}

std::vector<float> LBFields::sample(int index, const lbm::Sample &which, const lbm::Fluid &fluid,
                                    const lbm::Units &units) const
{
  const lbm::Part part = which.within({lo_, n_});
  const int columns = std::max(1, NAMES[index].ncol);
  std::vector<float> values(part.nodes() * columns);
  float *next = values.data();
  for (int k = 0; k < part.n[2]; k++)
    for (int j = 0; j < part.n[1]; j++)
      for (int i = 0; i < part.n[0]; i++, next += columns) {
        const auto node = which.node(part.lo[0] + i, part.lo[1] + j, part.lo[2] + k);
        evaluate(index, fluid, units, node[0] - lo_[0], node[1] - lo_[1], node[2] - lo_[2], next);
      }
  return values;
}

double LBFields::memory_usage() const
{
  double n = 0.0;
  for (const auto &field : fields)
    if (field) n += double(n_[0]) * n_[1] * n_[2] * std::max(field->ncol, 1);
  return n * sizeof(double);
}
