/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(lb/plan,LBPlan);
// clang-format on
#else

#ifndef LMP_LB_PLAN_H
#define LMP_LB_PLAN_H

#include "command.h"

#include "gran_lsd_law.h"
#include "lbm_plan.h"

#include <set>

namespace LAMMPS_NS {

// Numbers for a run with fix lb/ibb, from what is wanted of it: parses the wish, looks at box and
// grains, prints the advice and leaves it in variables.
class LBPlan : public Command {
 public:
  LBPlan(class LAMMPS *lmp) : Command(lmp) {}
  void command(int narg, char **arg) override;

 private:
  // the command line
  int narg = 0, iarg = 0;
  char **arg = nullptr;
  lbm::Wish wish;
  std::set<std::string> given;
  std::string prefix = "lb", group_name;
  bool single = false, moving = true, measure = true;
  GranLSD::Material material{};
  double density = 0.0;    // of the grains
  void parse();
  void keyword(const std::string &name);
  void check();
  double positive(const std::string &what);
  const char *next(const std::string &what);
  bool chosen(const std::string &what, const char *yes, const char *no);
  bool has(const std::string &name) const { return given.count(name) > 0; }

  // what is there already
  double grains = 1.0, lightest = 0.0;    // their number; smallest mass
  double square = 0.0, crowded = 0.0;     // sum of r^2, and that of the rank with most
  void look_at_box();
  void look_at_grains();
  void find_contact();

  // the cost
  lbm::Int3 local_nodes(const lbm::Int3 &nodes) const;    // of the fullest rank
  lbm::Pace pace(const lbm::Advice &advice, const lbm::Int3 &n);
  struct Cost {
    lbm::Pace pace;
    lbm::Work work;
    double memory = 0.0, seconds = 0.0;    // MiB of the fullest rank
  };
  Cost cost(const lbm::Advice &advice);

  std::string report(const lbm::Advice &advice, const Cost &cost,
                     const lbm::Accuracy &accuracy) const;
  void define(const lbm::Advice &advice, const Cost &cost);
};

}    // namespace LAMMPS_NS
#endif
#endif
