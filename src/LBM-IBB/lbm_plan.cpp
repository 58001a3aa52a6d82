// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_plan.h"

#include "lbm_text.h"

#include <algorithm>

namespace lbm {
namespace {

  constexpr double SHARE = 0.2;             // of the error for compressibility, see lbm_plan.h
  constexpr double LEAST_SHARE = 1e-3;      // where the spacing, not an error is wished
  constexpr double UNKNOWN_SHARE = 5e-3;    // where no table tells the error of the spacing
  // TRT with CLI is independent of tau in steady flow; the settling sphere changes by .2 % from .8
  // to 1.5
  constexpr double TAU_BEST = 1.5;
  constexpr double PORE_PEAK = 8.0;    // largest over mean speed in pores; quicksand example: 7
  constexpr double WAIT = 10.0;        // the run over the time that pressure takes through the bed
  constexpr double TIGHT = 1.0 - 1e-9;    // limits are met, whatever the rounding

  // dt/dx up to a limit, and its name
  struct Limit {
    double slope = 1e300;
    std::string name;
    void lower(double other, const std::string &why)
    {
      if (!(other < slope)) return;
      slope = other;
      name = why;
    }
  };

  class Adviser {
   public:
    Adviser(const Wish &wish, const Accuracy &accuracy) : w(wish), accuracy(accuracy)
    {
      known = !w.quantity.empty() && accuracy.knows(w.quantity);
    }
    Advice advise()
    {
      estimate();
      if (choose_spacing() && choose_step()) review_all();
      return a;
    }

   private:
    const Wish &w;
    const Accuracy &accuracy;
    bool known;
    Advice a;

    // grains of all sizes resist the flow through a bed
    double radius() const { return w.quantity == "permeability" ? w.mean : w.smallest; }

    bool refuse(const std::string &why)
    {
      a.refusal = why;
      return false;
    }

    // permeability and speed, as far as they follow from what is given
    void estimate()
    {
      a.permeability = w.permeability;
      if (a.permeability == 0.0 && w.dimension == 3 && w.fraction >= DENSE)
        a.permeability = carman_kozeny(2.0 * w.mean, w.fraction);
      a.speed = w.speed;
      const bool bed = w.fraction > 0.0 && w.height > 0.0 && a.permeability > 0.0;
      if (a.speed == 0.0 && w.pressure > 0.0 && bed) {
        const double flux = a.permeability * w.pressure / (w.rho * w.nu * w.height);
        a.speed = PORE_PEAK * flux / (1.0 - w.fraction);
        a.notes.push_back(print("speed %.4g: %g times the mean in the pores, of a flux of %.4g",
                                a.speed, PORE_PEAK, flux));
      }
      if (a.speed == 0.0) a.notes.push_back("no speed is known: the Mach number is not looked at");
    }

    // what the fix lets pass without a warning
    Limit hard_limits() const
    {
      Limit limit;
      if (a.speed > 0.0)
        limit.lower(MACH_WARN / (std::sqrt(3.0) * a.speed), print("Mach number %g", MACH_WARN));
      if (w.pressure > 0.0)
        limit.lower(std::sqrt(EXCESS_WARN * w.rho / (3.0 * w.pressure)),
                    print("density change %g %%", 100.0 * EXCESS_WARN));
      return limit;
    }

    // error by compressibility over (dt/dx)^2. Speed: what the equilibrium of second order lacks is
    // (u/c)^2 = Ma^2/3; in the settling sphere half the Mach number changes as much. Pressure: the
    // mass flux of slow flow is exact, the velocity differs by half of the change of density.
    double compressible() const { return a.speed * a.speed + 1.5 * w.pressure / w.rho; }

    // and what the error wants
    Limit soft_limits(double share) const
    {
      Limit limit = hard_limits();
      if (compressible() > 0.0)
        limit.lower(std::sqrt(share / compressible()),
                    print("compressibility, %.2g %% of error", 100.0 * share));
      // t_d = n nu H^2 / (k c_s^2), from the balance of mass in a bed of compressible water
      if (w.pressure > 0.0 && w.time > 0.0 && w.height > 0.0 && a.permeability > 0.0)
        limit.lower(std::sqrt(w.time * a.permeability /
                              (3.0 * WAIT * (1.0 - w.fraction) * w.nu * w.height * w.height)),
                    print("pressure through the bed in 1/%g of the time", WAIT));
      return limit;
    }

    // dx that a slope dt/dx needs for a relaxation time that is not too small
    double largest_spacing(double slope) const { return 3.0 * w.nu * slope / (TAU_LOW - 0.5); }

