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

#ifndef LMP_GRAN_LSD_MATERIAL_H
#define LMP_GRAN_LSD_MATERIAL_H

#include "gran_lsd_law.h"
#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

// what the pair style and the wall fix share on the LAMMPS side of the law

namespace GranLSDMaterial {

  // coefficients of a command: "k_n e mu" or "file NAME.lsd MATERIAL", from
  // arg[iarg] on; both are three words

  static constexpr int NWORDS = 3;
  GranLSD::Material parse(LAMMPS *lmp, const std::string &command, int narg, char **arg, int iarg);

  // error unless force = mass x acceleration in the units of the script

  void check_units(LAMMPS *lmp, const std::string &style);

  // error beyond a tenth of t_contact, warning beyond a fiftieth; to be called
  // by all ranks

  void check_timestep(LAMMPS *lmp, const std::string &style, double t_contact);

  // the error of check_timestep() alone, for one rank

  void check_timestep_one(LAMMPS *lmp, const std::string &style, double t_contact);

}    // namespace GranLSDMaterial
}    // namespace LAMMPS_NS

#endif
