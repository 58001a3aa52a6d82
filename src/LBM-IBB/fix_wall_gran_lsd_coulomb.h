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

#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/gran/lsd/coulomb,FixWallGranLSDCoulomb);
// clang-format on
#else

#ifndef LMP_FIX_WALL_GRAN_LSD_COULOMB_H
#define LMP_FIX_WALL_GRAN_LSD_COULOMB_H

#include "fix.h"

#include "gran_lsd_law.h"

#include <vector>

namespace LAMMPS_NS {

class FixWallGranLSDCoulomb : public Fix {
 public:
  FixWallGranLSDCoulomb(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void reset_dt() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void *extract(const char *, int &) override;

 protected:
  enum Motion { STILL, SHEAR, WIGGLE };

  GranLSD::Material material{};
  GranLSD::Law law{};
  double offset;            // contact radius minus atom radius
  double inertia_factor;    // I/(m r^2), for the cap of the friction
  int normal;               // axis across the walls
  bool has_wall[2];         // lower, upper
  double place[2];          // of the walls, at rest
  Motion motion;
  int along;                   // axis of the motion
  double speed;                // of shear
  double amplitude, period;    // of wiggle
  bigint time_origin;

  double t_contact;              // shortest contact with a wall
  class Fix *fix_rigid;          // owner of the masses of rigid bodies, or null
  std::vector<double> weight;    // mass each own atom answers with

  double total[7];    // contacts, force of the lower wall, of the upper wall
  double total_all[7];
  bigint reduced;    // time step of total_all, or -1

  int parse_planes(int, int, char **);
  int parse_motion(int, int, char **);
  int parse_axis(int, char **) const;
  void find_masses();
  double lightest_own() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
