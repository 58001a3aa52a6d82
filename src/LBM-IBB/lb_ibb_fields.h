/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The lattice as LAMMPS per-grid data: fields f_ID:grid:density, pressure, velocity[1..3], solid.
// LAMMPS's grid classes cut the lattice into one block per rank; the fluid takes their cut.
// A field takes memory and time only when somebody asks for it.

#ifndef LMP_LB_IBB_FIELDS_H
#define LMP_LB_IBB_FIELDS_H

#include "lbm_sample.h"
#include "lbm_solver.h"
#include "lbm_units.h"
#include "pointers.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class LBFields : protected Pointers {
 public:
  LBFields(class LAMMPS *lmp, const lbm::Int3 &global);
  ~LBFields() override;

  // nodes of this rank; n may be 0 along a direction
  lbm::Int3 lo() const { return lo_; }
  lbm::Int3 n() const { return n_; }
  // would LAMMPS cut the lattice otherwise now?
  bool cut_changed() const;

  void *grid() const;
  // index and number of columns of a field (0: scalar), -1 if unknown
  static int find(const std::string &name, int &ncol);
  // compute a field, in LAMMPS's layout; physical units
  void *compute(int index, const lbm::Fluid &fluid, const lbm::Units &units);
  // of some of this rank's nodes, x fastest, without keeping it
  std::vector<float> sample(int index, const lbm::Sample &which, const lbm::Fluid &fluid,
                            const lbm::Units &units) const;
  double memory_usage() const;

 private:
  lbm::Int3 global, lo_{}, n_{};
  std::unique_ptr<class Grid2d> grid2;
  std::unique_ptr<class Grid3d> grid3;
  struct Field;
  std::unique_ptr<Field> fields[4];
};

}    // namespace LAMMPS_NS
#endif
