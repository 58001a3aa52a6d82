/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What LAMMPS's library interface lacks: per-grid data of a fix, for programs and for Python
// (python/lbm_ibb.py). Everything else of the fix comes by lammps_extract_fix() and the like.

#ifndef LMP_LB_IBB_LIBRARY_H
#define LMP_LB_IBB_LIBRARY_H

#ifdef __cplusplus
extern "C" {
#endif

// The field NAME (density, pressure, velocity, solid) of fix lb/ibb FIX_ID on this rank's nodes, as
// n[2] x n[1] x n[0] x columns numbers, x or the column fastest, or a null pointer and an error that
// lammps_get_last_error_message() tells. lo is this rank's first node, global the number of all. The
// numbers stay valid until the next call for the same field. To be called by all ranks.
double *lbm_ibb_field(void *lammps, const char *fix_id, const char *name, int *lo, int *n,
                      int *global, int *columns);

#ifdef __cplusplus
}
#endif
#endif
