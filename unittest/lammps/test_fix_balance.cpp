/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Momentum of fluid and free grains in a box that is periodic all around.

#include "fluid_scenes.h"

#include "update.h"

class BalanceOfFix : public FluidTest {
 protected:
  static constexpr int CHECK = 20;
  static constexpr double G = 0.01;    // under which a grain falls by about a cell in 100 steps
  static constexpr double R = 2.7;
  double density = SOLID;

  int grains() const { return n[2] == 1 ? 9 : 27; }
  double solid() const { return grains() * grain_volume(R) / (24 * 24 * n[2] * cell_volume()); }

  std::string bed(const std::string &options)
  {
    const bool flat = n[2] == 1;
    std::string text;
    for (int k = 0; k < grains(); k++) {
      const Triple c{8.0 * (k % 3) + 4.3 + std::sin(k), 8.0 * (k / 3 % 3) + 4.1 + std::cos(3 * k),
                     8.0 * (k / 9) + 4.2 + std::sin(2 * k)};
      text += flat ? disc(k + 1, c, R) : grain(k + 1, c, R);
    }
    text += std::string("\nset group all density") + (flat ? "/disc " : " ") + num(density);
    return text + "\npair_style gran/lsd/coulomb\npair_coeff * * 0.02 0.8 0.2\ntimestep " +
        num(DT / 5) + "\nfix m all nve/sphere" + (flat ? " disc" : "") +
        "\nneigh_modify delay 0 every 1 check yes" + fluid("every 5 " + options);
  }
  // it falls, its weight carried by the water: nothing acts on the whole
  std::string falling(const std::string &options)
  {
    return bed("check " + std::to_string(CHECK) + " buoyancy 0 " + num(-G) + " 0 gradp 0 " +
               num(-(density - RHO) * G * solid()) + " 0 " + options) +
        "\nfix g all gravity " + num(G) + " vector 0 -1 0";
  }
  // driven for a while, water and grains alike, then left alone
  std::string moving(const std::string &options)
  {
    return "\nvariable a equal 0.02*(step<=1000)" + bed("accel 0 v_a 0 " + options) +
        "\nfix g all gravity v_a vector 0 1 0";
  }

  Triple loads() const    // on the grains, without the part of gradp, which does not change
  {
    Triple sum{};
    for (int i = 0; i < lmp->atom->nlocal; i++)
      for (int d = 0; d < 3; d++) sum[d] += fix()->array_atom[i][d];
    return sum;
  }

  // After so many fluid steps, with what is on its way to the grains, up to what is about the same at
  // all times: the force that is held, and a part of a time step of the one before.
  double momentum(int steps)
  {
    script(run(5 * steps - 5));
    const Triple before = loads();
    script(run(5));
    const Triple last = loads();
    const auto rho = values("density"), u = values("velocity", 1), solid = values("solid");
    double sum = DT * (last[1] + 0.1 * before[1]);
    for (std::size_t k = 0; k < rho.size(); k++)
      if (solid[k] == 0.0) sum += rho[k] * u[k] * cell_volume();
    for (int i = 0; i < lmp->atom->nlocal; i++) sum += lmp->atom->rmass[i] * lmp->atom->v[i][1];
    return sum;
  }

  // of the momentum that the submerged weight gives the grains in a fluid step, mean of all steps
  double drift(const Cells &cells, const std::string &options)
  {
    start();
    const std::string text = box(cells);
    script(text + falling(options));
    const double first = momentum(15 * CHECK), second = momentum(40 * CHECK);
    const double weight = (density - RHO) * lmp->atom->natoms * grain_volume(R) * G;
    return (second - first) / (weight * 40 * CHECK * DT);
  }
};

// Else the whole drifts by a thousandth of what the weight gives, in the mean: of discs lighter than
// water now up, now down.
TEST_F(BalanceOfFix, IsKept)
{
  for (const Cells &cells : {Cells{24, 24, 24}, Cells{24, 24, 1}})
    for (double grain : {SOLID, 700.0}) {
      density = grain;
      double kept = 0.0, lost = 0.0;
      for (const std::string more : {"", "link bouzidi refill local", "collision bgk"}) {
        const double here = std::fabs(drift(cells, more));
        EXPECT_LT(here, 2e-4) << cells[2] << " " << more << " " << density;
        kept += here;
        lost += std::fabs(drift(cells, more + " conserve no"));
      }
      EXPECT_GT(lost, 4.0 * kept) << cells[2] << " " << density;
    }
}

