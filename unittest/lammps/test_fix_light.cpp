/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Grains lighter than the water they have to move along: implicit coupling.

#include "fluid_scenes.h"

class Light : public FluidTest {
 protected:
  static constexpr double R = 3.3, PUSH = 6.0 * PI_ * 0.1 * R * 0.01;    // lattice units
  // the push, per unit of depth in two dimensions
  double newton() const
  {
    const double push = n[2] == 1 ? 0.1 * PUSH : PUSH;
    return push * RHO * DX * DX * DX * DX / DT / DT / (n[2] == 1 ? DX : 1.0);
  }
  int long_enough() const { return n[2] == 1 ? 3000 : 800; }
  // everything below acts along y, which two dimensions have as well
  std::string ball_of(double ratio, const Triple &at, const Triple &v = {0, 0, 0})
  {
    const std::string solid = num(ratio * RHO);
    return n[2] == 1 ? disc(1, at, R, v) + "\nset atom 1 density/disc " + solid
                     : grain(1, at, R, v) + "\nset atom 1 density " + solid;
  }
  std::string integrator() const
  {
    return n[2] == 1 ? "\nfix m all nve/sphere disc\nfix e all enforce2d"
                     : "\nfix m all nve/sphere";
  }
  std::string duct() const
  {
    return std::string(" face xlo wall face xhi wall ") +
        (n[2] == 1 ? "" : "face zlo wall face zhi wall ");
  }
  std::string in_duct(bool flat) { return box({18, 20, flat ? 1 : 18}, flat ? "f p p" : "f p f"); }
  double speed() const { return v(1)[1] / (DX / DT); }

  // speed that a push leads to
  double terminal(bool flat, double ratio, int every, const std::string &options)
  {
    start();
    const std::string scene = in_duct(flat);
    script(scene + ball_of(ratio, {9.1, 4.3, flat ? 0.0 : 8.8}) + "\ntimestep " + num(DT / every) +
           integrator() + "\nfix push all addforce 0 " + num(newton()) + " 0" +
           fluid(options + " every " + std::to_string(every) + duct()) +
           run(long_enough() * every));
    return speed();
  }
};

// the drag of the same grain, moved at that speed, is the push; explicit coupling of a neutral grain
// gets there as well
TEST_F(Light, RisesAtTheSpeedOfItsDrag)
{
  for (bool flat : {false, true}) {
    const double u = terminal(flat, 0.01, 1, "");
    EXPECT_GT(u, 0.001);
    EXPECT_NEAR(terminal(flat, 0.01, 10, ""), u, 0.01 * u);
    EXPECT_NEAR(terminal(flat, 0.3, 1, ""), u, 0.01 * u);
    EXPECT_NEAR(terminal(flat, 1.5, 1, "coupling explicit"), u, 0.01 * u);
    start();
    const std::string scene = in_duct(flat);
    script(scene + ball_of(0.01, {9.1, 4.3, flat ? 0.0 : 8.8}) + "\nfix m all move linear 0 " +
           num(u * DX / DT) + " 0" + fluid(duct()) + run(long_enough()));
    EXPECT_NEAR(force(1)[1], -newton(), 0.015 * newton());
  }
}

// Gravity and buoyancy cancel to a thousandth: what is left moves the grain as a push does.
TEST_F(Light, SettlesWhenBarelyHeavier)
{
  for (bool flat : {false, true}) {
    const double u = terminal(flat, 1.5, 1, "coupling explicit");
    for (const std::string coupling : {"auto", "implicit"}) {
      start();
      const std::string scene = in_duct(flat);
      const std::string g = num(newton() / (0.001 * RHO * grain_volume(R)));
      script(scene + ball_of(1.001, {9.1, 4.3, flat ? 0.0 : 8.8}) + integrator() +
             "\nfix g all gravity " + g + " vector 0 1 0" +
             fluid("buoyancy 0 " + g + " 0 coupling " + coupling + duct()) + run(long_enough()));
      EXPECT_NEAR(speed(), u, 0.01 * u) << coupling;
    }
  }
}

// no step differs from the one before by more than grid and cover make it
TEST_F(Light, DoesNotRing)
{
  script(in_duct(false) + ball_of(0.01, {9.1, 4.3, 8.8}) + integrator() +
         "\nfix push all addforce 0 " + num(newton()) + " 0" + fluid(duct()) + run(400));
  double before = speed(), ringing = 0.0;
  for (int t = 0; t < 40; t++) {
    script(run(1));
    ringing = std::max(ringing, std::fabs(speed() - before));
    before = speed();
  }
  EXPECT_LT(ringing, 0.02 * before);
}

