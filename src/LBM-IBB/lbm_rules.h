// SPDX-License-Identifier: GPL-2.0-only
// Rules a set-up has to keep, each with the value, the limit and the remedy. Physical units.
//
// A rule that is broken gives a finding: fatal ones stop the run before its first step.

#ifndef LBM_RULES_H
#define LBM_RULES_H

#include "lbm_units.h"

#include <cmath>
#include <string>
#include <vector>

namespace lbm {

constexpr double MACH_WARN = 0.1, MACH_LIMIT = 0.3;          // Mansouri et al. 2016, section 3.2
constexpr double EXCESS_WARN = 0.05, EXCESS_LIMIT = 0.20;    // of the density
// Density ratio times radius in cells below which a held force, the mean of two steps, may throw a
// grain back and forth: twice what was found
constexpr double LIGHT_LIMIT = 1.6;
constexpr double RADIUS_WARN = 3.5, RADIUS_LIMIT = 2.0;    // cells per radius, section 4.1
constexpr double TAU_LOW = 0.51, TAU_HIGH = 3.0;
constexpr int EVERY_WARN = 1000;    // granular steps per fluid step

// of a speed in lattice units
inline double mach(double speed)
{
  return speed * std::sqrt(3.0);
}

struct Finding {
  bool fatal;
  std::string text;
};

struct Plan {
  Units units{};
  double nu = 0.0;
  int every = 1;                       // granular steps per fluid step
  double pressure_difference = 0.0;    // largest between two pressure faces; 0 if there are none
  double face_speed = 0.0;             // largest speed prescribed at a face
  double smallest_radius = 0.0;        // hydrodynamic; 0 if there are no grains
  double acceleration = 0.0;           // of the fluid, by what drives it
  double obstacle_speed = 0.0;         // largest of the surface of an obstacle
};

std::vector<Finding> review(const Plan &plan);

// Box length L along one direction must be a whole number n >= 3 of cells; returns n, or 0 and the
// reason in text
int cells(double L, double dx, const char *direction, std::string &text);

}    // namespace lbm
#endif
