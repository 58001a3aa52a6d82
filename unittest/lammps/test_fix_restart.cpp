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

// Restart files of fix lb/ibb: how they are named and found, and which are refused. That runs go on
// from them as if they had not stopped: mpi/test_restart_ranks.cpp.

#include "fluid_scenes.h"

#include "update.h"

#include "lbm_state_file.h"

#include <cstring>
#include <filesystem>

class Restarts : public FluidTest {
 protected:
  const std::string fixes = "\nfix m all nve/sphere\n", options = "accel 1e-3 0 0 every 4 ";

  void begin(const std::string &more = "")
  {
    start();
    script(box({12, 11, 10}) + grain(1, {5.3, 6.1, 4.9}, 3.6, {2e-3, 0, 1e-3}) + "\ntimestep " +
           num(DT / 4) + fixes + fluid(options) + more);
  }
  static std::string head(const std::string &file)
  {
    return "read_restart " + file + "\nneighbor 1e-4 bin\n";
  }
  // goes on from a restart file, up to the reading of the fluid
  std::string error_from(const std::string &file, const std::string &more = "")
  {
    start();
    return error_of(head(file) + fixes + fluid(options + "restart " + file) + more + run(0));
  }
  static std::string bytes(const std::string &name)
  {
    std::ifstream file(name, std::ios::binary);
    std::stringstream all;
    all << file.rdbuf();
    return all.str();
  }
  static void write(const std::string &name, const std::string &content)
  {
    std::ofstream(name, std::ios::binary) << content;
  }
};

TEST_F(Restarts, GoesOnAndSaysSo)
{
  begin(run(42) + "\nwrite_restart a");
  const auto before = state();
  const double Ma = out(3), links = out(13), F = force(1)[0];
  start();
  EXPECT_IN(log_of(head("a") + fixes + fluid(options + "restart a") + run(0)),
            "Fix lb/ibb: goes on from a.lbibb, step 42, fluid step 10");
  EXPECT_EQ(state(), before);
  EXPECT_EQ(out(3), Ma);
  EXPECT_EQ(out(13), links);
  EXPECT_EQ(force(1)[0], F);
  EXPECT_EQ(bytes("a.lbibb.part"), "");
}

TEST_F(Restarts, StarStandsForTheStep)
{
  begin("\nrestart 20 step.*.data" + run(42));
  start();
  script(head("step.*.data") + fixes + fluid(options + "restart step.*.data") + run(2));
  EXPECT_EQ(lmp->update->ntimestep, 42);
  EXPECT_GT(out(9), 0.0);
}

TEST_F(Restarts, TwoFilesInTurn)
{
  begin("\nrestart 10 one two" + run(34));
  EXPECT_EQ(error_from("one"), "");
  EXPECT_EQ(lmp->update->ntimestep, 30);
  EXPECT_EQ(error_from("two"), "");
  EXPECT_EQ(lmp->update->ntimestep, 20);
}

TEST_F(Restarts, ManyFilesOfOneRankEach)
{
  begin(run(42) + "\nwrite_restart many.%");
  const auto before = state();
  EXPECT_EQ(error_from("many.%"), "");
  EXPECT_EQ(state(), before);
}

TEST_F(Restarts, WhatWasNotAskedForIsSaid)
{
  begin(run(42) + "\nwrite_restart a");
  start();
  EXPECT_ERROR(head("a") + fixes + fluid(options),
               "the restart file has a fluid of step 42: name the file with keyword restart to go "
               "on with it, or use restart none");
  start();
  script(head("a") + fixes + fluid(options + "restart none"));
  // at rest: the first run of a new fluid, with all that is asked of one
  EXPECT_ERROR(run(0), "the first run starts at step 42, which is no multiple of every = 4");
  start();
  EXPECT_ERROR(head("a") + fixes + "fix other all lb/ibb dx 1e-4 nu 1e-6 rho 1000 restart a" +
                   run(0),
               "no restart file was read that has a fluid of a fix with ID other");
  begin();
  script("unfix w");
  EXPECT_ERROR(fluid(options + "restart a") + run(0), "no restart file was read");
  start();
  EXPECT_ERROR(box({12, 11, 10}) + fluid("restart"), "Illegal fix lb/ibb name of the restart file");
}

TEST_F(Restarts, NoneStartsAtRest)
{
  begin(run(40) + "\nwrite_restart a");
  EXPECT_NE(force(1)[0], 0.0);
  start();
  script(head("a") + fixes + fluid(options + "restart none") + run(0));
  EXPECT_EQ(force(1)[0], 0.0);
  EXPECT_NEAR(out(9), 0.0, 1e-18);
}

TEST_F(Restarts, WrittenBeforeTheFirstRun)
{
  begin("\nwrite_restart a");
  start();
  EXPECT_IN(log_of(head("a") + fixes + fluid(options + "restart a") + run(40)),
            "was written before the first run: the fluid starts at rest");
  const auto restarted = state();
  begin(run(40));
  EXPECT_EQ(state(), restarted);
}

// the nodes of a grain that is gone are uncovered in the next step, whoever makes it
TEST_F(Restarts, GrainDeletedBeforeWriting)
{
  begin(grain(2, {0.3, 10.9, 9.8}, 2.6) + run(41) +
        "\ngroup gone id 2\ndelete_atoms group gone compress no\nwrite_restart a" + run(40));
  const auto through = state();
  start();
  script(head("a") + fixes + fluid(options + "restart a") + run(40));
  EXPECT_EQ(state(), through);
}

/* ---- what is refused ---- */

