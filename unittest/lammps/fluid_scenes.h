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

// Scenes of the tests of fix lb/ibb: water in cells of 0.1 mm, grains of sand, SI units.  Places and
// radii are given in cells, everything else as a user would write it.

#ifndef LBMIBB_FLUID_SCENES_H
#define LBMIBB_FLUID_SCENES_H

#include "lammps_fixture.h"

#include "fix.h"
#include "modify.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <vector>

static constexpr double DX = 1.0e-4, NU = 1.0e-6, RHO = 1000.0, SOLID = 2600.0;
static constexpr double TAU = 0.8;
static constexpr double DT = (TAU - 0.5) * DX * DX / (3.0 * NU);    // fluid time step, 1 ms
static constexpr double SOUND = DX / DT / 1.7320508075688772;
static constexpr double PI_ = 3.141592653589793;

using Cells = std::array<int, 3>;
using Triple = std::array<double, 3>;

class FluidTest : public LammpsTest {
 protected:
  Cells n{0, 0, 0};    // of the last box()

  static std::string num(double value)
  {
    char text[32];
    snprintf(text, sizeof(text), "%.17g", value);
    return text;
  }
  static std::string nums(const Triple &v) { return num(v[0]) + " " + num(v[1]) + " " + num(v[2]); }
  static std::string at(const Triple &c) { return nums({c[0] * DX, c[1] * DX, c[2] * DX}); }

  // a box of so many cells; n[2] = 1 means two dimensions
  std::string box(const Cells &cells, const std::string &boundary = "p p p",
                  const std::string &extra = "")
  {
    n = cells;
    const bool flat = n[2] == 1;
    return "units si\natom_style sphere\natom_modify map array sort 0 0\ndimension " +
        std::string(flat ? "2" : "3") + "\nboundary " + boundary + "\ncomm_modify vel yes\n" +
        extra + "\nregion box block 0 " + num(n[0] * DX) + " 0 " + num(n[1] * DX) +
        (flat ? " -0.5e-4 0.5e-4" : " 0 " + num(n[2] * DX)) +
        "\ncreate_box 2 box\nneighbor 1e-4 bin\nthermo_modify lost error\ntimestep " + num(DT);
  }

  static std::string grain(int id, const Triple &centre, double r, const Triple &v = {0, 0, 0})
  {
    return ball(id, centre, r, v, " density ");
  }
  static std::string disc(int id, const Triple &centre, double r, const Triple &v = {0, 0, 0})
  {
    return ball(id, {centre[0], centre[1], 0.0}, r, v, " density/disc ");
  }
  static std::string fluid(const std::string &options = "")
  {
    return "\nfix w all lb/ibb dx " + num(DX) + " nu " + num(NU) + " rho " + num(RHO) + " " +
        options;
  }
  static std::string frozen() { return "\nfix ice all freeze"; }
  static std::string run(int steps) { return "\nrun " + std::to_string(steps) + " post no"; }

  double cell_volume() const { return n[2] == 1 ? DX * DX : DX * DX * DX; }
  double grain_volume(double r) const
  {
    return n[2] == 1 ? PI_ * r * r * DX * DX : 4.0 / 3.0 * PI_ * r * r * r * DX * DX * DX;
  }

  // ---- outputs of the fix

  LAMMPS_NS::Fix *fix() const { return lmp->modify->get_fix_by_id("w"); }
  double mass() const { return fix()->compute_scalar(); }
  double out(int i) const { return fix()->compute_vector(i - 1); }
  // hydrodynamic force and torque on a grain
  const double *load(int id) const { return fix()->array_atom[index(id)]; }
  Triple force(int id) const { return {load(id)[0], load(id)[1], load(id)[2]}; }

  template <class F> void for_each_node(F &&f) const
  {
    for (int z = 0; z < n[2]; z++)
      for (int y = 0; y < n[1]; y++)
        for (int x = 0; x < n[0]; x++) f(Cells{x, y, z});
  }
  std::size_t place(const Cells &p) const
  {
    return p[0] + n[0] * (p[1] + std::size_t(n[1]) * p[2]);
  }

