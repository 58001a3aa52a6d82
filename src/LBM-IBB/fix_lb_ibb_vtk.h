/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(lb/ibb/vtk,FixLbIbbVtk);
// clang-format on
#else

#ifndef LMP_FIX_LB_IBB_VTK_H
#define LMP_FIX_LB_IBB_VTK_H

#include "fix.h"

#include "lbm_sample.h"
#include "lbm_vtk.h"
#include "lbm_vtk_series.h"

#include <memory>

namespace LAMMPS_NS {

// Series of files of fluid and grains for ParaView. A fix and no dump: it has to know after a
// restart that it goes on, and styles of dumps cannot come with a plugin.
class FixLbIbbVtk : public Fix {
 public:
  FixLbIbbVtk(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  std::string fluid_id, prefix, region_id;
  class FixLbIbb *fluid;
  struct Field {
    std::string name;
    int index, columns;    // as fix lb/ibb has them
  };
  std::vector<Field> fields;
  bool has_grains;
  int stride;
  lbm::VtkEncoding encoding;
  std::unique_ptr<lbm::VtkSeries> fluid_series, grain_series;
  bool goes_on;      // the restart file that was read had this fix in it
  bigint written;    // last step that was
  // A moment whose time is known, and the timestep since. LAMMPS's own clock forgets, in a restart
  // file of mid-run, the time since that run began. It is moved only where the timestep changes:
  // a run that goes on gives its files the times, to the last bit, of one that was not stopped.
  struct Moment {
    int version = 2, bytes = sizeof(Moment);
    bigint step = -1;
    double time = 0.0, dt = 0.0;
  } known;
  lbm::Sample nodes;
  double lo[3], hi[3];    // what the region reaches over

  void parse(int narg, char **arg);
  int parse_fields(int iarg, int narg, char **arg);
  [[noreturn]] void refuse(int iarg, const std::string &why);
  void find_fluid();
  void check_interval();
  void choose_nodes();
  double now() const;
  void keep_time();
  void write();
  void write_fluid();
  void write_grains();
  void list(lbm::VtkSeries &series, const std::string &why);
};

}    // namespace LAMMPS_NS
#endif
#endif
