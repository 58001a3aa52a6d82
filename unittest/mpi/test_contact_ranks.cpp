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

// Grains that fall on each other and on walls move the same on any number of
// ranks: each test runs its scene on all ranks together and again on every
// rank alone, and compares.

#include "../lammps/lammps_fixture.h"

#include <cmath>
#include <map>

class ContactRanks : public LammpsTest {
 protected:
  static std::string num(double value)
  {
    char text[32];
    snprintf(text, sizeof(text), "%.17g", value);
    return text;
  }

  // 64 grains of two types in a box, periodic across and with walls below and
  // above, thrown at each other

  static std::string scene(const std::string &newton, const std::string &offset,
                           const std::string &extra)
  {
    std::string text = "units si\natom_style sphere\natom_modify map array sort 0 0\nboundary p p f"
                       "\nnewton " +
        newton +
        "\nprocessors * * 1\ncomm_modify vel yes"
        "\nregion box block 0 0.0032 0 0.0032 0 0.0036\ncreate_box 2 box"
        "\nneighbor 1e-4 bin\nneigh_modify delay 0 every 1 check yes"
        "\nthermo_style custom step";
    unsigned int seed = 4711;
    auto uniform = [&seed]() {
      seed = 1664525u * seed + 1013904223u;
      return seed / 4294967296.0;
    };
    for (int n = 0; n < 64; n++) {
      const std::string name = std::to_string(n + 1);
      text += "\ncreate_atoms " + std::to_string(1 + n % 2) + " single";
      for (int d : {n % 4, n / 4 % 4, n / 16}) text += " " + num(8.0e-4 * d + 4.0e-4);
      text += "\nset atom " + name + " diameter " + num(4.0e-4 + 2.0e-4 * uniform());
      text += "\nset atom " + name + " density 2600 vx " + num(uniform() - 0.5) + " vy " +
          num(uniform() - 0.5) + " vz " + num(uniform() - 0.5);
    }
    return text + "\npair_style gran/lsd/coulomb offset " + offset +
        "\npair_coeff * * 1000 0.9 0.45\npair_coeff 1 2 1500 0.8 0.3"
        "\nfix walls all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane 0 0.0036 offset " +
        offset +
        "\nfix report all ave/time 1 1000 1000 f_walls f_walls[3] f_walls[6] ave running"
        "\nfix move all nve/sphere\nfix down all gravity 9.81 vector 0 0 -1" +
        extra + "\ntimestep 5e-7\nrun 4000 post no";
  }

  // position, velocity and spin of the own atoms, and what the walls report

  std::map<int, std::vector<double>> result()
  {
    std::map<int, std::vector<double>> all;
    for (int i = 0; i < lmp->atom->nlocal; i++) {
      const int id = lmp->atom->tag[i];
      for (double *vec : {x(id), v(id), omega(id)}) all[id].insert(all[id].end(), vec, vec + 3);
    }
    all[0] = {thermo("f_report[1]"), thermo("f_report[2]"), thermo("f_report[3]")};
    return all;
  }

  void compare(const std::string &text)
  {
    start(MPI_COMM_WORLD);
    script(text);
    const auto together = result();
    const auto natoms = lmp->atom->natoms;
    start(MPI_COMM_SELF);
    script(text);
    const auto alone = result();
    EXPECT_EQ(natoms, 64);

    // grains meet at 1 m/s or so, in a box of millimetres
    const double scale[] = {1.0e-3, 1.0, 1.0e3};
    double speed = 0.0;
    for (const auto &[id, values] : together) {
      if (id == 0) continue;
      if (!alone.count(id)) {    // without leaving the others alone
        ADD_FAILURE() << "no grain " << id;
        continue;
      }
      const auto &expected = alone.at(id);
      for (int k = 0; k < 9; k++)
        EXPECT_NEAR(values[k], expected[k], 1.0e-12 * scale[k / 3]) << "grain " << id;
      speed = std::max(speed, std::fabs(values[8]));
    }

    // contacts with the walls and their forces, mean over the run
    for (int k : {0, 1, 2}) {
      EXPECT_NE(alone.at(0)[k], 0.0);
      EXPECT_NEAR(together.at(0)[k], alone.at(0)[k], 1.0e-9 * std::fabs(alone.at(0)[k]));
    }

    // the test says something only if grains have hit each other and spin
    double fastest = 0.0;
    MPI_Allreduce(&speed, &fastest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    EXPECT_GT(fastest, 10.0);
  }
};

TEST_F(ContactRanks, NewtonOn)
{
  compare(scene("on", "0", ""));
}

TEST_F(ContactRanks, NewtonOff)
{
  compare(scene("off", "0", ""));
}

TEST_F(ContactRanks, WithOffset)
{
  compare(scene("on", "5e-5", ""));
}

TEST_F(ContactRanks, SomeFrozenSomeRigid)
{
  // every other column of grains is tied in pairs, to bodies that cross the faces
  std::string extra = "\nunfix move\ngroup ice id 1:4\nfix ice ice freeze\ngroup bodies empty";
  std::string bodies, exclude;
  int nbodies = 0;
  for (int id = 5; id < 64; id += 4) {
    const std::string name = "b" + std::to_string(++nbodies);
    extra += "\ngroup " + name + " id " + std::to_string(id) + " " + std::to_string(id + 1) +
        "\ngroup bodies union bodies " + name;
    bodies += " " + name;
    exclude += "\nneigh_modify exclude group " + name + " " + name;
  }
  compare(scene("on", "0",
                extra + "\ngroup free subtract all ice bodies\nfix body bodies rigid group " +
                    std::to_string(nbodies) + bodies + "\nfix move free nve/sphere" + exclude));
}

TEST_F(ContactRanks, FileIsReadByOneAndKnownToAll)
{
  // found through LAMMPS_POTENTIALS, which is set where the tests run
  compare(scene("on", "0", "\npair_coeff * * file quartz_sand.lsd quartz"));
}

// errors that one rank finds are raised by all: none says on which rank

class CommonRefusal : public ContactRanks {
 protected:
  void check(const std::string &text, const std::string &expected)
  {
    const std::string message = error_of(text);
    EXPECT_NE(message.find(expected), std::string::npos) << message;
    EXPECT_EQ(message.find("on proc"), std::string::npos) << message;
  }
};

TEST_F(CommonRefusal, TimestepOfPair)
{
  // one light grain, which one rank owns
  script(scene("on", "0", ""));
  script("unfix report\nunfix walls\nset atom 1 diameter 5e-5\nset atom 1 density 2600");
  check("run 1", "is more than a tenth of the shortest contact of pair_style");
}

TEST_F(CommonRefusal, TimestepOfWall)
{
  script(scene("on", "0", ""));
  script("pair_coeff * * 1e-3 0.9 0.45\nset atom 1 diameter 5e-5\nset atom 1 density 2600");
  check("run 1", "is more than a tenth of the shortest contact of fix wall");
}

TEST_F(CommonRefusal, FileThatIsNotThere)
{
  script(scene("on", "0", ""));
  check("pair_coeff * * file no_such.lsd quartz", "no_such.lsd: it is neither there nor in");
}