  // a field of the fix, node after node; one rank
  std::vector<double> values(const char *name, int column = 0) const
  {
    int ncol;
    const int which = fix()->get_griddata_by_name(0, name, ncol);
    void *data = fix()->get_griddata_by_index(which);
    std::vector<double> all;
    for_each_node([&](const Cells &p) {
      if (n[2] == 1)
        all.push_back(ncol ? ((double ***) data)[p[1]][p[0]][column]
                           : ((double **) data)[p[1]][p[0]]);
      else
        all.push_back(ncol ? ((double ****) data)[p[2]][p[1]][p[0]][column]
                           : ((double ***) data)[p[2]][p[1]][p[0]]);
    });
    return all;
  }
  double field(const char *name, const Cells &p, int column = 0) const
  {
    return values(name, column)[place(p)];
  }

  // all of the fluid
  std::vector<double> state() const
  {
    std::vector<double> all = values("density"), solid = values("solid");
    all.insert(all.end(), solid.begin(), solid.end());
    for (int d = 0; d < 3; d++) {
      const auto u = values("velocity", d);
      all.insert(all.end(), u.begin(), u.end());
    }
    return all;
  }

  // sum of rho u over the fluid, from its fields
  Triple momentum() const
  {
    const auto rho = values("density");
    Triple sum{};
    for (int d = 0; d < 3; d++) {
      const auto u = values("velocity", d);
      for (std::size_t k = 0; k < u.size(); k++) sum[d] += rho[k] * u[k] * cell_volume();
    }
    return sum;
  }

  // nodes (cell centres) strictly inside a sphere or disc, counted anew; periodic
  int covered(const Triple &c, double r) const
  {
    int count = 0;
    for_each_node([&](const Cells &p) {
      double rsq = 0.0;
      for (int d = 0; d < (n[2] == 1 ? 2 : 3); d++) {
        double away = p[d] + 0.5 - c[d];
        away -= n[d] * std::nearbyint(away / n[d]);
        rsq += away * away;
      }
      count += rsq < r * r;
    });
    return count;
  }
  // pairs of a fluid node and a solid one next to it, straight or diagonal in a plane; periodic
  int cut_links() const
  {
    const auto inside = values("solid");
    auto solid = [&](Cells p) {
      for (int d = 0; d < 3; d++) p[d] = (p[d] + n[d]) % n[d];
      return inside[place(p)] == 1.0;
    };
    int count = 0;
    for_each_node([&](const Cells &p) {
      if (solid(p)) return;
      for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
          for (int z = (n[2] == 1 ? 0 : -1); z <= (n[2] == 1 ? 0 : 1); z++)
            count += x * x + y * y + z * z <= 2 && solid({p[0] + x, p[1] + y, p[2] + z});
    });
    return count;
  }
  // what LAMMPS writes into its log file meanwhile
  std::string log_of(const std::string &text)
  {
    script("log fluid.log");
    const std::string message = error_of(text);
    script("log none");
    std::ifstream file("fluid.log");
    std::stringstream all;
    all << file.rdbuf() << message;
    std::remove("fluid.log");
    return all.str();
  }
  int all_nodes() const { return n[0] * n[1] * n[2]; }

 private:
  static std::string ball(int id, const Triple &centre, double r, const Triple &v,
                          const std::string &density)
  {
    const std::string name = "\nset atom " + std::to_string(id);
    return "\ncreate_atoms 1 single " + at(centre) + name + " diameter " + num(2.0 * r * DX) +
        name + density + num(SOLID) + name + " vx " + num(v[0]) + " vy " + num(v[1]) + " vz " +
        num(v[2]);
  }
};

#define EXPECT_IN(text, piece)                                                                   \
  do {                                                                                           \
    const std::string whole = (text);                                                            \
    EXPECT_NE(whole.find(piece), std::string::npos) << "no '" << (piece) << "' in:\n" << whole; \
  } while (0)

#define EXPECT_NOT_IN(text, piece)                                                               \
  do {                                                                                           \
    const std::string whole = (text);                                                            \
    EXPECT_EQ(whole.find(piece), std::string::npos) << "'" << (piece) << "' in:\n" << whole;    \
  } while (0)

#endif
