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

// What fix lb/ibb refuses and warns of before the first step: the value, the limit and the remedy.

#include "fluid_scenes.h"

class Refusals : public FluidTest {
 protected:
  // the message that a scene of 8 cells a side, or the given one, ends with
  std::string refusal(const std::string &options, const std::string &boundary = "p p p",
                      const Cells &cells = {8, 8, 8})
  {
    start();
    return error_of(box(cells, boundary) + fluid(options) + run(0));
  }
  static std::string line(const std::string &words) { return "\nfix w all lb/ibb " + words; }
  std::string refused_line(const std::string &words)
  {
    start();
    return error_of(box({8, 8, 8}) + line(words) + run(0));
  }
};

TEST_F(Refusals, WordsOfTheLine)
{
  EXPECT_IN(refused_line("dx 1e-4 nu 1e-6"), "missing");
  EXPECT_IN(refused_line("nu 1e-6 dx 1e-4 rho 1000"), "expected 'dx', not 'nu'");
  EXPECT_IN(refused_line("dx 1e-4 nu 1e-6 rho water"),
            "Expected floating point parameter instead of 'water'");
  EXPECT_IN(refused_line("dx 0 nu 1e-6 rho 1000"), "dx = 0 must be larger than 0");
  EXPECT_IN(refused_line("dx 1e-4 nu -1e-6 rho 1000"), "nu = -1e-06 must be larger than 0");
  EXPECT_IN(refused_line("dx 1e-4 nu 1e-6 rho 0"), "rho = 0 must be larger than 0");
  EXPECT_IN(refusal("evry 2"), "unknown keyword 'evry'; known are every, collision");
  EXPECT_IN(refusal("every 2 every 3"), "'every' is given twice: remove one");
  EXPECT_IN(refusal("every 0"), "every: 0 must be at least 1");
  EXPECT_IN(refusal("every -2"), "every: -2 must be at least 1");
  EXPECT_IN(refusal("every 1.5"), "Expected integer parameter instead of '1.5'");
  EXPECT_IN(refusal("every"), "fluid step interval");
  EXPECT_IN(refusal("check 0"), "check: 0 must be at least 1");
  EXPECT_IN(refusal("collision mrt"), "'mrt' is none of trt, bgk, regularised");
  EXPECT_IN(refusal("collision trt 0"), "trt Lambda = 0 must be larger than 0");
  EXPECT_IN(refusal("collision trt -0.2"), "trt Lambda = -0.2 must be larger than 0");
  EXPECT_IN(refusal("collision bgk 0.2"), "unknown keyword '0.2'");
  EXPECT_IN(refusal("link linear"), "'linear' is none of cli, zhao, bouzidi, halfway");
  EXPECT_IN(refusal("precision half"), "'half' is neither double nor single");
  EXPECT_IN(refusal("refill none"), "'none' is none of grad, normal, local, equilibrium");
  EXPECT_IN(refusal("average maybe"), "Expected boolean parameter instead of 'maybe'");
  EXPECT_IN(refusal("conserve maybe"), "Expected boolean parameter instead of 'maybe'");
  EXPECT_IN(refusal("shrink -1e-5"), "shrink: -1e-05 must not be negative");
  EXPECT_IN(refusal("accel 1 2"), "accel");
  EXPECT_IN(refusal("gradp 1 2 up"), "Expected floating point parameter instead of 'up'");
  EXPECT_IN(refusal("buoyancy 0 0 v_g"), "variable g does not exist: define it before the run");
  // all that the contract names is taken
  EXPECT_EQ(
      refusal(
          "every 2 collision trt 0.25 link bouzidi refill equilibrium accel 0 0 1e-3 gradp "
          "0 0 1 buoyancy 0 0 -9.81 shrink 1e-5 average no conserve no check 50 precision single"),
      "");
  EXPECT_EQ(refusal("collision bgk link halfway refill grad average yes precision double"), "");
}

