/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS
// clang-format off
PairStyle(lubricate/lb/ibb,PairLubricateLbIbb);
// clang-format on
#else

#ifndef LMP_PAIR_LUBRICATE_LB_IBB_H
#define LMP_PAIR_LUBRICATE_LB_IBB_H

#include "pair.h"

#include "lbm_lubrication.h"

namespace LAMMPS_NS {

// Films between grains, and between grains and walls of fix lb/ibb, that its lattice is too coarse
// for
class PairLubricateLbIbb : public Pair {
 public:
  PairLubricateLbIbb(class LAMMPS *);
  ~PairLubricateLbIbb() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void setup() override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;

 private:
  double least, normal_cells, shear_cells;    // smallest gap; cut-offs in spacings of the lattice
  int with_walls;
  class FixLbIbb *fluid;
  lbm::Film film;
  double *largest, *largest_frozen;    // radius by type

  void allocate();
  void check_step();
  bool film_between(int i, int j, double rsq, lbm::Vec3 &n, lbm::FilmLoad &load) const;
  void compute_walls();
};

}    // namespace LAMMPS_NS

#endif
#endif
