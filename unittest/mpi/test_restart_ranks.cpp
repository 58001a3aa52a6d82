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

// A run that goes on from restart files is the run that went on without: bit for bit on the same
// ranks, to round-off on others.

#include "fluid_ranks.h"

#include <functional>

class RestartRanks : public FluidRanks {
 protected:
  // a box with its grains, and what has to be said again after read_restart; steps before and after
  struct Scene {
    Cells nodes;
    std::string boundary, grains, commands, options;
    int before, after;
  };

  void TearDown() override
  {
    lmp.reset();
    MPI_Barrier(MPI_COMM_WORLD);
  }

  void begin(const Scene &s, const std::string &cut)
  {
    script(box(s.nodes, s.boundary, cut) + s.grains + s.commands + fluid(s.options) + later(s));
  }
  void go_on(const Scene &s, const std::string &cut, const std::string &file)
  {
    n = s.nodes;
    script(cut + "\nread_restart " + file + "\nneighbor 1e-4 bin\nthermo_modify lost error" +
           s.commands + fluid(s.options + " restart " + file) + later(s));
  }
  // fixes that must come after the fluid
  static std::string later(const Scene &s)
  {
    return s.grains.find("ice") != std::string::npos ? ""
        : s.nodes[2] == 1                            ? "\nfix flat all enforce2d"
                                                     : "";
  }

  static std::string bytes(const std::string &name)
  {
    std::ifstream file(name, std::ios::binary);
    std::stringstream all;
    all << file.rdbuf();
    return all.str();
  }

  void expect_same_bits(const Scene &s)
  {
    for (const std::string &brick : bricks()) {
      if (s.nodes[2] == 1 && brick.substr(brick.size() - 2) != " 1") continue;
      SCOPED_TRACE(brick);
      const std::string cut = "processors " + brick;
      start(MPI_COMM_WORLD);
      begin(s, cut);
      script(run(s.before) + "\nwrite_restart half" + run(s.after) + "\nwrite_restart through");
      const auto through = result();
      start(MPI_COMM_WORLD);
      go_on(s, cut, "half");
      script(run(s.after) + "\nwrite_restart split");
      EXPECT_EQ(result(), through);
      const std::string fluid = bytes("split.lbibb");
      EXPECT_GT(fluid.size(), 1000u);
      EXPECT_TRUE(fluid == bytes("through.lbibb")) << "the fluid differs";
      EXPECT_FALSE(fluid == bytes("half.lbibb")) << "nothing has happened";
      MPI_Barrier(MPI_COMM_WORLD);
    }
  }

  // from a file that was written in passing
  void expect_same_from_passing(const Scene &s)
  {
    start(MPI_COMM_WORLD);
    begin(s, "");
    script("restart " + std::to_string(s.before) + " passing.*" + run(s.before + s.after));
    const auto through = result();
    start(MPI_COMM_WORLD);
    go_on(s, "", "passing." + std::to_string(s.before));
    script("restart " + std::to_string(s.before) + " passing.*" + run(s.after));
    EXPECT_EQ(result(), through);
  }

  // written by so many ranks, read by so many
  void expect_same_on(const Scene &s, const std::vector<std::array<int, 2>> &ranks)
  {
    int me, nprocs;
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    MPI_Comm_size(MPI_COMM_WORLD, &nprocs);
    start(MPI_COMM_SELF);
    begin(s, "");
    script(run(s.before) + "\nwrite_restart own" + std::to_string(me) + run(s.after));
    const auto alone = result();
    // on the first ranks; the others wait
    auto on = [&](int count, const std::function<void()> &what) {
      lmp.reset();
      MPI_Comm some;
      MPI_Comm_split(MPI_COMM_WORLD, me < count, me, &some);
      if (me < count) {
        start(some);
        what();
      }
      lmp.reset();
      MPI_Comm_free(&some);
      MPI_Barrier(MPI_COMM_WORLD);
    };
    for (const auto &[writers, readers] : ranks) {
      if (writers > nprocs || readers > nprocs) continue;
      SCOPED_TRACE(std::to_string(writers) + " -> " + std::to_string(readers));
      on(writers, [&]() {
        begin(s, "");
        script(run(s.before) + "\nwrite_restart half");
      });
      on(readers, [&]() {
        go_on(s, "", "half");
        script(run(s.after));
        expect_same(alone);
      });
    }
  }