TEST_F(Refusals, VariablesOfTheWrongStyle)
{
  const std::string wrong = "\nvariable a atom x" + fluid("accel v_a 0 0") + run(0);
  EXPECT_ERROR(box({8, 8, 8}) + wrong, "variable a is not of style equal: define it as such");
  start();
  EXPECT_ERROR(box({8, 8, 8}, "p p f") + "\nvariable p string 5" +
                   fluid("face zlo wall face zhi pressure v_p") + run(0),
               "variable p is not of style equal");
  start();
  EXPECT_ERROR(box({8, 8, 8}) + "\nvariable a equal exp(500*step)" + fluid("accel 0 v_a 0") +
                   run(3),
               "Fix lb/ibb: variable a is inf at step 2");
}

TEST_F(Refusals, Faces)
{
  EXPECT_IN(refusal("", "p p f"), "face zlo is missing: every face of a non-periodic direction");
  EXPECT_IN(refusal("face zlo wall", "p p f"), "face zhi is missing");
  EXPECT_IN(refusal("face xlo wall"), "xlo is on a periodic direction: make it non-periodic");
  EXPECT_IN(refusal("face top wall", "p p f"), "'top' is none of xlo, xhi, ylo, yhi, zlo, zhi");
  EXPECT_IN(refusal("face zlo slip", "p p f"), "'slip' is none of wall, pressure, velocity");
  EXPECT_IN(refusal("face zlo wall face zlo wall face zhi wall", "p p f"),
            "'face zlo' is given twice");
  EXPECT_IN(refusal("face zlo wall 0 0 1e-3 face zhi wall", "p p f"),
            "zlo wall moves with 0.001 along z, through itself: this component must be the number "
            "0; fluid enters through a velocity face");
  EXPECT_IN(refusal("face zlo wall 0 0 v_u face zhi wall", "p p f"), "zlo wall moves with v_u");
  EXPECT_IN(refusal("face zlo wall 1 2 face zhi wall", "p p f"),
            "Expected floating point parameter");
  EXPECT_IN(refusal("face zlo pressure face zhi wall", "p p f"), "face");
  EXPECT_IN(
      refusal("face xlo pressure 0 face xhi wall face ylo wall face yhi velocity 0 1 0", "f f p"),
      "open faces xlo and yhi meet in an edge");
  EXPECT_IN(refusal("face xlo velocity 1e-3 0 0 face xhi velocity 2e-3 0 0", "f p p"),
            "faces xlo and xhi contradict each other: the fluid moves with 0.001 through one and "
            "0.002 through the other: make them equal, or one a pressure face");
  EXPECT_IN(refusal("face xlo velocity 1e-3 0 0 face xhi wall", "f p p"), "contradict each other");
  EXPECT_IN(refusal("face zlo velocity 0 0 1e-3 parabolic face zhi pressure 0", "p p f"),
            "face zlo is parabolic and lies between no two walls");
  EXPECT_IN(refusal("face xlo wall face xhi wall face zlo velocity 0 0 1e-3 parabolic face zhi "
                    "velocity 0 0 1e-3",
                    "f p f"),
            "of faces zlo and zhi one is parabolic and lets less through than the other: make both "
            "parabolic, or one a pressure face");
  EXPECT_EQ(refusal("face xlo wall face xhi wall face zlo velocity 0 0 1e-3 parabolic face zhi "
                    "velocity 0 0 1e-3 parabolic",
                    "f p f"),
            "");
  EXPECT_IN(refusal("face zlo wall face zhi wall", "p p p", {8, 8, 1}),
            "zlo has no meaning with dimension 2: remove it");
  EXPECT_IN(refusal("face xlo wall 0 1e-3 1e-3 face xhi wall", "f p p", {8, 8, 1}),
            "xlo: the z component of the velocity is 0.001, it must be 0 with dimension 2");
  for (const std::string drive : {"accel", "gradp", "buoyancy"})
    for (const std::string value : {"1", "v_a"})
      EXPECT_IN(refusal(drive + " 0 0 " + value, "p p p", {8, 8, 1}),
                drive + ": its z component is " + value + ", it must be 0 with dimension 2");
}