// of the fluid, the grain, and what is on its way between them: F_ref of the last fluid step, and half
// of the force of the last granular step. So slow that what is quadratic in velocity, the momentum of
// the fluid that a moving surface displaces, is 1e-9 of it
TEST_F(Light, MomentumIsKeptToRoundOff)
{
  for (bool flat : {false, true})
    for (int every : {1, 7}) {
      start();
      const Triple v0{2e-12, 1e-12, 0.0};
      const std::string scene = box({15, 16, flat ? 1 : 14});
      script(scene + ball_of(0.01, {7.1, 7.4, flat ? 0.0 : 6.8}, v0) +
             "\nset atom 1 omega 0 0 1e-8\ntimestep " + num(DT / every) + integrator() +
             fluid("every " + std::to_string(every)));
      const double m = lmp->atom->rmass[0];
      const auto total = [&](int d) {
        double sum = m * v(1)[d] + 0.5 * DT / every * lmp->atom->f[0][d] + DT * force(1)[d];
        const auto rho = values("density"), u = values("velocity", d);
        for_each_node([&](const Cells &p) {    // nothing in solid nodes
          sum += rho[place(p)] * u[place(p)] * cell_volume();
        });
        return sum;
      };
      script(run(every));
      for (int k = 0; k < 6; k++) {
        script(run(5 * every));
        for (int d = 0; d < 2; d++) EXPECT_NEAR(total(d), m * v0[d], 2e-9 * m * v0[0]);
      }
      EXPECT_LT(std::fabs(v(1)[0]), 0.1 * v0[0]);    // it has given most of it away
    }
}

// half of the shear rate, as of a neutral grain: the response to spin
TEST_F(Light, TurnsWithTheShear)
{
  const auto spin = [&](double ratio, const std::string &coupling) {
    start();
    script(box({16, 18, 16}, "p f p") + ball_of(ratio, {8.2, 9.0, 7.9}) + integrator() +
           fluid("face ylo wall -1e-3 0 0 face yhi wall 1e-3 0 0 coupling " + coupling) + run(900));
    return omega(1)[2];
  };
  const double rate = 2e-3 / (18 * DX), light = spin(0.01, "auto");
  EXPECT_NEAR(light, spin(1.0, "explicit"), 0.005 * std::fabs(light));
  EXPECT_NEAR(light, -0.5 * rate, 0.1 * 0.5 * rate);    // walls and images are near
}

TEST_F(Light, SplitRunsAreTheSame)
{
  const auto scene = [&] {
    return box({14, 15, 13}) + ball_of(0.05, {6.3, 5.1, 6.9}, {1e-3, 2e-3, 0}) + "\ntimestep " +
        num(DT / 4) + integrator() + "\nfix push all addforce 1e-9 0 0" + fluid("every 4");
  };
  script(scene() + run(240));
  const std::vector<double> whole{x(1)[0], x(1)[1], v(1)[0], v(1)[1], omega(1)[2]};
  for (const std::string parts : {run(120) + run(120), run(3) + run(58) + run(179)}) {
    start();
    script(scene() + parts);
    const std::vector<double> now{x(1)[0], x(1)[1], v(1)[0], v(1)[1], omega(1)[2]};
    for (std::size_t k = 0; k < now.size(); k++)
      EXPECT_NEAR(now[k], whole[k], 1e-9 * std::fabs(whole[k])) << k;
  }
}

TEST_F(Light, AreFoundByTheirDensity)
{
  const auto has_store = [&](double ratio, const std::string &options,
                             const std::string &more = "") {
    start();
    script(box({14, 15, 13}) + ball_of(ratio, {6.3, 5.1, 6.9}) + integrator() + fluid(options) +
           more + run(1));
    return lmp->modify->get_fix_by_id("w_LIGHT") != nullptr;
  };
  // 2.5 / r with the mean of two steps, r = 3.3, or 5 (tau - 1/2) / r^2; all with one
  EXPECT_TRUE(has_store(0.75, ""));
  EXPECT_FALSE(has_store(0.77, ""));
  EXPECT_TRUE(has_store(1.1, "every 10"));    // tau = 3.5
  EXPECT_FALSE(has_store(1.4, "every 10"));
  EXPECT_TRUE(has_store(10.0, "average no"));
  EXPECT_FALSE(has_store(0.01, "coupling explicit"));
  EXPECT_TRUE(has_store(2.6, "coupling implicit"));
}

// Also with many ghosts, for which there must be room in LAMMPS's buffers.
TEST_F(Light, ManyBecomeLightInARun)
{
  start();
  std::string text = box({40, 40, 40});
  for (int k = 0; k < 512; k++)
    text += grain(k + 1, {5.0 * (k % 8) + 2.5, 5.0 * (k / 8 % 8) + 2.5, 5.0 * (k / 64) + 2.5}, 2.2,
                  {1e-4 * std::sin(k), 0, 1e-4 * std::cos(k)});
  script(text + integrator() + fluid() + run(4));
  EXPECT_EQ(lmp->modify->get_fix_by_id("w_LIGHT"), nullptr);
  script("set group all density 100\nrun 6 pre no post no");
  ASSERT_NE(lmp->modify->get_fix_by_id("w_LIGHT"), nullptr);
  Triple sum{};    // fluid and grains drag each other: nothing but links acts
  for (int i = 0; i < lmp->atom->nlocal; i++)
    for (int d = 0; d < 3; d++) sum[d] += lmp->atom->v[i][d];
  EXPECT_TRUE(std::isfinite(sum[0] + sum[1] + sum[2]));
  for (int i = 0; i < 3; i++) EXPECT_LT(std::fabs(sum[i]), 512 * 1e-4);
}