  void compare_restarts(const Scene &s)
  {
    expect_same_bits(s);
    expect_same_on(s, {{1, 2}, {2, 1}, {1, 4}, {4, 3}, {3, 4}, {4, 1}});
  }
};

// with averages, refunds and contacts; stopped between two fluid steps
TEST_F(RestartRanks, GrainsThatCollide)
{
  compare_restarts({{18, 12, 12},
                    "p p f",
                    heap({3, 2, 2}, 4e-3) + "\ntimestep " + num(DT / 20),
                    "\npair_style gran/lsd/coulomb\npair_coeff * * 0.05 0.8 0.4"
                    "\nfix floor all wall/gran/lsd/coulomb 0.05 0.8 0.4 zplane 0 1.2e-3"
                    "\nfix m all nve/sphere\nfix g all gravity 1 vector 0 0 -1"
                    "\nneigh_modify delay 0 every 1 check yes",
                    "every 20 buoyancy 0 0 -1 gradp 0.1 0 0 face zlo wall face zhi pressure 0",
                    507,
                    593});
}

TEST_F(RestartRanks, RampsAtFaces)
{
  compare_restarts({{18, 12, 14},
                    "f p f",
                    heap({3, 2, 2}, 0.0),
                    "\nvariable p equal 1e-3*step\nvariable g equal 1e-2*sin(step/9)",
                    "face xlo wall 0 1e-3 0 face xhi wall face zlo pressure v_p face zhi velocity "
                    "0 0 5e-4 buoyancy v_g 0 0 accel 0 v_g 0",
                    31,
                    40});
}

// kept links: nothing moves before or after
TEST_F(RestartRanks, FixedGrains)
{
  compare_restarts({{18, 12, 12},
                    "p p p",
                    heap({3, 2, 2}, 0.0),
                    "",
                    "accel 2e-3 -1e-3 5e-4 gradp 0.1 0 0",
                    30,
                    30});
}

// nodes are uncovered in the very next step
TEST_F(RestartRanks, RulesOfTheArticle)
{
  compare_restarts({{16, 14, 15},
                    "p p p",
                    grain(1, {12.3, 3.1, 11.2}, 4.3) + grain(2, {5.1, 10.2, 3.4}, 3.6) +
                        "\ntimestep " + num(DT / 4),
                    "\nfix m all move linear 4e-3 -4e-3 1e-3",
                    "every 4 link bouzidi refill equilibrium collision bgk average no conserve no",
                    82,
                    201});
}

// the first half step is made with the forces of the step before
TEST_F(RestartRanks, BuoyancyThatVaries)
{
  compare_restarts({{12, 12, 12},
                    "p p p",
                    grain(1, {2.3, 6.1, 9.2}, 4.1, {2e-3, 0, 1e-3}),
                    "\nvariable g equal 1e-2*sin(step/3)\nfix m all nve/sphere",
                    "buoyancy v_g 0 v_g",
                    31,
                    40});
}

// stopped between two fluid steps: the fluid has still to hear of the way since
TEST_F(RestartRanks, LightGrains)
{
  compare_restarts({{16, 14, 15},
                    "p p f",
                    grain(1, {12.3, 3.1, 8.2}, 3.3, {4e-3, -4e-3, 1e-3}) +
                        grain(2, {5.1, 10.2, 6.4}, 3.6, {-3e-3, 1e-3, 0}) +
                        "\nset atom 1 density 20\nset atom 2 density 2600\ntimestep " + num(DT / 4),
                    "\nfix m all nve/sphere",
                    "every 4 accel 1e-3 0 0 face zlo wall face zhi wall",
                    42,
                    100});
}

// free in a box without walls: the force that keeps the momentum goes on as well
TEST_F(RestartRanks, MomentumIsKept)
{
  Scene s{{16, 14, 15},
          "p p p",
          grain(1, {12.3, 3.1, 8.2}, 3.3, {4e-3, -4e-3, 1e-3}) +
              grain(2, {5.1, 10.2, 6.4}, 3.6, {-3e-3, 1e-3, 0}) +
              "\nset atom 1 density 20\nset atom 2 density 2600\ntimestep " + num(DT / 4),
          "\nfix m all nve/sphere",
          "every 4 accel 1e-3 0 0 check 7",
          102,
          200};
  compare_restarts(s);
  s.before = 4 * 28;    // where a new force has just been found
  compare_restarts(s);
}