TEST_F(Refusals, CellsOfTheBox)
{
  EXPECT_IN(refused_line("dx 1.1e-4 nu 1e-6 rho 1000"),
            "dx = 0.00011 does not divide the box length 0.0008 along x (7.27273 cells): nearest "
            "that do are 0.0001 and 0.0001142857143");
  EXPECT_IN(refused_line("dx 4e-4 nu 1e-6 rho 1000"),
            "box length 0.0008 along x is 2 cells of dx = 0.0004: at least 3 are needed, dx <= "
            "0.000266667");
  EXPECT_IN(refused_line("dx 1 nu 1e-6 rho 1000"), "at least 3 are needed");
  EXPECT_IN(refused_line("dx 1e-7 nu 1e-6 rho 1000"),
            "lattice nodes on one rank, limit 2^31: use more ranks or a larger dx");
  start();
  EXPECT_IN(error_of("units si\nfix w all lb/ibb dx 1 nu 1 rho 1"), "box");
}

TEST_F(Refusals, RelaxationTime)
{
  const std::string scene = box({8, 8, 8}) + fluid() + "\ntimestep ";
  const std::string tau = "must be larger than 1/2, and 1/2 + 3 nu dt/dx^2 with nu = 1e-06";
  EXPECT_ERROR(scene + "0" + run(0), tau);
  start();
  EXPECT_ERROR(scene + "1e-25" + run(0), "enlarge timestep or every");
  start();
  EXPECT_IN(log_of(scene + "1e-5" + run(0)), "WARNING: Fix lb/ibb: relaxation time tau = 0.503 is");
  start();
  EXPECT_IN(log_of(scene + "1e-2" + run(0)),
            "tau = 3.5 is large: accuracy is lost above 3; reduce");
  start();    // three, but for the rounding of the step
  EXPECT_NOT_IN(log_of(scene + "8.3333333334e-3" + run(0)), "is large");
}

TEST_F(Refusals, PressureAndSpeedAtTheFaces)
{
  // p/(rho c_s^2) = 1 at 3.33 Pa; tau_max = .5 + nu/dx sqrt(3 eps rho/p)
  auto scene = [&](const std::string &p) {
    start();
    return box({8, 8, 8}, "p p f") + fluid("face zlo pressure " + p + " face zhi pressure 0") +
        run(0);
  };
  EXPECT_NOT_IN(log_of(scene("0.166")), "WARNING: Fix lb/ibb");
  EXPECT_IN(log_of(scene("0.168")),
            "WARNING: Fix lb/ibb: pressure difference 0.168 between faces "
            "changes the density by 5.04 %, limit 5 %");
  EXPECT_EQ(error_of(scene("0.666")), "");
  EXPECT_ERROR(scene("0.8"),
               "changes the density by 24 %, limit 20 %: the largest relaxation time "
               "allowed here is tau = 0.7739, a fluid time step of 0.0009129 (now "
               "tau = 0.8000, 0.001); reduce timestep or every");
  auto stream = [&](const std::string &u) {
    start();
    return box({8, 8, 8}, "p p f") + fluid("face zlo velocity 0 0 " + u + " face zhi pressure 0") +
        run(0);
  };
  EXPECT_IN(log_of(stream("6e-3")),
            "WARNING: Fix lb/ibb: speed 0.006 prescribed at a face is Ma = "
            "0.104 of the lattice's sound speed, limit 0.1: reduce");
  EXPECT_ERROR(stream("0.018"), "Ma = 0.312 of the lattice's sound speed, limit 0.3");
}