    bool choose_spacing()
    {
      double dx = w.dx;
      a.binds_dx = "as given";
      if (dx == 0.0) {
        const double r = accuracy.radius(w.quantity, (1.0 - SHARE) * w.error, w.fraction);
        dx = radius() / r;
        a.binds_dx = print("error of %s at %.3g cells per %s radius", w.quantity.c_str(), r,
                           radius() > w.smallest ? "mean" : "smallest");
        if (w.smallest / RADIUS_WARN < dx) {
          dx = w.smallest / RADIUS_WARN * TIGHT;
          a.binds_dx = print("at least %g cells per radius", RADIUS_WARN);
        }
        const Limit limit = soft_limits(SHARE * w.error);
        if (largest_spacing(limit.slope) < dx) {
          dx = largest_spacing(limit.slope) * TIGHT;
          a.binds_dx = print("relaxation time >= %g at %s", TAU_LOW, limit.name.c_str());
        }
      } else if (w.smallest / dx < RADIUS_LIMIT) {
        return refuse(
            print("the smallest radius %g is %.3g cells of dx = %g, limit %g: the nearest "
                  "possible is dx = %.6g, good is dx <= %.6g",
                  w.smallest, w.smallest / dx, dx, RADIUS_LIMIT, w.smallest / RADIUS_LIMIT,
                  w.smallest / RADIUS_WARN));
      }
      if (w.box[0] > 0.0 && !fit(dx)) return false;
      a.units = {dx, 0.0, w.rho, w.dimension};
      if (known) a.grid_error = accuracy.error(w.quantity, radius() / dx, w.fraction);
      return true;
    }

    int count(int n, int d) const    // cells along d if there are n along x
    {
      std::string why;
      return cells(w.box[d], w.box[0] / n, "", why);
    }
    bool divides(int n) const
    {
      for (int d = 0; d < w.dimension; d++)
        if (!count(n, d)) return false;
      return true;
    }

    // to a spacing that divides the box; a wished one is not changed
    bool fit(double &dx)
    {
      const double exact = w.box[0] / dx;
      if (!(exact < 1e6))
        return refuse(print("dx = %g would be %.3g cells along x: too many", dx, exact));
      const int first = std::max(1, int(std::ceil(exact * (1.0 - 1e-6))));
      int finer = first, coarser = first - 1;
      while (finer <= 2 * first + 10 && !divides(finer)) finer++;
      while (coarser > 0 && !divides(coarser)) coarser--;
      const bool found = finer <= 2 * first + 10;
      if (found && (w.dx == 0.0 || std::fabs(exact - finer) <= 1e-6 * exact)) {
        if (w.dx == 0.0) dx = w.box[0] / finer;
        for (int d = 0; d < w.dimension; d++) a.nodes[d] = count(finer, d);
        if (w.dimension == 2) a.nodes[2] = 1;
        return true;
      }
      std::string near;
      if (found) near = print("%.10g", w.box[0] / finer);
      if (coarser > 0) near += print("%s%.10g", found ? " and " : "", w.box[0] / coarser);
      std::string lengths;
      for (int d = 0; d < w.dimension; d++)
        lengths +=
            print("%s%.8g", d ? " x " : "", std::max(3.0, std::nearbyint(w.box[d] / dx)) * dx);
      return refuse(
          print("dx = %.8g does not divide all lengths of the box: nearest that do %s; or "
                "make the box %s",
                dx, near.empty() ? "are none above a half of it" : ("are " + near).c_str(),
                lengths.c_str()));
    }