// Many, some of them less than a cell apart: what sloshes in such gaps throws none of them. With
// the force of single steps not even those of sand, unless they are coupled explicitly.
TEST_F(Light, ManyWithNarrowGaps)
{
  const auto fastest = [&](double ratio, const std::string &options) {
    const double g = 0.016 / std::fabs(ratio - 1.0), r = 2.7, down = ratio < 1.0 ? 1.0 : -1.0;
    start();
    std::string text = box({24, 24, 24});
    for (int k = 0; k < 27; k++)
      text += grain(k + 1,
                    {8.0 * (k % 3) + 4.3 + std::sin(k), 8.0 * (k / 3 % 3) + 4.1 + std::cos(3 * k),
                     8.0 * (k / 9) + 4.2 + std::sin(2 * k)},
                    r);
    const double solid = 27 * 4.0 / 3.0 * PI_ * r * r * r / (24 * 24 * 24);
    script(text + "\nset group all density " + num(ratio * RHO) +
           "\npair_style gran/lsd/coulomb\npair_coeff * * 0.02 0.8 0.2\ntimestep " + num(DT / 20) +
           "\nfix m all nve/sphere\nfix g all gravity " + num(g) +
           " vector 0 -1 0\nneigh_modify delay 0 every 1 check yes" +
           fluid("every 20 buoyancy 0 " + num(-g) + " 0 gradp 0 " +
                 num((1.0 - ratio) * RHO * g * solid) + " 0 " + options) +
           run(20 * 700));
    EXPECT_GT(down * v(14)[1], 0.0);
    return out(3);
  };
  for (double ratio : {0.1, 0.5}) EXPECT_LT(fastest(ratio, ""), 0.003) << ratio;
  for (double ratio : {0.5, 2.6}) EXPECT_LT(fastest(ratio, "average no"), 0.003) << ratio;
  EXPECT_THROW(fastest(2.6, "average no coupling explicit"), std::exception);
}

TEST_F(Light, AHeldForceThrowsThem)
{
  const auto warnings = [&](double ratio, const std::string &options, const std::string &fixes) {
    start();
    return log_of(box({28, 15, 13}) + grain(1, {6.3, 5.1, 6.9}, R) + grain(2, {20.3, 5.1, 6.9}, R) +
                  "\nset group all density " + num(ratio * RHO) + fixes + fluid(options) + run(1));
  };
  const std::string thrown = "2 grains may be thrown to and fro by the water";
  EXPECT_IN(warnings(0.5, "coupling explicit", integrator()), thrown);
  EXPECT_IN(warnings(0.5, "", "\nfix m all rigid single"), thrown);
  EXPECT_IN(warnings(2.6, "average no", "\nfix m all rigid single"), thrown);
  for (const auto &text :
       {warnings(0.5, "", integrator()), warnings(2.6, "", "\nfix m all rigid single"),
        warnings(0.5, "", "\nfix m all move linear 0 0 0"),
        warnings(0.5, "coupling explicit", integrator() + frozen())})
    EXPECT_EQ(text.find(thrown), std::string::npos);
  start();
  EXPECT_IN(error_of(in_duct(false) + ball_of(0.01, {9.1, 4.3, 8.8}) + integrator() +
                     "\nfix push all addforce 0 " + num(newton()) + " 0" +
                     fluid(duct() + "coupling explicit check 1") + run(400)),
            "stopped at step");
}

TEST_F(Light, FrozenOnesAreWalls)
{
  const auto drag = [&](const std::string &coupling) {
    start();
    script(box({14, 15, 13}) + ball_of(0.01, {6.3, 5.1, 6.9}) + integrator() +
           fluid("accel 0 1e-2 0 average no coupling " + coupling) + frozen() + run(200));
    return force(1)[1];
  };
  EXPECT_EQ(drag("implicit"), drag("explicit"));
}

// a grain that becomes light between two parts of a run, their number being the same: it is coupled
// implicitly, and ends as one that was light from the start
TEST_F(Light, GrainThatBecomesLightInARun)
{
  const double ratio = 0.02;
  double end[2];
  for (const bool from_start : {true, false}) {
    start();
    const std::string scene = in_duct(false);
    script(scene + ball_of(from_start ? ratio : 5.0, {9.1, 4.3, 8.8}) + integrator() +
           "\nfix push all addforce 0 " + num(newton()) + " 0" + fluid(duct()) + run(1));
    EXPECT_EQ(lmp->modify->get_fix_by_id("w_LIGHT") != nullptr, from_start);
    script("set atom 1 density " + num(ratio * RHO) + "\nrun " + std::to_string(long_enough()) +
           " pre no post no");
    EXPECT_NE(lmp->modify->get_fix_by_id("w_LIGHT"), nullptr);
    end[from_start] = speed();
  }
  EXPECT_NEAR(end[0], end[1], 0.01 * end[1]);
}