// half of the force of a step is in the velocity put out: 0.0173 m/s is the limit
TEST_F(Refusals, DriveThatIsTooStrong)
{
  EXPECT_EQ(refusal("accel 34 0 0"), "");
  EXPECT_IN(
      refusal("accel 35 0 0"),
      "accel and gradp give the fluid a speed of 0.0175 within half a fluid step, Ma = 0.303");
  EXPECT_IN(refusal("gradp 0 0 35000"), "Ma = 0.303 of the lattice's sound speed, limit 0.3");
  EXPECT_IN(refusal("accel 0 1e308 0"), "limit 0.3: reduce them, or the fluid time step");
}

TEST_F(Refusals, Radii)
{
  auto scene = [&](double r, const std::string &options) {
    start();
    return box({12, 12, 12}) + grain(1, {6, 6, 6}, r) + fluid(options) + run(0);
  };
  EXPECT_NOT_IN(log_of(scene(3.5001, "")), "hydrodynamic radius");
  EXPECT_IN(log_of(scene(3.0, "")),
            "WARNING: Fix lb/ibb: smallest hydrodynamic radius 0.0003 is 3 "
            "cells, limit 3.5: use dx <= 8.571e-05");
  EXPECT_ERROR(scene(1.9, ""), "radius 0.00019 is 1.9 cells, limit 2: use dx <= 9.5e-05");
  EXPECT_ERROR(scene(3.0, "shrink 1.1e-4"), "is 1.9 cells, limit 2");
  EXPECT_ERROR(scene(3.0, "shrink 3.1e-4"), "must be larger than 0");
  start();
  EXPECT_ERROR(
      box({12, 12, 12}) + "\ncreate_atoms 1 single 6e-4 6e-4 6e-4" + fluid() + run(0),
      "the largest hydrodynamic radius, 0.5, is larger than the periodic box, 0.0012 along x");
  // a grain that comes later
  start();
  std::ofstream("small.mol") << "one grain\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\n"
                                "Diameters\n\n1 3e-4\n\nMasses\n\n1 3e-8\n";
  EXPECT_ERROR(box({8, 8, 8}) + "\nmolecule ball small.mol\nregion all block 0 8e-4 0 8e-4 0 8e-4" +
                   "\nfix drop all deposit 1 1 5 4711 region all mol ball" + fluid() + run(20),
               "has a hydrodynamic radius of 1.5 cells, limit 2: use dx <= 7.5e-05");
  std::remove("small.mol");
}

TEST_F(Refusals, Scenes)
{
  const std::string sphere = box({12, 12, 12}) + grain(1, {6, 6, 6}, 3.6);
  auto with = [&](const std::string &text) {
    start();
    return error_of(sphere + fluid() + "\n" + text + (text.find("run") == 0 ? "" : run(1)));
  };
  EXPECT_IN(with("run_style respa 2 2\nrun 1"), "cannot be used with run_style respa");
  EXPECT_IN(with("minimize 0 0 10 10"), "cannot be used with minimisation");
  EXPECT_IN(with("fix t all dt/reset 10 1e-6 1e-3 1e-5"), "cannot be used with fix dt/reset");
  EXPECT_IN(with("fix v all lb/ibb dx 1e-4 nu 1e-6 rho 1000"),
            "only one fluid can fill the box: unfix w or v");
  EXPECT_IN(with("fix b all deform 1 x scale 1.1"), "does not support a changing box");
  EXPECT_IN(with("change_box all boundary s p p"), "shrink-wrapped");
  start();    // and not for a length that no dx divides
  EXPECT_ERROR(box({12, 12, 12}, "p p s") + fluid("face zlo wall face zhi wall"), "shrink-wrapped");
  EXPECT_IN(with("change_box all x final 0 1.3e-3"),
            "the box has changed since the fix was defined");
  EXPECT_IN(with("change_box all boundary f p p"), "boundary command was used after");
  start();
  EXPECT_ERROR("newton off\n" + sphere + "\ncomm_style tiled" + fluid() + run(1),
               "comm_style tiled needs newton on");
  start();
  std::string growing = sphere;
  growing.replace(growing.find("style sphere"), 12, "style sphere 1");
  EXPECT_ERROR(growing + fluid() + "\nvariable d equal 7e-4+step*1e-8" +
                   "\nfix r all adapt 1 atom diameter v_d" + run(1),
               "fix r changes radii, which the fluid does not follow: unfix it");

  start();
  EXPECT_ERROR("units si\natom_style sphere\nregion t prism 0 1 0 1 0 1 0.2 0 0\ncreate_box 1 t" +
                   line("dx 0.1 nu 1 rho 1"),
               "does not support triclinic boxes");
  for (const std::string units : {"real", "metal", "electron"}) {
    start();
    EXPECT_ERROR("units " + units +
                     "\natom_style sphere\nregion b block 0 1 0 1 0 1\ncreate_box 1 b" +
                     line("dx 0.1 nu 1 rho 1") + run(0),
                 "units " + units + " have hidden conversion factors: use units si, cgs, lj");
  }
  for (const std::string units : {"cgs", "lj", "micro", "nano"}) {
    start();
    EXPECT_EQ(error_of("units " + units +
                       "\natom_style sphere\nregion b block 0 1 0 1 0 1"
                       "\ncreate_box 1 b\ntimestep 1e-3" +
                       line("dx 0.1 nu 1 rho 1") + run(1)),
              "");
  }
  start();
  EXPECT_ERROR("units si\natom_style atomic\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\nmass 1 1"
               "\ncreate_atoms 1 single 0.5 0.5 0.5" +
                   line("dx 0.1 nu 1 rho 1") + run(0),
               "grains need radius, omega and torque: use atom_style sphere");
}

