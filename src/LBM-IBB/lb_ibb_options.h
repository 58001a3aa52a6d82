/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org
   This software is distributed under the GNU General Public License,
   version 2.
   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What the user wrote on the line of fix lb/ibb, checked word by word. Units of the script.

#ifndef LMP_LB_IBB_OPTIONS_H
#define LMP_LB_IBB_OPTIONS_H

#include "lbm_solver.h"
#include "pointers.h"

#include <string>

namespace LAMMPS_NS {

// a number, or the name of an equal-style variable that gives it
struct LBValue {
  double constant = 0.0;
  std::string variable;
  bool zero() const { return variable.empty() && constant == 0.0; }
  std::string text() const
  {
    return variable.empty() ? fmt::format("{}", constant) : "v_" + variable;
  }
};

using LBVector = std::array<LBValue, 3>;

struct LBFace {
  lbm::FaceKind kind = lbm::FaceKind::PERIODIC;
  LBVector u;
  LBValue p;
  bool parabolic = false;
};

// a region as a solid; its surface may move along itself
struct LBObstacle {
  std::string region;
  lbm::Vec3 velocity{}, omega{}, about{};
  bool has_about = false;    // else the middle of the region
};

struct LBOptions {
  double dx = 0.0, nu = 0.0, rho = 0.0;
  int every = 1, check = 100;
  bool bgk = false, regularised = false, single = false, average = true, conserve = true,
       calibrated = false;
  enum { AUTO, EXPLICIT, IMPLICIT } coupling = AUTO;
  bool has_gradp = false, has_buoyancy = false;
  double magic = 3.0 / 16.0, shrink = 0.0;
  lbm::LinkRule link = lbm::LinkRule::CLI;
  lbm::RefillRule refill = lbm::RefillRule::GRAD;
  LBFace face[3][2];
  static constexpr const char *FACES[3][2] = {{"xlo", "xhi"}, {"ylo", "yhi"}, {"zlo", "zhi"}};
  LBVector accel, gradp, buoyancy;
  const char *link_name() const { return LINKS[int(link)]; }
  static constexpr const char *LINKS[] = {"halfway", "bouzidi", "cli", "zhao"};
  std::vector<LBObstacle> obstacles;
  std::string restart;    // name of a restart file, NONE, or nothing
  static constexpr const char *NONE = "none";
};

class LBOptionsParser : protected Pointers {
 public:
  LBOptionsParser(class LAMMPS *lmp, int narg, char **arg);
  LBOptions parse();

 private:
  int narg, iarg;
  char **arg;
  LBOptions o;

  void keyword();
  void face();
  void obstacle();
  // in lb_ibb_options_check.cpp
  void check_faces() const;
  void check_radius() const;
  void check_flux(int d) const;
  bool meets_walls(int d) const;

  [[noreturn]] void refuse(int at, const std::string &why) const;
  const char *next(const std::string &what);
  double number(const std::string &what);
  double positive(const std::string &what);
  int count(const std::string &what);
  bool follows_number() const;
  LBValue value(const std::string &what);
  LBVector vector(const std::string &what);
  LBVector drive(const std::string &what);
  lbm::Vec3 numbers(const std::string &what);
};

}    // namespace LAMMPS_NS
#endif