// What moves as a whole goes on so, whatever nodes its grains cover: nothing is missing.
TEST_F(BalanceOfFix, LeavesAloneWhatIsKept)
{
  const auto speeds = [&](const std::string &options) {
    start();
    const std::string text = box({24, 24, 24});
    script(text + moving(options) + run(2000));
    const double before = v(14)[1];
    script(run(2000));
    EXPECT_LT(std::fabs(out(7)), 1e-6 * RHO * G * grains() * grain_volume(R)) << options;
    return std::array<double, 2>{before, v(14)[1]};
  };
  for (const std::string check : {"1", "20"}) {
    const auto [before, after] = speeds("check " + check);
    EXPECT_GT(before, 0.003);
    EXPECT_NEAR(after, before, 1e-5 * before) << check;
  }
}

// Nor is anything taken for grains that go: those that are left, and the water, keep their speed.
TEST_F(BalanceOfFix, GrainsGo)
{
  start();
  const std::string text = box({24, 24, 24});
  script(text + moving("check 20") + run(1600));
  const double water = out(10), grain = v(27)[1];
  script("group gone id <= 20\ndelete_atoms group gone compress no" + run(600));
  EXPECT_NEAR(v(27)[1], grain, 0.01 * grain);
  EXPECT_NEAR(out(10) / (1.0 - 7.0 / 27.0 * solid()), water / (1.0 - solid()), 0.02 * water);
}

// Pairs of overlapping spheres: their volume is that of the union
TEST_F(BalanceOfFix, Clumps)
{
  start();
  const double d = 2.0, a = 0.05;
  const double pair = 2.0 * 4.0 / 3.0 * PI_ * R * R * R -
      PI_ * (4.0 * R + d) * (2.0 * R - d) * (2.0 * R - d) / 12.0;
  std::string text = box({24, 24, 24});
  for (int k = 0; k < 16; k++)
    text += grain(k + 1,
                  {12.0 * (k / 2 % 2) + 5.3, 12.0 * (k / 4 % 2) + 5.1 + d * (k % 2),
                   12.0 * (k / 8) + 5.2 + 0.3 * std::sin(k / 2)},
                  R);
  const double push = RHO * a * (24 * 24 * 24 - 8 * pair) * DX * DX * DX / 16;
  script(
      text + "\npair_style gran/lsd/coulomb\npair_coeff * * 0.02 0.8 0.2\ntimestep " + num(DT / 5) +
      "\nneigh_modify exclude group all all delay 0 every 1 check yes\nvariable b atom ceil(id/2)" +
      fluid("every 5 check 20 accel 0 " + num(a) + " 0") + "\nfix back all addforce 0 " +
      num(-push) + " 0\nfix m all rigid/small custom v_b\nthermo_style custom step" + run(8000));
  const double early = out(10);
  script(run(8000));
  EXPECT_GT(early, 1e-4);
  EXPECT_NEAR(out(10), early, 0.5 * early);
}

// Said in the summary of the run; nothing is pushed where something else holds fluid or grains.
TEST_F(BalanceOfFix, IsThereWhereNothingHolds)
{
  const std::string kept = "momentum of the whole kept", ball = grain(1, {5.3, 6.1, 4.9}, 3.6);
  const std::string free = "\nfix m all nve/sphere";
  const auto summary = [&](const std::string &boundary, const std::string &fixes,
                           const std::string &options) {
    start();
    return log_of(box({12, 11, 13}, boundary) + ball + fixes + fluid(options) + run(0));
  };
  EXPECT_IN(summary("p p p", free, ""), kept);
  for (const auto &[boundary, fixes, options] :
       {std::array<std::string, 3>{"p p p", "\nfix ice all freeze", ""},
        {"p p p", "\nfix m all move linear 1e-3 0 0", ""},
        {"p p p", "\nfix m all nve/noforce", ""},
        {"p p p", free + "\nfix s all setforce 0 0 0", ""},
        {"p p p", free + "\nregion o sphere 1e-4 1e-4 11e-4 1e-4", "obstacle o"},
        {"p p p", free, "conserve no"},
        {"p p f", free, "face zlo wall face zhi wall"}}) {
    const std::string text = summary(boundary, fixes, options);
    EXPECT_IN(text, "links cli");
    EXPECT_EQ(text.find(kept), std::string::npos) << boundary << fixes << options;
  }
}
