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
constexpr double RADIUS_WARN = 3.5, RADIUS_LIMIT = 2.0;      // cells per radius, section 4.1
constexpr double TAU_LOW = 0.51, TAU_HIGH = 3.0;
constexpr int EVERY_WARN = 1000;    // granular steps per fluid step

// of a speed in lattice units
inline double mach(double speed)
{
  return speed * std::sqrt(3.0);
}

// Density ratio below which a force that is held for a fluid step, the mean of two of them, may throw a
// grain of r cells back and forth: by the water it has to move along, or, where nu is large, by friction
// that turns it the other way, of 15 nu/(ratio r^2) per step alone in Stokes flow. With what more narrow
// gaps ask for, most in 2d: doc/stability.md, crowds.
inline double light_below(double r, double tau, int dimension)
{
  const double nu = (tau - 0.5) / 3.0, limit = std::fmax(2.5 / r, 15.0 * nu / (r * r));
  return dimension == 2 ? std::fmax(limit, 50.0 / (r * r)) : limit;
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
