/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(lb/ibb/profile,ComputeLbIbbProfile);
// clang-format on
#else

#ifndef LMP_COMPUTE_LB_IBB_PROFILE_H
#define LMP_COMPUTE_LB_IBB_PROFILE_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

// The fluid of fix lb/ibb, and the weight of its grains, by layers across an axis. The sums over
// nodes are the solver's; here are those over grains, and the words of soil mechanics.
class ComputeLbIbbProfile : public Compute {
 public:
  ComputeLbIbbProfile(class LAMMPS *, int, char **);
  ~ComputeLbIbbProfile() override;
  void init() override;
  void compute_array() override;
  double memory_usage() override;

 private:
  enum { PLACE, POROSITY, PRESSURE, GRADIENT, RATIO, FLUX, PERMEABILITY, STRESS, COLUMNS };

  std::string fix_id;
  class FixLbIbb *fix;
  int axis, width;    // layers are so many nodes thick
  double height;      // of a layer
  bool has_gravity, has_critical;
  double gravity, critical;    // as given, along the axis

  void find_fix();
  void parse_layers(int iarg, char **arg);
  void parse_keywords(int iarg, int narg, char **arg);
  std::vector<double> submerged_weights(double g) const;
};

}    // namespace LAMMPS_NS
#endif
#endif
