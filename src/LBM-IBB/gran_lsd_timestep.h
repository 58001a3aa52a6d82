/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   Copyright (2003) Sandia Corporation.  Under the terms of Contract
   DE-AC04-94AL85000 with Sandia Corporation, the U.S. Government retains
   certain rights in this software.  This software is distributed under
   the GNU General Public License.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Contributing authors: LBM-IBB developers
------------------------------------------------------------------------- */

#ifndef LMP_GRAN_LSD_TIMESTEP_H
#define LMP_GRAN_LSD_TIMESTEP_H

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

// is the time step short enough for the contacts there can be?

namespace GranLSDTimestep {

  // smallest mass where there is no grain

  static constexpr double BIG = 1.0e300;

  // error beyond a tenth of t_contact, warning beyond a fiftieth; 0 = there is
  // no contact; to be called by all ranks

  void check(LAMMPS *lmp, const std::string &style, double t_contact);

  // the error of check() alone, for one rank

  void check_one(LAMMPS *lmp, const std::string &style, double t_contact);

  // for a time step that changes: outside of a run the next run checks it

  void check_reset(LAMMPS *lmp, const std::string &style, double t_contact);

}    // namespace GranLSDTimestep

// the lightest grains of each type, and how short a contact they can have

class GranLSDLightestGrains : protected Pointers {
 public:
  GranLSDLightestGrains(LAMMPS *lmp) : Pointers(lmp) {}

  // find them on all ranks; mass_rigid as for GranLSDGrains::mass()

  void find(int freeze_bit, const double *mass_rigid);

  // look again on this rank; true if there are lighter ones

  bool find_lighter(int freeze_bit, const double *mass_rigid);

  // 0 = no grain can touch another

  double shortest_contact(double **kn, double **e, double **mu) const;

 private:
  std::vector<double> lightest;    // smallest mass of a type that is free to move
  std::vector<int> has_frozen;     // whether a type has frozen grains
};

}    // namespace LAMMPS_NS

#endif
