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

// Every cause for which fix lb/ibb stops a run, provoked on any number of ranks: the same message on all
// of them, the same as on one alone, and nothing in the files written before that is not a number.

#include "../lammps/fluid_scenes.h"

#include <regex>

class StopsOnRanks : public FluidTest {
 protected:
  static bool has_no_number(const std::string &text)
  {
    static const std::regex none("\\b(nan|inf)\\b", std::regex::icase);
    return std::regex_search(text, none);
  }
  static std::string contents(const std::string &name)
  {
    std::ifstream file(name);
    std::stringstream all;
    all << file.rdbuf();
    return all.str();
  }
  // when; which node is the fastest may depend on round-off
  static std::string time(const std::string &message)
  {
    return message.substr(0, message.find(": ", message.find("fluid step")));
  }
  static std::string cause(const std::string &message)
  {
    const auto at = message.find("Likely cause: ");
    return at == std::string::npos ? message : message.substr(at, message.find(" (src") - at);
  }

  // before: what stands before the fluid in the script; after: what follows it
  std::string stops(const std::string &before, const std::string &after, bool print = true)
  {
    // prints before the fluid's own step, and of what the fluid has done to grains
    auto script_of = [&](const std::string &file, const std::string &dump) {
      return before + "\nvariable ke equal ke\ncompute v all reduce sum vx\n" +
          "fix p all print 1 \"$(step)" + (print ? " $(v_ke) $(c_v)" : "") + "\" screen no " +
          file + after.substr(0, after.rfind('\n')) +
          "\nthermo_style custom step ke f_w[3] f_w[9]\nthermo 7" + dump +
          after.substr(after.rfind('\n'));
    };
    start(MPI_COMM_SELF);
    const std::string alone = error_of(script_of("", ""));
    start(MPI_COMM_WORLD);
    script("log stops.log");
    const std::string message = error_of(
        script_of("file stops.print", "\ndump d all custom 7 stops.dump id x vx fx f_w[1]"));
    script("log none");
    lmp.reset();
    int me;
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    char first[3000] = "";
    snprintf(first, sizeof(first), "%s", message.c_str());
    MPI_Bcast(first, sizeof(first), MPI_CHAR, 0, MPI_COMM_WORLD);
    EXPECT_EQ(message, std::string(first));
    EXPECT_NOT_IN(message, "on proc");
    EXPECT_EQ(time(message), time(alone));
    EXPECT_EQ(cause(message), cause(alone));
    if (me == 0) {
      EXPECT_NE(contents("stops.log").find("Step"), std::string::npos);
      const std::string thermo = contents("stops.log");
      EXPECT_FALSE(has_no_number(thermo.substr(0, thermo.find("ERROR")))) << thermo;
      EXPECT_FALSE(has_no_number(contents("stops.print"))) << contents("stops.print");
      EXPECT_FALSE(has_no_number(contents("stops.dump"))) << contents("stops.dump");
      for (const char *name : {"stops.log", "stops.print", "stops.dump"}) std::remove(name);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    return message;
  }

  std::string still() { return box({16, 12, 12}) + grain(1, {6.2, 6.1, 5.9}, 3.6); }
};

// ---- the fluid

TEST_F(StopsOnRanks, DrivenTooHard)
{
  const std::string message =
      stops(still(),
            fluid("check 3 accel v_a 0 0") + "\nvariable a equal 20*(step>3)" + frozen() + run(50));
  EXPECT_IN(message, "stopped at step 6, fluid step 6: at (");
  EXPECT_IN(message, "Likely cause: accel or gradp, which change the fluid's speed by 0.02 in one");
}

TEST_F(StopsOnRanks, DrivenByWhatIsNoNumber)
{
  const std::string message = stops(still(),
                                    fluid("check 3 accel v_a 0 0") +
                                        "\nvariable a equal 1e300*(step>3)" + frozen() + run(50));
  EXPECT_IN(message, "stopped at step ");
}

TEST_F(StopsOnRanks, TauTooCloseToOneHalf)
{
  const std::string message =
      stops(still(),
            "\nfix w all lb/ibb dx " + num(DX) + " nu 1e-8 rho 1000 accel 0.3 0 0 check 5" +
                frozen() + run(500));
  EXPECT_IN(message, "tau = 0.5030. Likely cause: tau too close to 1/2 for this flow");
}

TEST_F(StopsOnRanks, GrainSetInMotionTooSuddenly)
{
  const std::string message =
      stops(still(),
            fluid("check 1") + "\nfix m all move linear " + num(0.29 * SOUND) + " 0 0" + run(50));
  EXPECT_IN(message, "the fluid's speed is ");
  EXPECT_IN(message,
            "Likely cause: the grain is too fast for the fluid time step, or was set in motion");
}

TEST_F(StopsOnRanks, FaceTooSudden)
{
  const std::string message =
      stops(box({24, 12, 12}, "f p p") + grain(1, {4.9, 6.1, 5.9}, 3.6),
            fluid("check 1 face xlo velocity " + num(0.29 * SOUND) + " 0 0 face xhi pressure 0") +
                frozen() + run(100));
  EXPECT_IN(message, "Likely cause: the pressure or velocity of a face is too large or changes");
}

TEST_F(StopsOnRanks, TooFewCells)
{
  // in a box so narrow that no node is further than 2 cells from the surface
  const std::string message = stops(box({5, 5, 5}) + grain(1, {2.6, 2.5, 2.4}, 2.2),
                                    fluid("check 1 accel 2.5 0 0") + frozen() + run(500));
  EXPECT_IN(message, "radius 2.2 cells");
  EXPECT_IN(message, "Likely cause: too few cells per radius for this flow; refine dx");
}

TEST_F(StopsOnRanks, FlowTooFast)
{
  const std::string message = stops(box({16, 12, 12}) + grain(1, {6.2, 6.1, 5.9}, 3.6),
                                    fluid("check 5 accel 0.3 0 0") + frozen() + run(500));
  EXPECT_IN(message, "Likely cause: the flow is too fast for the fluid time step, or was started");
}

// ---- grains

TEST_F(StopsOnRanks, SpinsTooFast)
{
  const std::string message = stops(still() + "\nset atom 1 omega 0 0 50",
                                    fluid() + "\nfix m all move linear 0 0 0" + run(50));
  EXPECT_IN(message, "Likely cause: it spins too fast");
}

// as a grain of a hundredth of the density of water would be, were it not for coupling auto
TEST_F(StopsOnRanks, LightGrainCoupledExplicitly)
{
  const std::string message =
      stops(still() + "\nset atom 1 density 10",
            fluid("coupling explicit accel 1e-2 0 0") + "\nfix m all nve/sphere" + run(50));
  EXPECT_IN(message,
            "density 0.01 rho; tau = 0.8000. Likely cause: the grain is too light to be coupled");
}

TEST_F(StopsOnRanks, LightGrainFallsBeforeTheFirstStep)
{
  const std::string message =
      stops(still() + "\nset atom 1 density 10",
            fluid("every 4 buoyancy 0 0 -1") + "\ntimestep " + num(DT / 4) +
                "\nfix m all nve/sphere\nfix g all gravity 1 vector 0 0 -1" + run(50));
  EXPECT_IN(message, "Likely cause: until the first fluid step so light a grain falls");
}

TEST_F(StopsOnRanks, ForcesOfSingleSteps)
{
  const std::string message = stops(still() + "\nset atom 1 density 10",
                                    fluid("coupling explicit average no accel 1e-2 0 0") +
                                        "\nfix m all nve/sphere" + run(50));
  EXPECT_IN(message, "Likely cause: the force of a single fluid step throws the grain to and fro");
}

// two grains deep in each other, a hundred granular steps to a fluid step
TEST_F(StopsOnRanks, ThrownByAContact)
{
  const std::string message = stops(
      box({24, 12, 12}, "p p p", "comm_modify cutoff 1.2e-3") + grain(1, {8, 6, 6}, 3.6) +
          grain(2, {14, 6, 6}, 3.6) + "\npair_style gran/lsd/coulomb\npair_coeff * * 0.3 0.9 0.4",
      fluid("every 20") + "\ntimestep " + num(DT / 20) + "\nfix m all nve/sphere" + run(500));
  EXPECT_IN(message,
            "Likely cause: it is too fast for the fluid time step, or thrown by a contact");
}

TEST_F(StopsOnRanks, GrainPlacedAnew)
{
  const std::string message =
      stops(still(), fluid() + frozen() + run(5) + "\ndisplace_atoms all move 3e-4 0 0" + run(5));
  EXPECT_IN(message, "Likely cause: it was placed anew");
}

TEST_F(StopsOnRanks, NewGrainTooSmall)
{
  const std::string message =
      stops(still(),
            fluid() + frozen() + run(5) + "\ncreate_atoms 1 single " + at({12.1, 6, 6}) +
                "\nset atom 2 diameter 3e-4 density 2600" + run(5));
  EXPECT_IN(message, "is 1.5 cells, limit 2: use dx <= 7.5e-05");
}

TEST_F(StopsOnRanks, ForceThatIsNoNumber)
{
  const std::string message = stops(
      still(),
      fluid() + "\nvariable push equal 1e-12*exp(1000*(step>3))\nfix push all addforce v_push 0 0" +
          "\nfix m all nve/sphere" + run(50),
      false);    // a variable would refuse it first
  EXPECT_IN(message, "stopped at step 4, fluid step 4: grain 1 at (");
  EXPECT_IN(message, "has a place, a velocity or a force that is not a finite number");
}

// long before the fluid is looked at: the grain must not take it along
TEST_F(StopsOnRanks, ForceOfAFluidThatIsNoNumber)
{
  const std::string message =
      stops(still(),
            fluid("every 5 check 1000 accel v_a 0 0") + "\nvariable a equal 1e300*(step>30)" +
                "\ntimestep " + num(DT / 5) + "\nfix m all nve/sphere" + run(60));
  EXPECT_IN(message, "stopped at step 35, fluid step 7: ");
}

// a profile is asked for between checks, by what prints before the fluid's own step
TEST_F(StopsOnRanks, ProfileOfAFluidThatIsNoNumber)
{
  script(box({12, 12, 12}) + fluid("check 1000 accel v_a 0 0") +
         "\nvariable a equal 1e300*(step>3)\ncompute c all lb/ibb/profile w x layers 2" +
         "\nfix p all ave/time 1 1 1 c_c[3] c_c[6] mode vector file profile.txt\nthermo 1000");
  EXPECT_ERROR(run(20), "stopped at step ");
  lmp.reset();
  EXPECT_FALSE(has_no_number(contents("profile.txt"))) << contents("profile.txt");
  MPI_Barrier(MPI_COMM_WORLD);
}
