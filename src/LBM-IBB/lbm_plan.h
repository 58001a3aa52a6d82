// SPDX-License-Identifier: GPL-2.0-only
// From what is wanted to the numbers of a run: spacing, time steps, and what they cost. Physical
// units; the rules themselves are those of lbm_rules.h.
//
// The error of a run has a part of the lattice, a = A dx^2, and one of its compressibility,
// b = B (dt/dx)^2. The cost is proportional to dx^-3 dt^-1, that is to a^-2 b^-1/2: for a given sum
// it is least at a = 4 b, so a fifth of the error is left to compressibility.

#ifndef LBM_PLAN_H
#define LBM_PLAN_H

#include "lbm_accuracy.h"
#include "lbm_block.h"
#include "lbm_pace.h"
#include "lbm_rules.h"

namespace lbm {

// 0 is "not given" wherever it makes no sense as a value
struct Wish {
  int dimension = 3;
  double nu = 0.0, rho = 0.0;
  double dx = 0.0;          // else from the error
  double error = 0.0;       // a fraction, of the quantity
  std::string quantity;     // of the table of errors
  double tau = 0.0;         // else as large as the rules allow
  double speed = 0.0;       // largest expected; else from pressure and permeability
  double pressure = 0.0;    // difference across the height
  double smallest = 0.0;    // radius
  double mean = 0.0;        // radius
  double ratio = 0.0;       // density of grains / rho
  double contact = 0.0;     // longest granular step that the contacts allow
  double fraction = 0.0;    // of solid in the bed
  double height = 0.0;      // of the bed
  double permeability = 0.0;
  double time = 0.0;    // to be simulated
  Vec3 box{};
};

struct Advice {
  std::string
      refusal;    // why the wish cannot be granted, and the nearest that can; the rest is void
  Units units{};
  int every = 1;
  double step = 0.0;                 // granular
  std::string binds_dx, binds_dt;    // the rule that decides
  std::vector<std::string> notes;    // what is to be known beside
  Int3 nodes{};                      // 0: no box
  double tau = 0.0, mach = 0.0, excess = 0.0;
  double speed = 0.0;              // largest, as given or estimated
  double permeability = 0.0;       // as given or estimated
  double grid_error = 0.0;         // 0: not in the table
  double compressibility = 0.0;    // part of the error
  double diffusion = 0.0;          // time that pressure takes through the bed
  double fluid_steps = 0.0;

  double error() const { return grid_error > 0.0 ? grid_error + compressibility : 0.0; }
};

Advice advise(const Wish &wish, const Accuracy &accuracy);

// fraction of solid from which on grains make a bed
constexpr double DENSE = 0.3;

// Kozeny 1927, Carman 1937: k = d^2 (1 - phi)^3 / (180 phi^2)
inline double carman_kozeny(double diameter, double fraction)
{
  const double pores = 1.0 - fraction;
  return diameter * diameter * pores * pores * pores / (180.0 * fraction * fraction);
}

// what a rank with most to do has to do
struct Work {
  double nodes = 0.0, links = 0.0;
  double granular = 0.0;    // seconds of a granular step
};
inline double seconds_of_run(const Advice &advice, const Work &work, const Pace &pace)
{
  const double fluid = work.nodes * pace.node + work.links * pace.link;
  return advice.fluid_steps * (fluid + advice.every * work.granular);
}

}    // namespace lbm
#endif
