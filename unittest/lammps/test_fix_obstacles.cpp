/* ----------------------------------------------------------------------
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

// Regions as solids: what they give to the fluid and get from it, and what is refused.

#include "fluid_scenes.h"

class Obstacles : public FluidTest {
 protected:
  static std::string ball(const std::string &name, const Triple &c, double r)
  {
    return "\nregion " + name + " sphere " + at(c) + " " + num(r * DX);
  }
  static std::string block(const std::string &name, const Triple &lo, const Triple &hi)
  {
    std::string text = "\nregion " + name + " block";
    for (int d = 0; d < 3; d++) text += " " + num(lo[d] * DX) + " " + num(hi[d] * DX);
    return text;
  }
  std::string refusal(const std::string &regions, const std::string &options,
                      const Cells &cells = {12, 12, 12})
  {
    start();
    return error_of(box(cells) + regions + fluid(options) + run(0));
  }
  // force and torque on obstacle k = 1, 2, ...
  Triple push(int k) const { return {out(25 + 6 * k), out(26 + 6 * k), out(27 + 6 * k)}; }
  Triple turn(int k) const { return {out(28 + 6 * k), out(29 + 6 * k), out(30 + 6 * k)}; }
};

static double size(const Triple &a)
{
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

// what LAMMPS and we take for a ball is the same ball: force, torque and flow of a frozen grain
TEST_F(Obstacles, BallIsAFrozenGrain)
{
  for (const std::string rule : {"cli", "bouzidi", "halfway"})
    for (const std::string more : {"", " average no conserve no", " precision single"}) {
      const Triple c{6.13, 5.77, 6.41};
      const double r = 3.6;
      const std::string drive = "accel 2e-3 -1e-3 5e-4 link " + rule + more;
      start();
      script(box({12, 13, 12}) + grain(1, c, r) + fluid(drive) + frozen() + run(41));
      const Triple F = force(1), T{load(1)[3], load(1)[4], load(1)[5]};
      const auto flow = state();
      const double links = out(13), m = mass();
      start();
      script(box({12, 13, 12}) + ball("stone", c, r) + fluid(drive + " obstacle stone") + run(41));
      EXPECT_EQ(out(13), links);
      // single precision rounds what is stored, differently for sums in another order
      const double tolerance = more == " precision single" ? 1e-5 : 1e-10;
      EXPECT_NEAR(mass(), m, 1e-3 * tolerance * m);
      for (int d = 0; d < 3; d++) {
        EXPECT_NEAR(push(1)[d], F[d], tolerance * size(F)) << rule << more;
        EXPECT_NEAR(turn(1)[d], T[d], tolerance * (size(T) + r * DX * size(F)));
      }
      const auto ours = state();
      ASSERT_EQ(ours.size(), flow.size());
      for (std::size_t k = 0; k < flow.size(); k++)
        EXPECT_NEAR(ours[k], flow[k], tolerance * (k < flow.size() / 5 ? RHO : 1e-3));
    }
}

// any region: a block less a hole in it, joined with a ball; nodes are those inside
TEST_F(Obstacles, RegionsOfAllKinds)
{
  script(box({16, 14, 15}) + block("brick", {2, 2, 2}, {10, 9, 10}) + "\nregion hole cylinder z " +
         num(6.1 * DX) + " " + num(5.4 * DX) + " " + num(2.1 * DX) +
         " INF INF side out\nregion ring intersect 2 brick hole" +
         ball("ball", {11.3, 9.2, 8.7}, 4.1) + "\nregion all union 2 ring ball" +
         fluid("obstacle all") + run(0));
  int solid = 0;
  const auto found = values("solid");
  for_each_node([&](const Cells &p) {
    const double x = p[0] + 0.5, y = p[1] + 0.5, z = p[2] + 0.5;
    const bool brick = x > 2 && x < 10 && y > 2 && y < 9 && z > 2 && z < 10;
    const bool hole = std::hypot(x - 6.1, y - 5.4) < 2.1;
    const bool ball = std::hypot(x - 11.3, y - 9.2, z - 8.7) < 4.1;
    const bool inside = (brick && !hole) || ball;
    EXPECT_EQ(found[place(p)], inside) << x << " " << y << " " << z;
    solid += inside;
  });
  EXPECT_GT(solid, 400);
  EXPECT_EQ(out(12), all_nodes() - solid);
  EXPECT_NEAR(mass(), RHO * DX * DX * DX * (all_nodes() - solid), 1e-20);
}

// steady: all that drives the fluid arrives at the obstacles; each has its own share
TEST_F(Obstacles, TakeWhatDrivesTheFluid)
{
  const double a = 1e-3;
  script(box({14, 12, 12}) + ball("one", {4.2, 6.1, 5.7}, 2.9) +
         ball("two", {10.7, 5.8, 6.6}, 2.3) + grain(1, {7.4, 0.3, 11.8}, 2.4) +
         fluid("accel " + num(a) + " 0 0 obstacle one obstacle two") + frozen() + run(3000));
  const double all = a * RHO * DX * DX * DX * out(12);
  EXPECT_NEAR((push(1)[0] + push(2)[0] + force(1)[0]) / all, 1.0, 1e-6);
  EXPECT_GT(push(1)[0], push(2)[0]);
  EXPECT_GT(push(2)[0], 0.1 * all);
  EXPECT_NEAR(out(6), force(1)[0], 1e-12 * all);
}

// Torque on a cylinder that turns in another: 4 pi mu w R1^2 R2^2/(R2^2 - R1^2) per unit of depth
TEST_F(Obstacles, CylinderThatTurnsInAnother)
{
  const double in = 6.3, outer = 15.4, w = 0.2;
  const std::string middle = num(17.1 * DX) + " " + num(16.8 * DX);
  script(box({34, 34, 1}) + "\nregion shaft cylinder z " + middle + " " + num(in * DX) +
         " INF INF\nregion bush cylinder z " + middle + " " + num(outer * DX) +
         " INF INF side out" +
         fluid("obstacle shaft omega 0 0 " + num(w) + " about " + middle +
               " 0 obstacle bush about " + middle + " 0") +
         run(4000));
  const double R1 = in * DX, R2 = outer * DX;
  const double T = 4.0 * PI_ * RHO * NU * w * R1 * R1 * R2 * R2 / (R2 * R2 - R1 * R1);
  EXPECT_NEAR(turn(1)[2] / T, -1.0, 0.01);
  EXPECT_NEAR(turn(2)[2] / turn(1)[2], -1.0, 1e-3);
  EXPECT_LT(size(push(1)), 0.01 * T / R1);    // 0 but for its place on the lattice
  // and the speed is that of the surface there
  EXPECT_NEAR(out(3) * SOUND / (w * R1), 1.0, 0.02);
}

// a grain that falls on an obstacle: contacts of LAMMPS with the room left, water around both
TEST_F(Obstacles, GrainFallsOnOne)
{
  script(box({16, 16, 24}, "p p f") + ball("stone", {8, 8, 4}, 5.0) + "\nregion room sphere " +
         at({8, 8, 4}) + " " + num(5.0 * DX) + " side out" + grain(1, {8.2, 8.1, 13.6}, 3.0) +
         "\ntimestep " + num(DT / 50) +
         "\nfix m all nve/sphere\nfix g all gravity 0.2 vector 0 0 -1"
         "\nfix c all wall/gran/region hooke 1.0 NULL 1e-5 NULL 0.5 0 region room" +
         fluid("every 50 buoyancy 0 0 -0.2 obstacle stone face zlo wall face zhi wall") +
         run(20000));
  const double away = std::hypot(x(1)[0] / DX - 8, x(1)[1] / DX - 8, x(1)[2] / DX - 4);
  EXPECT_GT(away, 7.8);
  EXPECT_LT(x(1)[2] / DX, 12.3);
  EXPECT_LT(size({v(1)[0], v(1)[1], v(1)[2]}), 0.02);
  EXPECT_LT(out(3), 0.1);
}

/* ---- what is refused ---- */

