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

#include <set>
#include <string>

namespace LAMMPS_NS {

// what the commands of the pair style and the wall fix have in common

namespace GranLSDMaterial {

  // coefficients of a command: "k_n e mu" or "file NAME.lsd MATERIAL", from
  // arg[iarg] on; both are three words

  static constexpr int NWORDS = 3;
  GranLSD::Material parse(LAMMPS *lmp, const std::string &command, int narg, char **arg, int iarg);

  // keyword and value "offset" or "limit_damping" at arg[iarg]; false = it is
  // another keyword, that has a value too; one that is among those given already
  // is refused

  bool parse_option(LAMMPS *lmp, const std::string &command, int narg, char **arg, int iarg,
                    double &offset, int &limit_damping, std::set<std::string> &given);

}    // namespace GranLSDMaterial
}    // namespace LAMMPS_NS

#endif
