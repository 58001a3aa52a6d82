/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Tables of this package that lie beside the contact files.

#ifndef LMP_LB_IBB_TABLE_H
#define LMP_LB_IBB_TABLE_H

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

// the whole file on all ranks, found as LAMMPS finds potentials; empty if there is none; collective
std::string read_table(class LAMMPS *lmp, const std::string &name);

// "no file ... here or in a folder of LAMMPS_POTENTIALS (...)"
std::string no_table(const std::string &name);

}    // namespace LAMMPS_NS
#endif
