/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Spheres of few cells are felt by the fluid as if they had another radius: what to add to theirs,
// from a table that was measured (file lbm-ibb.radius). A line is
//     link tau r correction      tau: a relaxation time, or any; radius and correction in cells

#ifndef LMP_LB_IBB_RADIUS_H
#define LMP_LB_IBB_RADIUS_H

#include "pointers.h"

#include <map>
#include <string>

namespace LAMMPS_NS {

class LBRadius {
 public:
  // for one link rule at one relaxation time; stops with what is wrong. Collective.
  LBRadius(LAMMPS *lmp, const std::string &link, double tau);
  // radius with which the fluid takes a sphere for one of radius r, in cells
  double drawn(double r) const;

 private:
  using Rows = std::map<double, double>;    // correction by radius
  Rows low, high;                           // of the relaxation times below and above
  double share = 0.0;                       // of the latter
};

}    // namespace LAMMPS_NS
#endif
