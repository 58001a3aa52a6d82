// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_rules.h"

#include "lbm_text.h"

namespace lbm {
namespace {

  // largest tau whose density change under a pressure difference stays below eps:
  // (tau - 1/2)^2 <= 3 eps rho nu^2 / (dp dx^2)
  double largest_tau(double eps, const Units &units, double nu, double pressure_difference)
  {
    return 0.5 + std::sqrt(3.0 * eps * units.rho / pressure_difference) * nu / units.dx;
  }

  void review_tau(const Plan &p, std::vector<Finding> &found)
  {
    const double tau = p.units.tau(p.nu);
    if (!(tau > 0.5) || !std::isfinite(tau))
      found.push_back(
          {true,
           print("relaxation time tau = %g must be larger than 1/2, and 1/2 + 3 nu dt/dx^2 with nu "
                 "= %g, "
                 "a fluid time step of %g and dx = %g is not: enlarge timestep or every",
                 tau, p.nu, p.units.dt, p.units.dx)});
    else if (tau < TAU_LOW)
      found.push_back(
          {false,
           print(
               "relaxation time tau = %.6g is close to 1/2: stable only while u dx/nu stays below "
               "about 20 (u < %.3g); a larger time step or a smaller dx raises tau",
               tau, 20.0 * p.nu / p.units.dx)});
    else if (tau > TAU_HIGH * (1.0 + 1e-9))    // at the limit itself, by a rounded fluid step, is well
      found.push_back(
          {false,
           print("relaxation time tau = %.4g is large: accuracy is lost above %g; reduce "
                 "the fluid time step (timestep, every) or enlarge dx",
                 tau, TAU_HIGH)});
  }

  void review_pressure(const Plan &p, std::vector<Finding> &found)
  {
    if (p.pressure_difference <= 0.0) return;
    const double excess = p.units.density_excess(p.pressure_difference);
    if (excess <= EXCESS_WARN) return;
    const bool fatal = excess > EXCESS_LIMIT;
    const double eps = fatal ? EXCESS_LIMIT : EXCESS_WARN;
    const double tau = largest_tau(eps, p.units, p.nu, p.pressure_difference);
    const double dt = (tau - 0.5) * p.units.dx * p.units.dx / (3.0 * p.nu);
    found.push_back(
        {fatal,
         print("pressure difference %g between faces changes the density by %.3g %%, "
               "limit %g %%: the largest relaxation time allowed here is tau = %.4f, a "
               "fluid time step of %.4g (now tau = %.4f, %.4g); reduce timestep or every",
               p.pressure_difference, 100.0 * excess, 100.0 * eps, tau, dt, p.units.tau(p.nu),
               p.units.dt)});
  }

  void review_speed(const Plan &p, double speed, const char *where, std::vector<Finding> &found)
  {
    const double Ma = speed / p.units.sound_speed();
    if (Ma <= MACH_WARN) return;
    found.push_back({Ma > MACH_LIMIT,
                     print("speed %g prescribed at %s is Ma = %.3g of the lattice's sound speed, "
                           "limit %g: reduce the fluid time step (timestep, every) or enlarge dx",
                           speed, where, Ma, Ma > MACH_LIMIT ? MACH_LIMIT : MACH_WARN)});
  }

  // half of the force of a step is in the velocity of that step
  void review_acceleration(const Plan &p, std::vector<Finding> &found)
  {
    const double speed = 0.5 * p.acceleration * p.units.dt, Ma = speed / p.units.sound_speed();
    if (Ma <= MACH_LIMIT) return;
    found.push_back({true,
                     print("accel and gradp give the fluid a speed of %g within half a fluid step, "
                           "Ma = %.3g of the lattice's sound speed, limit %g: reduce them, or the "
                           "fluid time step (timestep, every)",
                           speed, Ma, MACH_LIMIT)});
  }

  void review_radius(const Plan &p, std::vector<Finding> &found)
  {
    if (p.smallest_radius <= 0.0) return;
    const double r = p.smallest_radius / p.units.dx;
    if (r >= RADIUS_WARN) return;
    const bool fatal = r < RADIUS_LIMIT;
    const double limit = fatal ? RADIUS_LIMIT : RADIUS_WARN;
    found.push_back(
        {fatal,
         print("smallest hydrodynamic radius %g is %.3g cells, limit %g: use dx <= %.4g",
               p.smallest_radius, r, limit, p.smallest_radius / limit)});
  }

  void review_every(const Plan &p, std::vector<Finding> &found)
  {
    if (p.every > EVERY_WARN)
      found.push_back({false,
                       print("every %d: more than 1000 granular steps per fluid step; a contact "
                             "stiffness %.3g times smaller would need 100",
                             p.every, (p.every / 100.0) * (p.every / 100.0))});
  }

}    // namespace

std::vector<Finding> review(const Plan &plan)
{
  std::vector<Finding> found;
  review_tau(plan, found);
  review_pressure(plan, found);
  review_speed(plan, plan.face_speed, "a face", found);
  review_speed(plan, plan.obstacle_speed, "the surface of an obstacle", found);
  review_acceleration(plan, found);
  review_radius(plan, found);
  review_every(plan, found);
  return found;
}

int cells(double L, double dx, const char *direction, std::string &text)
{
  const double n = L / dx, whole = std::nearbyint(n);
  if (!(n < 2147483000.0)) {
    text = print("box length %g along %s is %.4g cells of dx = %g: too many", L, direction, n, dx);
    return 0;
  }
  if (n < 3.0 * (1.0 - 1e-6)) {
    text = print("box length %g along %s is %g cells of dx = %g: at least 3 are needed, dx <= %.6g",
                 L, direction, n, dx, L / 3.0);
    return 0;
  }
  if (std::fabs(n - whole) > 1e-6 * n) {
    text =
        print("dx = %.8g does not divide the box length %.8g along %s (%.6g cells): nearest that "
              "do are %.10g and %.10g",
              dx, L, direction, n, L / (std::floor(n) + 1.0), L / std::floor(n));
    return 0;
  }
  return int(whole);
}

}    // namespace lbm