    bool choose_step()
    {
      const double dx = a.units.dx;
      const Limit hard = hard_limits();
      // of a slope dt/dx, and of a relaxation time
      auto tau_of = [&](double slope) {
        return 0.5 + 3.0 * w.nu * slope / dx;
      };
      auto step_of = [&](double tau) {
        return (tau - 0.5) * dx * dx / (3.0 * w.nu);
      };
      const double largest = std::min(TAU_HIGH, tau_of(hard.slope));
      if (largest < TAU_LOW) {
        const double slope = step_of(TAU_LOW) / dx;
        std::string other;
        if (hard.name.compare(0, 4, "Mach") == 0)
          other =
              print("speed <= %.6g%s", MACH_WARN / (std::sqrt(3.0) * slope),
                    w.speed > 0.0 ? "" : print(" (%.4g is estimated: give it)", a.speed).c_str());
        else
          other = print("a pressure <= %.6g", EXCESS_WARN * w.rho / (3.0 * slope * slope));
        return refuse(
            print("%s allows a relaxation time of %.5g at dx = %.6g, and below %g runs are "
                  "not stable: the nearest possible are dx <= %.6g, or %s",
                  hard.name.c_str(), largest, dx, TAU_LOW, largest_spacing(hard.slope) * TIGHT,
                  other.c_str()));
      }
      if (w.tau > 0.0) {
        if (!(w.tau >= TAU_LOW && w.tau <= largest * (1.0 + 1e-9)))
          return refuse(print("tau = %g is not possible at dx = %.6g: the nearest is %.6g (%s)",
                              w.tau, dx, w.tau < TAU_LOW ? TAU_LOW : largest,
                              w.tau < TAU_LOW        ? "below, runs are not stable"
                                  : w.tau > TAU_HIGH ? "above, accuracy is lost"
                                                     : hard.name.c_str()));
        a.units.dt = step_of(w.tau);
        a.binds_dt = "tau as given";
      } else {
        const double share = w.error > 0.0 && w.dx == 0.0 ? SHARE * w.error
            : known ? std::max(LEAST_SHARE, SHARE / (1.0 - SHARE) * a.grid_error)
                    : UNKNOWN_SHARE;
        Limit limit = soft_limits(share);
        limit.lower(step_of(TAU_BEST) / dx, print("relaxation time %g", TAU_BEST));
        if (w.contact > 0.0 && limit.slope * dx > EVERY_WARN * w.contact) {
          const double softer = limit.slope * dx / w.contact / 100.0;
          a.notes.push_back(print("%s would allow %.4g granular steps per fluid step; a contact "
                                  "stiffness %.3g times smaller would need 100 of them",
                                  limit.name.c_str(), 100.0 * softer, softer * softer));
          limit.lower(EVERY_WARN * w.contact / dx,
                      print("%d granular steps per fluid step", EVERY_WARN));
        }
        const double lowest = step_of(TAU_LOW) / dx;
        if (limit.slope < lowest) {
          a.notes.push_back(print("%s would ask for tau = %.5g: less than %g is not stable",
                                  limit.name.c_str(), tau_of(limit.slope), TAU_LOW));
          limit = {lowest, print("relaxation time >= %g", TAU_LOW)};
        }
        a.units.dt = limit.slope * dx;
        a.binds_dt = limit.name;
      }
      // eqs 21 and 22 of Mansouri et al. 2016, without their one more where the ratio is whole
      const double ratio = w.contact > 0.0 ? a.units.dt / w.contact * TIGHT : 1.0;
      if (!(ratio < 1e9))
        return refuse(print("contacts allow a granular step of %g, a fluid step %g: soften them",
                            w.contact, a.units.dt));
      a.every = std::max(1, int(std::ceil(ratio)));
      a.step = a.units.dt / a.every;
      return true;
    }

    void review_all()
    {
      const Units &units = a.units;
      a.tau = units.tau(w.nu);
      a.mach = a.speed / units.sound_speed();
      a.excess = units.density_excess(w.pressure);
      a.compressibility = compressible() * (units.dt / units.dx) * (units.dt / units.dx);
      const double cs = units.sound_speed();
      if (w.pressure > 0.0 && a.permeability > 0.0 && w.height > 0.0)
        a.diffusion = (1.0 - w.fraction) * w.nu * w.height * w.height / (a.permeability * cs * cs);
      if (w.time > 0.0) a.fluid_steps = std::ceil(w.time / units.dt * TIGHT);
      const double r = w.smallest / units.dx;
      for (const Finding &found :
           review({units, w.nu, a.every, w.pressure, 0.0, w.smallest, 0.0})) {
        if (found.fatal) {
          refuse(found.text);
          return;
        }
        a.notes.push_back(found.text);
      }
      if (w.ratio > 0.0 && w.ratio < light_below(r, units.tau(w.nu), w.dimension))
        a.notes.push_back(print("grains of %.3g times the density of the fluid are light: keep "
                                "coupling auto",
                                w.ratio));
      if (w.error > 0.0 && a.error() > w.error * (1.0 + 1e-6))
        a.notes.push_back(
            print("the error wished, %g, needs less dx or a shorter step than given: %.3g "
                  "is expected",
                  w.error, a.error()));
    }
  };

}    // namespace

Advice advise(const Wish &wish, const Accuracy &accuracy)
{
  return Adviser(wish, accuracy).advise();
}

}    // namespace lbm
