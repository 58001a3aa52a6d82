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

#ifndef LMP_GRAN_LSD_GRAINS_H
#define LMP_GRAN_LSD_GRAINS_H

#include "pointers.h"

#include <string>

namespace LAMMPS_NS {
class Fix;

// what the pair style and the wall fix ask of the grains there are

namespace GranLSDGrains {

  // error unless grains have a radius, a mass and a spin

  void check_spheres(LAMMPS *lmp, const std::string &style);

  // error unless force = mass x acceleration in the units of the script

  void check_units(LAMMPS *lmp, const std::string &style);

  // I/(m r^2), for the cap of the friction: spheres in 3d, discs in 2d

  double inertia_factor(LAMMPS *lmp);

  // the owner of the masses of rigid bodies, or null; error if there are two

  Fix *find_rigid(LAMMPS *lmp, const std::string &style);

  // masses of their bodies for own grains in one; the others keep what mass[] has

  void put_rigid_masses(Fix *fix_rigid, int nlocal, double *mass);

  // mass grain i answers with: its own, or if rigid[i] > 0 that of its body

  inline double mass(int i, const double *rmass, const double *rigid)
  {
    return (rigid && rigid[i] > 0.0) ? rigid[i] : rmass[i];
  }

  // largest radius of each type on all ranks, of grains free to move, including
  // those to be inserted, and of grains frozen

  void largest_radii(LAMMPS *lmp, int freeze_bit, double *moving, double *frozen);

}    // namespace GranLSDGrains
}    // namespace LAMMPS_NS

#endif
