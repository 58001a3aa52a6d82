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

/* ----------------------------------------------------------------------
   Contributing authors: LBM-IBB developers
------------------------------------------------------------------------- */

/* ----------------------------------------------------------------------
   Contact law of grains and walls: linear spring and dashpot along the
   normal, Coulomb friction in the tangent plane.  No LAMMPS in here: the
   pair style, the wall fix and the tests all call evaluate().

   Source: Mansouri, El Youssoufi, Nicot, Int. J. Numer. Anal. Meth.
   Geomech. 41, 338 (2017), eqs (2) to (6), read as follows:
   - eq. (2) and eq. (4) as printed give the force on different grains; here
     both are forces on i, so that the spring repels and friction opposes
     the slip of i over j;
   - eq. (5) writes "log" and "ln": both are natural logarithms;
   - t_c of eq. (6) leaves the damping out; contact_time() has it.
------------------------------------------------------------------------- */

#ifndef LMP_GRAN_LSD_LAW_H
#define LMP_GRAN_LSD_LAW_H

#include <cmath>

namespace GranLSD {

static constexpr double PI = 3.14159265358979323846;

// I/(m r^2): bodies of LAMMPS's fix nve/sphere, without and with "disc"

static constexpr double INERTIA_SPHERE = 2.0 / 5.0;
static constexpr double INERTIA_DISC = 1.0 / 2.0;

// longest time step, as a fraction of the contact duration: beyond the first
// a contact is not resolved any more, beyond the second e is off by a percent

static constexpr double STEP_LIMIT = 1.0 / 10.0;
static constexpr double STEP_GOOD = 1.0 / 50.0;

struct Material {
  double kn;    // stiffness of the normal spring
  double e;     // coefficient of restitution, 0 < e <= 1
  double mu;    // coefficient of friction
};

/* fraction of critical damping that makes the restitution e; 0 for e = 1 */

inline double damping_ratio(double e)
{
  const double loge = std::log(e);
  return -loge / std::sqrt(PI * PI + loge * loge);
}

/* eq. (5) */

inline double damping(const Material &mat, double meff)
{
  return 2.0 * damping_ratio(mat.e) * std::sqrt(mat.kn * meff);
}

/* from first touch to parting: half a period of the damped oscillator */

inline double contact_time(const Material &mat, double meff)
{
  const double loge = std::log(mat.e) / PI;
  return PI * std::sqrt(meff / mat.kn) * std::sqrt(1.0 + loge * loge);
}

// the law with what depends on the material alone worked out

struct Law {
  double kn;
  double twozeta;    // twice the damping ratio
  double mu;
  bool cut;    // no attraction: the net normal force is not below zero
};

inline Law make_law(const Material &mat, bool cut)
{
  return {mat.kn, 2.0 * damping_ratio(mat.e), mat.mu, cut};
}

// One side of a contact.  A wall or a grain that nothing can move has inverse
// mass and inertia 0.

struct Side {
  const double *v, *omega;
  double arm;    // from the centre to the contact point
  double inv_mass, inv_inertia;
};

inline Side make_side(const double *v, const double *omega, double radius, double arm, double mass,
                      double inertia_factor)
{
  return {v, omega, arm, 1.0 / mass, 1.0 / (inertia_factor * mass * radius * radius)};
}

// What side i feels; side j feels the opposite force.  The torques are
// -arm * (n x fs) on both.

struct Force {
  double fn;         // along n, positive = repulsion
  double fs[3];      // friction
  double vn;         // normal velocity, negative = approach
  double slip[3];    // velocity of i over j in the contact point
};

/* ----------------------------------------------------------------------
   n = unit vector from j to i, overlap > 0, both sides not fixed at once.

   Normal: F_n = k_n overlap - c v_n, c of eq. (5).  LAMMPS's velocities are
   half a step old when forces are computed.  A dashpot on such velocities
   turns e into e^(1 + a/2), a = c dt/(2 m_eff), as the eigenvalues of the
   time-stepping map show; c/(1 + a/2) takes that back to second order in dt.

   Tangential: eq. (4) jumps at zero slip, and a friction of full size on a
   slip of round-off size would be noise.  So the friction never exceeds
   what stops the slip v_s within one step, m_t v_s/dt:
     1/m_t = 1/m_i + arm_i^2/I_i + 1/m_j + arm_j^2/I_j,
   that is m_t = 2/7 m_eff for spheres and 1/3 m_eff for discs in touch.
   Of a third, one and two times this cap, a bed of 100 grains at rest
   creeps least with one.
   While the net normal force attracts there is no friction.
------------------------------------------------------------------------- */

inline Force evaluate(const Law &law, double overlap, const double *n, const Side &i, const Side &j,
                      double dt)
{
  Force out{};

  // velocity of i relative to j, at the contact point

  const double wx = i.arm * i.omega[0] + j.arm * j.omega[0];
  const double wy = i.arm * i.omega[1] + j.arm * j.omega[1];
  const double wz = i.arm * i.omega[2] + j.arm * j.omega[2];
  const double vx = i.v[0] - j.v[0];
  const double vy = i.v[1] - j.v[1];
  const double vz = i.v[2] - j.v[2];
  out.vn = vx * n[0] + vy * n[1] + vz * n[2];
  out.slip[0] = vx - out.vn * n[0] - (wy * n[2] - wz * n[1]);
  out.slip[1] = vy - out.vn * n[1] - (wz * n[0] - wx * n[2]);
  out.slip[2] = vz - out.vn * n[2] - (wx * n[1] - wy * n[0]);

  // normal force

  const double inv_meff = i.inv_mass + j.inv_mass;
  double c = law.twozeta * std::sqrt(law.kn / inv_meff);
  c /= 1.0 + 0.25 * c * dt * inv_meff;
  out.fn = law.kn * overlap - c * out.vn;
  if (law.cut && out.fn < 0.0) out.fn = 0.0;

  // friction

  const double slip =
      std::sqrt(out.slip[0] * out.slip[0] + out.slip[1] * out.slip[1] + out.slip[2] * out.slip[2]);
  double scale = 0.0;
  if (slip > 0.0 && out.fn > 0.0) {
    const double inv_mt =
        i.inv_mass + j.inv_mass + i.arm * i.arm * i.inv_inertia + j.arm * j.arm * j.inv_inertia;
    const double coulomb = law.mu * out.fn;
    scale = (coulomb * dt * inv_mt < slip) ? coulomb / slip : 1.0 / (dt * inv_mt);
  }
  out.fs[0] = -scale * out.slip[0];
  out.fs[1] = -scale * out.slip[1];
  out.fs[2] = -scale * out.slip[2];
  return out;
}

}    // namespace GranLSD

#endif
