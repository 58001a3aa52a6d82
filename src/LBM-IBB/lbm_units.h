// SPDX-License-Identifier: GPL-2.0-only
// The door between physical and lattice units. Factors convert lattice to physical:
//     physical = lattice * factor,  lattice = physical / factor
// Physical units are those of the user's script, if it has no hidden factors (SI, cgs, lj, ...).
// In two dimensions masses, forces and torques are per unit of depth.

#ifndef LBM_UNITS_H
#define LBM_UNITS_H

#include <cmath>

namespace lbm {

struct Units {
  double dx, dt, rho;    // spacing, fluid time step, reference density, all physical
  int dimension;

  double volume() const { return dimension == 2 ? dx * dx : dx * dx * dx; }
  double mass() const { return rho * volume(); }
  double velocity() const { return dx / dt; }
  double spin() const { return 1.0 / dt; }
  double pressure() const { return rho * velocity() * velocity(); }
  double force_density() const { return pressure() / dx; }
  double force() const { return force_density() * volume(); }
  double torque() const { return force() * dx; }

  // c_s^2 = 1/3 in lattice units
  double sound_speed() const { return velocity() / std::sqrt(3.0); }
  // gauge pressure p = c_s^2 (density - rho)
  double density_excess(double p) const { return 3.0 * p / pressure(); }
  double gauge_pressure(double drho) const { return drho * pressure() / 3.0; }

  // Mansouri et al. 2016, eqs 13 and 14: nu = (tau - 1/2) dx^2 / (3 dt)
  double tau(double nu) const { return 0.5 + 3.0 * nu * dt / (dx * dx); }

  // of a sphere; of a disc per unit of depth
  double grain_volume(double r) const
  {
    return dimension == 2 ? M_PI * r * r : 4.0 / 3.0 * M_PI * r * r * r;
  }
};

}    // namespace lbm
#endif