TEST_F(Refusals, ShrinkTogetherWithAContactOffset)
{
  const std::string scene = box({12, 12, 12}, "p p f") + grain(1, {6, 6, 6}, 3.6) +
      "\ntimestep 1e-6" + fluid("every 1000 shrink 1e-5 face zlo wall face zhi wall");
  EXPECT_ERROR(scene + "\npair_style gran/lsd/coulomb offset 2e-5\npair_coeff * * 100 0.9 0.45" +
                   run(0),
               "shrink 1e-05 and the contact offset 2e-05 of pair style gran/lsd/coulomb are two");
  start();
  EXPECT_ERROR(scene + "\nfix f all wall/gran/lsd/coulomb 100 0.9 0.45 zplane 0 NULL offset 3e-5" +
                   run(0),
               "shrink 1e-05 and the contact offset 3e-05 of fix f are two ways of the same thing");
  // the contact law watches its own time step
  start();
  EXPECT_ERROR(box({12, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + fluid() +
                   "\npair_style gran/lsd/coulomb\npair_coeff * * 100 0.9 0.45" + run(0),
               "is more than a tenth of the shortest contact");
}

TEST_F(Refusals, StepsAndTimesteps)
{
  const std::string scene = box({8, 8, 8}) + "\nreset_timestep 7" + fluid("every 3 accel 1e-3 0 0");
  EXPECT_ERROR(scene + run(0), "starts at step 7, which is no multiple of every = 3");
  start();
  script(box({8, 8, 8}) + fluid("accel 1e-3 0 0") + run(5));
  EXPECT_ERROR("reset_timestep 0", "time-dependent fix");
  EXPECT_ERROR("timestep 2e-3",
               "has run with timestep 0.001 and cannot go on with 0.002: keep it, or "
               "define the fix anew");
}

TEST_F(Refusals, GhostCutoffIsRaisedWithAMessage)
{
  const std::string scene = box({12, 12, 12}) + grain(1, {6, 6, 6}, 3.6) + fluid();
  EXPECT_IN(log_of(scene + "\ncomm_modify cutoff 2e-4" + run(0)),
            "raised the ghost cutoff from 0.0002 to 0.00066 (largest radius + 2 dx + skin)");
  EXPECT_NOT_IN(log_of(run(0)), "raised");
  EXPECT_NOT_IN(log_of("comm_modify cutoff 1e-3" + run(0)), "raised");
}
