/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// The table of errors to expect, from the file beside the contact files.

#ifndef LMP_LB_IBB_ACCURACY_H
#define LMP_LB_IBB_ACCURACY_H

#include "lbm_accuracy.h"
#include "pointers.h"

namespace LAMMPS_NS {

constexpr const char *LB_ACCURACY_FILE = "lbm-ibb.accuracy";

// Collective. Empty and the reason in why if there is no file; a line that is none is an error.
lbm::Accuracy read_accuracy(class LAMMPS *lmp, std::string &why);

}    // namespace LAMMPS_NS
#endif
