/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// How long a granular step without fluid takes here: grains in contact, in a LAMMPS of their own.

#ifndef LMP_LB_PLAN_GRANULAR_H
#define LMP_LB_PLAN_GRANULAR_H

#include "pointers.h"

namespace LAMMPS_NS {

// seconds; collective
double seconds_of_granular_step(class LAMMPS *lmp, double grains);

}    // namespace LAMMPS_NS
#endif