TEST_F(RestartRanks, SinglePrecision)
{
  Scene s{{16, 14, 15},
          "p p f",
          grain(1, {12.3, 3.1, 8.2}, 3.3, {4e-3, -4e-3, 1e-3}) +
              grain(2, {5.1, 10.2, 6.4}, 4.6, {-3e-3, 1e-3, 0}),
          "\nfix m all nve/sphere",
          "precision single accel 1e-3 0 0 face zlo wall face zhi wall",
          7,
          60};
  expect_same_bits(s);
}

TEST_F(RestartRanks, Discs)
{
  std::string text;
  int id = 0;
  for (int j = 0; j < 3; j++)
    for (int i = 0; i < 3; i++)
      text += disc(++id, {6.0 * i + 3.1 + 0.3 * j, 6.0 * j + 5.2, 0}, 2.6 + 0.1 * i,
                   {4e-3 * (1 - i), 3e-3 * (j - 1), 0});
  compare_restarts({{18, 24, 1},
                    "p f p",
                    text + "\ntimestep " + num(DT / 20),
                    "\npair_style gran/lsd/coulomb\npair_coeff * * 500 0.8 0.4"
                    "\nfix floor all wall/gran/lsd/coulomb 500 0.8 0.4 yplane 2e-4 2.2e-3"
                    "\nfix m all nve/sphere disc\nfix g all gravity 1 vector 0 -1 0"
                    "\nneigh_modify delay 0 every 1 check yes",
                    "every 20 buoyancy 0 -1 0 gradp 0.1 0 0 face ylo velocity 0 1e-4 0 face yhi "
                    "pressure 0",
                    610,
                    990});
}

// between grains and at walls, one of which moves; read from the file of LAMMPS alone
TEST_F(RestartRanks, Films)
{
  compare_restarts({{18, 12, 12},
                    "p p f",
                    grain(1, {5.1, 6.2, 3.2}, 3.0, {4e-3, 0, -1e-3}) +
                        grain(2, {11.25, 6.0, 3.3}, 3.1, {-4e-3, 1e-3, 0}) + "\ntimestep " +
                        num(DT / 20) + "\npair_style lubricate/lb/ibb 1e-6 normal 0.7 shear 0.6" +
                        "\npair_coeff * *",
                    "\nfix m all nve/sphere",
                    "every 20 buoyancy 0 0 -1 face zlo wall 1e-3 0 0 face zhi wall",
                    610,
                    990});
}

// with what an obstacle swallowed and got, kept links or not
TEST_F(RestartRanks, Obstacles)
{
  const std::string regions = "\nregion ball sphere " + at({9.1, 8.2, 5.4}) + " " + num(3.7 * DX) +
      "\nregion floor block INF INF INF INF INF " + num(1.3 * DX);
  const std::string drive =
      "accel 1e-3 0 0 face zlo wall face zhi wall obstacle floor obstacle ball";
  compare_restarts({{16, 14, 19}, "p p f", "", regions, drive, 21, 30});
  compare_restarts({{16, 14, 19},
                    "p p f",
                    grain(1, {8.3, 8.1, 12.2}, 3.3, {4e-3, -4e-3, -1e-3}),
                    regions + "\nfix m all nve/sphere",
                    drive + " omega 0 0 20 about " + at({9.1, 8.2, 5.4}),
                    21,
                    30});
}

TEST_F(RestartRanks, NoGrains)
{
  compare_restarts({{9, 7, 8},
                    "p p f",
                    "",
                    "",
                    "face zlo velocity 1e-4 0 1e-3 face zhi pressure 0 accel 1e-3 0 0",
                    25,
                    26});
}

// before the end of the first fluid step: the fluid has not moved, but time has
TEST_F(RestartRanks, WithinTheFirstStep)
{
  compare_restarts({{12, 12, 12},
                    "p p p",
                    grain(1, {2.3, 6.1, 9.2}, 5.1, {2e-3, 0, 1e-3}) + "\ntimestep " + num(DT / 10),
                    "\nfix m all nve/sphere",
                    "every 10 accel 1e-3 0 0",
                    7,
                    200});
}

