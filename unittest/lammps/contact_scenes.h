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

// Scenes of the tests of the contact law: grains of sand that meet each other
// and walls.  Lengths, speeds and masses are those of sand, in SI units.

#ifndef LBMIBB_CONTACT_SCENES_H
#define LBMIBB_CONTACT_SCENES_H

#include "lammps_fixture.h"

#include "gran_lsd_law.h"

#include <cmath>
#include <cstdio>

using namespace GranLSD;

static constexpr double DENSITY = 2600.0;
static constexpr double KN = 1000.0;

// so stiff that the overlap is nothing against the radius, for results that
// hold for a point of contact at the radius

static constexpr double STIFF = 1.0e7;
static constexpr double STIFF_DISC = 1.0e10;
static constexpr double GRAVITY = 9.81;

inline double sphere_mass(double r)
{
  return DENSITY * 4.0 / 3.0 * PI * r * r * r;
}

inline double disc_mass(double r)
{
  return DENSITY * PI * r * r;
}

// restitution if the net force may not attract: Schwager and Poeschel, Granular
// Matter 9, 465 (2007)

inline double cut_restitution(double e)
{
  const double zeta = damping_ratio(e);
  const double root = std::sqrt(1.0 - zeta * zeta);
  const double phase = std::atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta);
  return std::exp(-zeta / root * (PI - phase));
}

// friction

struct Impact {
  double kn = KN, e = 0.8, mu = 0.0;
  double r1 = 3.0e-4, r2 = 3.0e-4;
  double vn = 0.05, vt = 0.0;    // approach of 1 to what it hits, and slip
  double parts = 50.0;           // time steps a contact
  double phase = 0.5;            // of a step, at the first touch
  double offset = 0.0;
  double skin = 1.0e-4;
  bool disc = false, newton = true;
  std::string limit = "no", extra;
};

class ContactTest : public LammpsTest {
 protected:
  static std::string num(double value)
  {
    char text[32];
    snprintf(text, sizeof(text), "%.17g", value);
    return text;
  }

  static std::string box(bool disc = false, bool newton = true, double skin = 1.0e-4,
                         const std::string &boundary = "")
  {
    std::string bound = boundary;
    if (bound.empty()) bound = disc ? "f f p" : "f f f";
    return "units si\natom_style sphere\natom_modify map array sort 0 0\n"
           "dimension " +
        std::string(disc ? "2" : "3") + "\nnewton " + (newton ? "on" : "off") + "\nboundary " +
        bound +
        "\ncomm_modify vel yes\n"
        "region box block -0.005 0.005 -0.005 0.005 " +
        (disc ? "-0.001 0.001" : "-0.005 0.005") + "\ncreate_box 2 box\nneighbor " + num(skin) +
        " bin\nneigh_modify delay 0 every 1 check yes\nthermo_style custom step";
  }

  static std::string grain(int id, double px, double py, double pz, double r, bool disc = false)
  {
    const std::string name = std::to_string(id);
    return "\ncreate_atoms 1 single " + num(px) + " " + num(py) + " " + num(pz) + "\nset atom " +
        name + " diameter " + num(2.0 * r) + "\nset atom " + name + " density" +
        (disc ? "/disc " : " ") + num(DENSITY);
  }

  static std::string velocity(int id, double vx, double vy, double vz)
  {
    const std::string name = std::to_string(id);
    return "\nset atom " + name + " vx " + num(vx) + " vy " + num(vy) + " vz " + num(vz);
  }

  static std::string pair(double e, double mu, double offset = 0.0, const std::string &limit = "no",
                          double kn = KN)
  {
    return "\npair_style gran/lsd/coulomb offset " + num(offset) + " limit_damping " + limit +
        "\npair_coeff * * " + num(kn) + " " + num(e) + " " + num(mu);
  }

  static std::string integrate(bool disc = false)
  {
    return disc ? "\nfix move all nve/sphere disc\nfix flat all enforce2d"
                : "\nfix move all nve/sphere";
  }

  static double mass_of(const Impact &c, double r)
  {
    return c.disc ? disc_mass(r) : sphere_mass(r);
  }

  static double pair_duration(const Impact &c)
  {
    const double m1 = mass_of(c, c.r1), m2 = mass_of(c, c.r2);
    return contact_time({c.kn, c.e, c.mu}, m1 * m2 / (m1 + m2));
  }

  static double wall_duration(const Impact &c)
  {
    return contact_time({c.kn, c.e, c.mu}, mass_of(c, c.r1));
  }

  // steps from before an impact to after it

  void run_through(const Impact &c)
  {
    script("run " + std::to_string((int) std::ceil(2.0 * c.parts) + 10) + " post no");
  }

  // grain 1 comes from the left along x, grain 2 rests

  void hit_grain(const Impact &c)
  {
    start();
    const double dt = pair_duration(c) / c.parts;
    const double gap = (2.0 + c.phase) * dt * c.vn;
    script(box(c.disc, c.newton, c.skin) + grain(1, -c.r1 - c.offset - gap, 0, 0, c.r1, c.disc) +
           grain(2, c.r2 + c.offset, 0, 0, c.r2, c.disc) + velocity(1, c.vn, c.vt, 0.0) +
           pair(c.e, c.mu, c.offset, c.limit, c.kn) + integrate(c.disc) + c.extra + "\ntimestep " +
           num(dt));
    run_through(c);
  }

  // grain 1 falls on a floor at y = 0 along -y, without gravity

  void hit_wall(const Impact &c)
  {
    start();
    const double dt = wall_duration(c) / c.parts;
    const double gap = (2.0 + c.phase) * dt * c.vn;
    script(box(c.disc, c.newton, c.skin) + grain(1, 0, c.r1 + c.offset + gap, 0, c.r1, c.disc) +
           velocity(1, c.vt, -c.vn, 0.0) + "\nfix floor all wall/gran/lsd/coulomb " + num(c.kn) +
           " " + num(c.e) + " " + num(c.mu) + " yplane 0 NULL offset " + num(c.offset) +
           " limit_damping " + c.limit + integrate(c.disc) + c.extra + "\ntimestep " + num(dt));
    run_through(c);
  }

  // Restitution, mean over where in a step the grains touch first: the dashpot
  // sets in with a jump, which a time step places to half a step.

  double mean_restitution(Impact c, bool wall)
  {
    static constexpr int PHASES = 16;
    double sum = 0.0;
    for (int p = 0; p < PHASES; p++) {
      c.phase = (p + 0.5) / PHASES;
      if (wall) {
        hit_wall(c);
        sum += v(1)[1] / c.vn;
      } else {
        hit_grain(c);
        sum += (v(2)[0] - v(1)[0]) / c.vn;
      }
    }
    return sum / PHASES;
  }
};

#endif