TEST_F(Obstacles, WordsOfTheLine)
{
  const std::string stone = ball("stone", {6, 6, 6}, 3.1);
  EXPECT_IN(refusal(stone, "obstacle"), "region of an obstacle");
  EXPECT_IN(refusal(stone, "obstacle pebble"), "region pebble does not exist: define it before");
  EXPECT_IN(refusal(stone, "obstacle stone obstacle stone"), "'obstacle stone' is given twice");
  EXPECT_IN(refusal(stone, "obstacle stone velocity 0 0"), "stone velocity");
  EXPECT_IN(refusal(stone, "obstacle stone velocity 0 0 v_u"), "Expected floating point");
  EXPECT_IN(refusal(stone, "obstacle stone omega 0 0 nan about 0 0 0"), "parameter instead of 'nan'");
  EXPECT_IN(refusal(stone, "obstacle stone omega 0 0 1"), "omega needs a point of its axis: about");
  EXPECT_IN(refusal(stone, "obstacle stone about 0 0 0 about 0 0 0"), "'about' is given twice");
  EXPECT_IN(refusal(stone, "obstacle stone fast 0 0 1"), "unknown keyword 'fast'");
  EXPECT_IN(refusal("\nregion r cylinder z 6e-4 6e-4 3e-4 INF INF", "obstacle r velocity 0 0 1e-3",
                    {12, 12, 1}),
            "with dimension 2 the z component");
  EXPECT_EQ(refusal(stone, "obstacle stone omega 0 0 1 about 6e-4 6e-4 6e-4"), "");
  EXPECT_EQ(refusal(stone, "obstacle stone"), "");
}