TEST_F(Restarts, OtherNumbersAreRefused)
{
  begin(run(42) + "\nwrite_restart a");
  auto with = [&](const std::string &dx, const std::string &nu, const std::string &rho,
                  const std::string &more, const std::string &between = "") {
    start();
    return error_of(head("a") + between + fixes + "fix w all lb/ibb dx " + dx + " nu " + nu +
                    " rho " + rho + " restart a accel 1e-3 0 0 " + more + run(0));
  };
  const std::string dx = num(DX), nu = num(NU), rho = num(RHO);
  EXPECT_EQ(with(dx, nu, rho, "every 4"), "");
  EXPECT_IN(with(num(DX / 2), nu, rho, "every 4"), "dx was 0.0001 when the restart file was");
  EXPECT_IN(with(dx, "2e-6", rho, "every 4"),
            "nu was 1e-06 when the restart file was written, "
            "now it is 2e-06: keep it, or start anew");
  EXPECT_IN(with(dx, nu, "900", "every 4"), "rho was 1000");
  EXPECT_IN(with(dx, nu, rho, "every 2"), "every was 4");
  EXPECT_IN(with(dx, nu, rho, "every 4 precision single"), "(precision) was 8");
  EXPECT_IN(with(dx, nu, rho, "every 4", "reset_timestep 0"), "(reset_timestep) was 42");
  EXPECT_IN(with(dx, nu, rho, "every 4\ntimestep " + num(DT / 5)), "cannot go on with");
  // these are the user's to change
  EXPECT_EQ(with(dx, nu, rho, "every 4 link bouzidi average no collision bgk"), "");
}

TEST_F(Restarts, OtherFilesAreRefused)
{
  begin(run(42) + "\nwrite_restart a" + run(10) + "\nwrite_restart b\nwrite_restart c");
  begin("\nset atom 1 vx 1e-3" + run(42) + "\nwrite_restart d");
  const std::string a = bytes("a.lbibb"), text = "cannot go on from a.lbibb: ";
  EXPECT_EQ(error_from("a"), "");
  EXPECT_EQ(bytes("b.lbibb"), bytes("c.lbibb"));

  std::remove("a.lbibb");
  EXPECT_IN(error_from("a"), text);
  write("a.lbibb", bytes("b.lbibb"));
  EXPECT_IN(error_from("a"), text + "it is of step 52, the grains are of step 42: the two files");
  write("a.lbibb", bytes("d.lbibb"));
  EXPECT_IN(error_from("a"), text + "its checksum is not that which the restart file names");
  write("a.lbibb", bytes("a"));
  EXPECT_IN(error_from("a"), text + "it is no file of a fluid");
  constexpr std::size_t HEAD = sizeof(lbm::StateHeader);
  for (const std::size_t length : {std::size_t(0), std::size_t(7), HEAD - 1}) {
    write("a.lbibb", a.substr(0, length));
    EXPECT_IN(error_from("a"), text + "it is truncated: " + std::to_string(length) + " bytes");
  }
  for (const std::size_t length : {HEAD, a.size() / 2, a.size() - 1}) {
    write("a.lbibb", a.substr(0, length));
    EXPECT_IN(error_from("a"),
              text + "it is truncated: " + std::to_string(length) + " bytes instead of " +
                  std::to_string(a.size()));
  }
  write("a.lbibb", a + "x");
  EXPECT_IN(error_from("a"), text + "it is too long");
  write("a.lbibb", a);
  EXPECT_EQ(error_from("a"), "");
}

// wherever a bit is turned: head, grain, populations
TEST_F(Restarts, DamagedFilesAreRefused)
{
  begin(run(42) + "\nwrite_restart a");
  const std::string a = bytes("a.lbibb");
  auto damaged = [&](std::size_t place, int bit) {
    std::string other = a;
    other[place] = char(other[place] ^ (1 << bit));
    write("a.lbibb", other);
    return error_from("a");
  };
  constexpr std::size_t HEAD = sizeof(lbm::StateHeader);
  for (std::size_t place = 0; place < HEAD + 100; place++)
    EXPECT_IN(damaged(place, int(place % 8)), "cannot go on from a.lbibb: it");
  for (std::size_t place = HEAD + 100; place < a.size(); place += 997)
    EXPECT_IN(damaged(place, int(place % 8)), "it is damaged: its checksum is wrong");
}

// in LAMMPS's own file, as far as it is the fix's
TEST_F(Restarts, DamagedNumbersAreRefused)
{
  begin(run(42) + "\nwrite_restart a");
  const std::string a = bytes("a"), style("lb/ibb\0", 7);
  const std::size_t first = a.find(style) + style.size() + 4;
  int size;
  std::memcpy(&size, &a[first - 4], 4);
  ASSERT_GT(size, 300);
  for (int k = 0; k < size; k++) {
    std::string other = a;
    other[first + k] = char(other[first + k] ^ (1 << k % 8));
    write("a", other);
    EXPECT_IN(error_from("a"),
              k < 8 ? "written by another version of this package"
                    : "the checksum of this fix's data is wrong");
  }
  write("a", a);
  EXPECT_EQ(error_from("a"), "");
}

TEST_F(Restarts, CannotBeWritten)
{
  begin(run(8));
  std::filesystem::remove_all("new.lbibb");    // of a former run of this test
  for (const std::string name : {"new.lbibb.part", "new.lbibb"}) {
    std::filesystem::create_directories(name + "/full");
    EXPECT_ERROR("write_restart new",
                 name == "new.lbibb" ? "cannot rename new.lbibb.part to new.lbibb"
                                     : "the fluid's restart file: cannot open new.lbibb.part");
    std::filesystem::remove_all(name);
  }
  EXPECT_EQ(error_of("write_restart new"), "");
}
