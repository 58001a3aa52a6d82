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

#ifdef PAIR_CLASS
// clang-format off
PairStyle(gran/lsd/coulomb,PairGranLSDCoulomb);
// clang-format on
#else

#ifndef LMP_PAIR_GRAN_LSD_COULOMB_H
#define LMP_PAIR_GRAN_LSD_COULOMB_H

#include "pair_gran_hooke.h"

#include "gran_lsd_law.h"
#include "gran_lsd_timestep.h"

namespace LAMMPS_NS {

class PairGranLSDCoulomb : public PairGranHooke {
 public:
  PairGranLSDCoulomb(class LAMMPS *);
  ~PairGranLSDCoulomb() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void setup() override;
  void reset_dt() override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  double single(int, int, int, int, double, double, double, double &) override;
  void *extract(const char *, int &) override;

 protected:
  static constexpr const char *STYLE = "pair_style gran/lsd/coulomb";    // of messages

  double offset;            // contact radius minus atom radius
  double inertia_factor;    // I/(m r^2), for the cap of the friction
  double **k_n, **restitution, **friction;
  GranLSD::Law **law;

  double t_contact;                  // shortest contact between the grains there are
  GranLSDLightestGrains lightest;    // the ones that have it

  void allocate();
  void check_offset() const;
  void update_rigid_masses();
  GranLSD::Force contact(int, int, double, double, const double *, const GranLSD::Law &, double &,
                         double &) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
