/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What fix lb/ibb/vtk puts into its files.

#include "fix_lb_ibb_vtk.h"

#include "fix_lb_ibb.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

double FixLbIbbVtk::now() const
{
  return known.time + double(update->ntimestep - known.step) * known.dt;
}

// before the first step with a timestep, the known moment is the present one
void FixLbIbbVtk::keep_time()
{
  if (known.step < 0)
    known.time = update->atime + double(update->ntimestep - update->atimestep) * update->dt;
  else if (known.dt != update->dt)
    known.time = now();
  else
    return;
  known.step = update->ntimestep;
  known.dt = update->dt;
}

void FixLbIbbVtk::write()
{
  written = update->ntimestep;
  if (fluid_series) write_fluid();
  if (grain_series) write_grains();
}

// the file is complete, or this is why not
void FixLbIbbVtk::list(lbm::VtkSeries &series, const std::string &why)
{
  std::string failure = why;
  if (failure.empty() && comm->me == 0) failure = series.add(written, now());
  failure = lbm::agreed(failure, world);
  if (!failure.empty()) error->all(FLERR, "Fix lb/ibb/vtk: {}", failure);
}

void FixLbIbbVtk::write_fluid()
{
  const double dx = fluid->spacing(), step = stride * dx;
  lbm::Vec3 origin;
  for (int d = 0; d < 3; d++) origin[d] = domain->boxlo[d] + (nodes.lo[d] + 0.5) * dx;
  if (domain->dimension == 2) origin[2] = 0.0;
  auto file = lbm::vtk_image(nodes.n, origin, {step, step, step}, now());
  const lbm::Part part = nodes.within(fluid->own_nodes());
  const int writers = encoding == lbm::VtkEncoding::BASE64 ? 1 : comm->nprocs;
  for (const Field &field : fields) {
    const int columns = std::max(1, field.columns);
    const auto values = lbm::in_order(fluid->sample(field.index, nodes), part, nodes.n, columns,
                                      writers, lbm::VTK_BLOCK, world);
    file.sections[0].arrays.push_back(lbm::vtk_array(field.name, columns, values));
  }
  list(*fluid_series, lbm::write_vtk(fluid_series->file(written), file, encoding, world));
}

// grains of the group that reach into the box of the region, by ID
void FixLbIbbVtk::write_grains()
{
  enum { ID, TYPE, PLACE, RADIUS = PLACE + 3, VELOCITY, OMEGA = VELOCITY + 3, FORCE = OMEGA + 3 };
  enum { TORQUE = FORCE + 3, SIZE = TORQUE + 3 };
  using Row = std::array<double, SIZE>;
  std::vector<Row> mine;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    double x[3] = {atom->x[i][0], atom->x[i][1], atom->x[i][2]};
    domain->remap(x);
    const double r = atom->radius[i], *load = fluid->array_atom[i];
    bool reaches = true;
    for (int d = 0; d < domain->dimension; d++) reaches &= x[d] + r >= lo[d] && x[d] - r <= hi[d];
    if (!reaches) continue;
    Row row;
    row[ID] = double(atom->tag[i]);
    row[TYPE] = atom->type[i];
    row[RADIUS] = r;
    for (int d = 0; d < 3; d++) {
      row[PLACE + d] = x[d];
      row[VELOCITY + d] = atom->v[i][d];
      row[OMEGA + d] = atom->omega_flag ? atom->omega[i][d] : 0.0;
      row[FORCE + d] = load[d];
      row[TORQUE + d] = load[3 + d];
    }
    mine.push_back(row);
  }

  std::vector<int> count(comm->nprocs), first(comm->nprocs, 0);
  const int n = int(mine.size());
  MPI_Gather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, 0, world);
  for (int r = 1; r < comm->nprocs; r++) first[r] = first[r - 1] + count[r - 1];
  std::vector<Row> rows(comm->me == 0 ? first.back() + count.back() : 0);
  const lbm::Type row(sizeof(Row));
  MPI_Gatherv(mine.data(), n, row.handle(), rows.data(), count.data(), first.data(), row.handle(),
              0, world);
  std::sort(rows.begin(), rows.end());

  auto column = [&](int from, int columns) {
    std::vector<double> values;
    for (const Row &grain : rows)
      values.insert(values.end(), grain.begin() + from, grain.begin() + from + columns);
    return values;
  };
  auto whole = [&](int from) {
    const auto values = column(from, 1);
    return std::vector<std::int64_t>(values.begin(), values.end());
  };
  // on the other ranks they are all there too, and empty; but the number of points is the first's
  auto file = lbm::vtk_points(column(PLACE, 3), now());
  file.sections[0].arrays = {lbm::vtk_array("id", 1, whole(ID)),
                             lbm::vtk_array("type", 1, whole(TYPE)),
                             lbm::vtk_array("radius", 1, column(RADIUS, 1)),
                             lbm::vtk_array("velocity", 3, column(VELOCITY, 3)),
                             lbm::vtk_array("omega", 3, column(OMEGA, 3)),
                             lbm::vtk_array("force", 3, column(FORCE, 3)),
                             lbm::vtk_array("torque", 3, column(TORQUE, 3))};
  list(*grain_series, lbm::write_vtk(grain_series->file(written), file, encoding, world));
}