TEST_F(Obstacles, RegionsThatAreNoObstacle)
{
  const std::string sphere = "\nregion stone sphere " + at({6, 6, 6}) + " ";
  const std::string move = "\nvariable v equal 1e-4";
  EXPECT_IN(refusal(move + sphere + "3e-4 move v_v NULL NULL", "obstacle stone"),
            "region stone moves, turns or changes its shape");
  EXPECT_IN(refusal(move + sphere + "v_v", "obstacle stone"), "changes its shape");
  EXPECT_IN(refusal(move + sphere +
                        "3e-4 rotate v_v 0 0 0 0 0 1\nregion b sphere 0 0 0 2e-4"
                        "\nregion u union 2 stone b",
                    "obstacle u"),
            "region u moves, turns");
  EXPECT_IN(refusal("\nregion can cylinder z 6e-4 6e-4 3e-4 2e-4 9e-4 open 2", "obstacle can"),
            "region can has open faces");
  EXPECT_IN(refusal(ball("far", {60, 6, 6}, 3.1), "obstacle far"),
            "covers no node of the lattice:");
  EXPECT_IN(refusal(block("foil", {5.6, -99, -99}, {6.4, 99, 99}), "obstacle foil"),
            "covers no node of the lattice, as it is thinner than dx");
  EXPECT_IN(refusal(sphere + "3e-3", "obstacle stone"), "leaves none to the fluid");
  EXPECT_IN(refusal(sphere + "3e-4", "obstacle stone velocity 1e-3 0 0"),
            "the motion of region stone would take its surface elsewhere");
  EXPECT_IN(refusal(sphere + "3e-4", "obstacle stone omega 0 0 200 about 6e-4 6e-4 6e-4"),
            "prescribed at the surface of an obstacle is Ma");
}

TEST_F(Obstacles, ThinPartsAreWarnedOf)
{
  script(box({12, 12, 12}) + block("plate", {5, -99, -99}, {6.9, 99, 99}) +
         fluid("obstacle plate"));
  EXPECT_IN(log_of("run 0"), "lie in parts thinner than 2 dx = 0.0002");
  start();
  script(box({12, 12, 12}) + block("plate", {5, -99, -99}, {7.2, 99, 99}) +
         block("foil", {2.6, -99, -99}, {3.4, 99, 99}) + "\nregion both union 2 plate foil" +
         fluid("obstacle both"));
  const std::string log = log_of("run 0");
  EXPECT_IN(log, "the fluid passes through parts of region both");
  EXPECT_NOT_IN(log, "lie in parts thinner");
  EXPECT_IN(log, "obstacle both: 288 solid nodes");
  EXPECT_IN(log, "f_w[31] to [36]");
}

TEST_F(Obstacles, RegionMustStayAsItIs)
{
  const std::string stone = ball("stone", {6, 6, 6}, 3.1);
  script(box({12, 12, 12}) + stone + fluid("obstacle stone accel 1e-3 0 0") + run(5) + run(5));
  EXPECT_ERROR("region stone delete" + ball("stone", {6, 6, 6}, 3.3) + run(5),
               "region stone has changed since the fluid was made");
  start();
  script(box({12, 12, 12}) + stone + fluid("obstacle stone accel 1e-3 0 0") + run(5));
  EXPECT_ERROR("region stone delete" + run(5), "region stone does not exist");
}

TEST_F(Obstacles, RestartKnowsThem)
{
  const std::string stone = ball("stone", {6, 6, 6}, 3.1);
  script(box({12, 12, 12}) + stone + fluid("obstacle stone accel 1e-3 0 0") + run(7) +
         "\nwrite_restart solid");
  const Triple F = push(1);
  EXPECT_GT(size(F), 0.0);
  const auto again = [&](const std::string &regions, const std::string &options) {
    start();
    return error_of("read_restart solid\nneighbor 1e-4 bin" + regions +
                    fluid(options + " accel 1e-3 0 0 restart solid") + run(0));
  };
  EXPECT_EQ(again(stone, "obstacle stone"), "");
  EXPECT_EQ(push(1), F);
  EXPECT_IN(again("", ""), "the number of obstacles was 1 when the restart file was written");
  EXPECT_IN(again(ball("stone", {6, 6, 6}, 3.2), "obstacle stone"),
            "region stone is not what it was when the restart file was written");
  for (const char *name : {"solid", "solid.lbibb"}) std::remove(name);
}
