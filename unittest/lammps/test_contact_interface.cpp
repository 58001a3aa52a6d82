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

// What LAMMPS and scripts ask of the contact styles: coefficients, single(), hybrid
// and restart files.

#include "contact_scenes.h"

#include "force.h"
#include "pair.h"

/* ---- coefficients ---- */

TEST_F(ContactTest, EachPairOfTypesHasItsOwn)
{
  const double r = 3.0e-4;
  const std::string scene = box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
      "\nset atom 2 type 2\ntimestep 1e-7\npair_style gran/lsd/coulomb";
  script(scene + "\npair_coeff * * 1000 0.9 0.45\npair_coeff 1 2 2000 0.9 0.45\nrun 0 post no");
  EXPECT_NEAR(f(2)[0], 2000.0 * 1.0e-6, 1.0e-9);
}

TEST_F(ContactTest, CoefficientsFromAFile)
{
  // found through LAMMPS_POTENTIALS, which is set where the tests run
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
         "\ntimestep 1e-7\npair_style gran/lsd/coulomb\npair_coeff * * file quartz_sand.lsd quartz"
         "\nrun 0 post no");
  int dim;
  auto *pair = lmp->force->pair;
  EXPECT_EQ(((double **) pair->extract("kn", dim))[2][1], 1.0e3);
  EXPECT_EQ(dim, 2);
  EXPECT_EQ(((double **) pair->extract("e", dim))[1][1], 0.9);
  EXPECT_EQ(((double **) pair->extract("mu", dim))[1][2], 0.45);
  EXPECT_NEAR(f(2)[0], 1.0e-3, 1.0e-9);

  script("pair_coeff 1 2 file glass_beads.lsd glass\nrun 0 post no");
  EXPECT_EQ(((double **) pair->extract("e", dim))[1][2], 0.97);
  EXPECT_EQ(((double **) pair->extract("mu", dim))[2][1], 0.092);

  script("fix floor all wall/gran/lsd/coulomb file quartz_sand.lsd quartz xplane " +
         num(1.0e-6 - r) + " NULL\nrun 0 post no");
  EXPECT_NEAR(thermo("f_floor[1]"), 1.0e-3, 1.0e-9);
}

/* ---- what LAMMPS asks of a pair style ---- */

TEST_F(ContactTest, SingleIsTheForceOfTheRun)
{
  Impact c;
  c.mu = 0.3;
  c.vt = 0.1;
  c.r2 = 2.0e-4;
  c.offset = 2.0e-5;
  start();
  const double dt = pair_duration(c) / 50.0;
  script(box() + grain(1, -c.r1, 0, 0, c.r1) +
         grain(2, c.r2 + 2.0 * c.offset - 1.0e-6, 1.0e-5, 0, c.r2) + velocity(1, c.vn, c.vt, 0.01) +
         pair(c.e, c.mu, c.offset) + integrate() + "\ntimestep " + num(dt) + "\nrun 0 post no");
  const int i = index(1), j = index(2);
  double del[3], rsq = 0.0, fforce;
  for (int d = 0; d < 3; d++) {
    del[d] = x(1)[d] - x(2)[d];
    rsq += del[d] * del[d];
  }
  auto *pair = lmp->force->pair;
  pair->single(i, j, 1, 1, rsq, 0.0, 1.0, fforce);
  double fs2 = 0.0;
  for (int d = 0; d < 3; d++) {
    EXPECT_NEAR(del[d] * fforce + pair->svector[d], f(1)[d], 1.0e-12);
    fs2 += pair->svector[d] * pair->svector[d];
  }
  EXPECT_NEAR(pair->svector[3], std::sqrt(fs2), 1.0e-15);
  EXPECT_GT(pair->svector[3], 0.0);

  // out of touch there is none
  pair->single(i, j, 1, 1, 1.0, 0.0, 1.0, fforce);
  EXPECT_EQ(fforce, 0.0);
  EXPECT_EQ(pair->svector[3], 0.0);
}