// larger than a sub-domain, over a corner of the periodic box, prescribed
TEST_F(RestartRanks, LargeGrainInPrescribedMotion)
{
  compare_restarts({{12, 12, 12},
                    "p p p",
                    grain(1, {0.3, 11.9, 9.2}, 5.1),
                    "\nfix m all move linear 4e-3 3.9e-3 -4.1e-3",
                    "accel 1e-3 0 0",
                    50,
                    50});
}

// Enclosed fluid whose density is kept, other nodes of it than when it was last found
TEST_F(RestartRanks, EnclosedFluidThatMoves)
{
  const std::string motion = "\nfix m all move linear 2e-3 1.9e-3 ",
                    options = "accel 1e-3 0 0 check 1000";
  std::string ring, cage;
  for (int k = 0; k < 8; k++)
    ring += disc(k + 1, {12.1 + 6.2 * std::cos(k * PI_ / 4), 12.3 + 6.2 * std::sin(k * PI_ / 4), 0},
                 4.0);
  int id = 0;
  for (int k = 0; k < 27; k++)
    if (k != 13)
      cage += grain(++id, {7.1 + 5.0 * (k % 3), 7.3 + 5.0 * (k / 3 % 3), 7.2 + 5.0 * (k / 9)}, 3.9);
  for (const Scene &s : {Scene{{24, 24, 1}, "p p p", ring, motion + "0", options, 33, 48},
                         Scene{{24, 22, 23}, "p p p", cage, motion + "-2e-3", options, 33, 48}}) {
    compare_restarts(s);
    expect_same_from_passing(s);
    EXPECT_GE(out(29), 1.0);    // enclosed sets
    EXPECT_GT(out(30), 5.0);    // nodes of them
  }
}

// the cut may change before the fluid is there
TEST_F(RestartRanks, BalancedBeforeGoingOn)
{
  const Scene s{{16, 14, 15},
                "p p p",
                grain(1, {12.3, 3.1, 11.2}, 3.3) + grain(2, {9.1, 10.2, 9.4}, 2.6),
                "\nfix m all move linear 4e-3 -4e-3 1e-3",
                "accel 1e-3 0 0",
                21,
                30};
  const std::string own = "own" + std::to_string(lmp->comm->me);
  start(MPI_COMM_SELF);
  begin(s, "");
  script(run(s.before) + "\nwrite_restart " + own + run(s.after));
  const auto alone = result();
  start();
  begin(s, "");
  script(run(s.before) + "\nwrite_restart half");
  start();
  go_on(s, "", "half");
  script("balance 1.0 shift xyz 10 1.0" + run(s.after));
  expect_same(alone);
}

// a single population is damaged, which one rank reads; the end is missing
TEST_F(RestartRanks, RefusedAlikeOnAllRanks)
{
  Scene s{{12, 12, 12}, "p p p", grain(1, {2.3, 6.1, 9.2}, 4.1), "", "accel 1e-3 0 0", 5, 0};
  begin(s, "");
  script(run(s.before) + "\nwrite_restart half");
  std::string whole = bytes("half.lbibb");
  for (const bool damage : {true, false}) {
    std::string bad = whole;
    if (damage)
      bad[bad.size() / 3] = char(bad[bad.size() / 3] ^ 16);
    else
      bad.resize(bad.size() - 9);
    MPI_Barrier(MPI_COMM_WORLD);
    if (lmp->comm->me == 0) std::ofstream("half.lbibb", std::ios::binary) << bad;
    MPI_Barrier(MPI_COMM_WORLD);
    start();
    std::string message;
    try {
      go_on(s, "", "half");
      script(run(0));
    } catch (LAMMPS_NS::LAMMPSException &except) {
      message = except.what();
    }
    EXPECT_IN(message, damage ? "it is damaged: its checksum is wrong" : "it is truncated");
    EXPECT_NOT_IN(message, "on proc");
    char first[2000];
    snprintf(first, sizeof(first), "%s", message.c_str());
    MPI_Bcast(first, sizeof(first), MPI_CHAR, 0, MPI_COMM_WORLD);
    EXPECT_EQ(message, std::string(first));
  }
}
