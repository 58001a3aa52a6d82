/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#include "lb_ibb_library.h"

#include "fix_lb_ibb.h"

#include "domain.h"
#include "error.h"
#include "exceptions.h"
#include "grid2d.h"
#include "grid3d.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

// first number of per-grid data in LAMMPS's layout, whose arrays begin at lo
static double *first(void *data, bool flat, const int *lo, int columns)
{
  if (flat && !columns) return &((double **) data)[lo[1]][lo[0]];
  if (flat) return ((double ***) data)[lo[1]][lo[0]];
  if (!columns) return &((double ***) data)[lo[2]][lo[1]][lo[0]];
  return ((double ****) data)[lo[2]][lo[1]][lo[0]];
}

static double *field(LAMMPS *lmp, const char *fix_id, const char *name, int *lo, int *n,
                     int *global, int *columns)
{
  auto *fix = dynamic_cast<FixLbIbb *>(lmp->modify->get_fix_by_id(fix_id));
  if (!fix) lmp->error->all(FLERR, "lbm_ibb_field: there is no fix lb/ibb with ID {}", fix_id);
  int hi[3] = {0, 0, 0};
  lo[2] = 0;
  const bool flat = lmp->domain->dimension == 2;
  if (flat)
    static_cast<Grid2d *>(fix->get_grid_by_index(0))->get_bounds_owned(lo[0], hi[0], lo[1], hi[1]);
  else
    static_cast<Grid3d *>(fix->get_grid_by_index(0))
        ->get_bounds_owned(lo[0], hi[0], lo[1], hi[1], lo[2], hi[2]);
  const int which = fix->get_griddata_by_name(0, name, *columns);
  if (which < 0)
    lmp->error->all(FLERR,
                    "lbm_ibb_field: fix lb/ibb has no field '{}', it has density, pressure, "
                    "velocity and solid",
                    name);
  for (int d = 0; d < 3; d++) {
    n[d] = hi[d] - lo[d] + 1;
    global[d] = fix->lattice_nodes()[d];
  }
  return first(fix->get_griddata_by_index(which), flat, lo, *columns);
}

double *lbm_ibb_field(void *lammps, const char *fix_id, const char *name, int *lo, int *n,
                      int *global, int *columns)
{
  auto *lmp = static_cast<LAMMPS *>(lammps);
  try {
    return field(lmp, fix_id, name, lo, n, global, columns);
  } catch (LAMMPSException &failure) {
    lmp->error->set_last_error(failure.what(), ERROR_NORMAL);
    return nullptr;
  }
}