TEST_F(ContactTest, WorksInsideHybrid)
{
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
         "\npair_style hybrid gran/lsd/coulomb\npair_coeff * * gran/lsd/coulomb 1000 0.9 0.45"
         "\ntimestep 1e-7\nrun 0 post no");
  EXPECT_NEAR(f(2)[0], 1.0e-3, 1.0e-9);
  EXPECT_ERROR("timestep 1e-4\nrun 0", "Timestep 0.0001 is more than a tenth");
  // pairs of another style do not count, whatever the memory of our coefficients holds
  start();
  EXPECT_EQ(error_of(box() + grain(1, 0, 0, 0, r) + grain(2, 2.0 * r - 1.0e-6, 0, 0, r) +
                     "\nset atom 2 type 2\npair_style hybrid gran/lsd/coulomb zero 1e-3"
                     "\npair_coeff 1 1 gran/lsd/coulomb 1000 0.9 0.45\npair_coeff * 2 zero"
                     "\ntimestep 1e-7\nrun 0 post no"),
            "");
}

TEST_F(ContactTest, RestartContinuesTheRun)
{
  const std::string settle =
      "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane -0.005 NULL"
      "\nfix sidex all wall/gran/lsd/coulomb 1000 0.9 0.45 xplane -4e-4 4e-4"
      "\nfix sidey all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane -4e-4 4e-4"
      "\nfix down all gravity 9.81 vector 0 0 -1" +
      integrate();
  std::string grains;
  for (int n = 0; n < 12; n++)
    grains += grain(n + 1, 1.0e-5 * (n * 7 % 5), 1.0e-5 * (n * 3 % 7), -0.0046 + 6.0e-4 * n,
                    2.5e-4 + 1.0e-6 * n);
  script(box() + grains +
         "\npair_style gran/lsd/coulomb offset 2e-5 limit_damping yes\npair_coeff * * 1000 0.9 0.45"
         "\npair_coeff 2 2 2000 0.8 0.3\npair_coeff 1 2 1500 0.7 0.2" +
         settle +
         "\ntimestep 1e-6\nrun 150000 post no\nwrite_restart contact_law.restart"
         "\nrun 5000 post no");
  std::vector<double> straight;
  for (int id = 1; id <= 12; id++)
    for (int d = 0; d < 3; d++) straight.insert(straight.end(), {x(id)[d], v(id)[d], omega(id)[d]});
  EXPECT_GT(thermo("f_floor"), 0.0);

  // read_restart brings the coefficients back, the fixes have no state
  start();
  script("atom_modify map array sort 0 0\ncomm_modify vel yes\nread_restart contact_law.restart"
         "\nneighbor 1e-4 bin\nneigh_modify delay 0 every 1 check yes" +
         settle + "\nrun 5000 post no");
  int n = 0;
  for (int id = 1; id <= 12; id++)
    for (int d = 0; d < 3; d++) {
      EXPECT_EQ(x(id)[d], straight[n++]);
      EXPECT_EQ(v(id)[d], straight[n++]);
      EXPECT_EQ(omega(id)[d], straight[n++]);
    }
  int dim;
  EXPECT_EQ(((double **) lmp->force->pair->extract("e", dim))[1][2], 0.7);
  EXPECT_EQ(((double **) lmp->force->pair->extract("mu", dim))[2][2], 0.3);
  EXPECT_EQ(((double **) lmp->force->pair->extract("kn", dim))[2][2], 2000.0);
  EXPECT_EQ(*(double *) lmp->force->pair->extract("offset", dim), 2.0e-5);
  std::remove("contact_law.restart");
}

TEST_F(ContactTest, RestartKeepsLimitDamping)
{
  // stop before the touch, go on from the restart file
  Impact c;
  c.e = 0.5;
  c.limit = "yes";
  c.parts = 1000.3;
  c.extra = "\nrestart 1 contact_law.*.restart\nrun 1 post no\nrestart 0";
  hit_grain(c);
  start();
  script("atom_modify map array sort 0 0\ncomm_modify vel yes\nread_restart contact_law.1.restart"
         "\nneighbor 1e-4 bin\nthermo_style custom step" +
         integrate() + "\ntimestep " + num(pair_duration(c) / c.parts));
  EXPECT_EQ(v(2)[0], 0.0);
  run_through(c);
  EXPECT_NEAR((v(2)[0] - v(1)[0]) / c.vn, cut_restitution(c.e), 1.0e-3);
  std::remove("contact_law.1.restart");
}
