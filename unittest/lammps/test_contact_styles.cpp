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

// What the contact styles do beyond the law: contact radius, walls, frozen and
// rigid grains, coefficients, and what LAMMPS asks of a pair style.

#include "contact_scenes.h"

#include "force.h"
#include "pair.h"

/* ---- the contact radius ---- */

TEST_F(ContactTest, OffsetShiftsTheTouch)
{
  const double r1 = 3.0e-4, r2 = 2.0e-4, offset = 5.0e-5;
  for (double gap : {1.0e-9, -1.0e-9}) {
    start();
    script(box() + grain(1, 0, 0, 0, r1) + grain(2, r1 + r2 + 2.0 * offset + gap, 0, 0, r2) +
           pair(0.9, 0.45, offset) + integrate() + "\ntimestep 1e-7\nrun 0 post no");
    if (gap > 0.0)
      EXPECT_EQ(f(2)[0], 0.0);
    else
      EXPECT_NEAR(f(2)[0], KN * 1.0e-9, 1.0e-5 * KN * 1.0e-9);

    start();
    script(box() + grain(1, 0, r1 + offset + gap, 0, r1) +
           "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane 0 NULL offset " +
           num(offset) + integrate() + "\ntimestep 1e-7\nrun 0 post no");
    if (gap > 0.0)
      EXPECT_EQ(f(1)[1], 0.0);
    else
      EXPECT_NEAR(f(1)[1], KN * 1.0e-9, 1.0e-5 * KN * 1.0e-9);
  }
}

TEST_F(ContactTest, OffsetLargerThanTheSkinMissesNothing)
{
  // a granular neighbor list of stock would end at r1 + r2 + skin, far inside
  Impact c;
  c.offset = 1.0e-4;
  c.skin = 1.0e-6;
  c.r2 = 2.0e-4;
  c.parts = 500.3;
  for (bool newton : {true, false}) {
    c.newton = newton;
    hit_grain(c);
    EXPECT_NEAR((v(2)[0] - v(1)[0]) / c.vn, c.e, 1.0e-3);
  }
}

TEST_F(ContactTest, OffsetAcrossAPeriodicFace)
{
  // the ghosts must reach as far as the contact
  const double r = 3.0e-4, offset = 1.0e-4;
  for (const char *newton : {"on", "off"}) {
    start();
    script(box(false, newton == std::string("on"), 1.0e-6, "p p p") +
           grain(1, -0.005 + r + 0.9 * offset, 0, 0, r) +
           grain(2, 0.005 - r - 0.9 * offset, 0, 0, r) + pair(0.9, 0.45, offset) + integrate() +
           "\ntimestep 1e-7\nrun 0 post no");
    EXPECT_NEAR(f(1)[0], KN * 0.2 * offset, 1.0e-9 * KN * offset);
    EXPECT_NEAR(f(2)[0], -KN * 0.2 * offset, 1.0e-9 * KN * offset);
  }
}

TEST_F(ContactTest, OffsetRollsOnItsContactRadius)
{
  // the contact point is at the contact radius: rolling means v = omega (r + offset)
  Impact c;
  c.offset = 6.0e-5;
  c.kn = STIFF;
  c.mu = 0.5;
  c.vt = 0.5 * 3.0 * c.mu * 1.8 * c.vn;
  hit_wall(c);
  EXPECT_NEAR(v(1)[0] + omega(1)[2] * (c.r1 + c.offset), 0.0, 1.0e-4 * c.vt);
}

TEST_F(ContactTest, OffsetWithNeighborMulti)
{
  const double r1 = 3.0e-4, r2 = 1.0e-4, offset = 1.0e-4;
  script(
      box(false, true, 1.0e-6) + grain(1, 0, 0, 0, r1) +
      grain(2, r1 + r2 + 1.9 * offset, 0, 0, r2) +
      "\nneighbor 1e-6 multi\nneigh_modify collection/interval 2 2.5e-4 6.5e-4\ncomm_modify mode "
      "multi vel yes" +
      pair(0.9, 0.45, offset) + integrate() + "\ntimestep 1e-7");
  EXPECT_ERROR("run 0", "interval");
  script("neigh_modify collection/type 1 *\nrun 0 post no");
  EXPECT_NEAR(f(2)[0], KN * 0.1 * offset, 1.0e-9 * KN * offset);
}

/* ---- walls ---- */

TEST_F(ContactTest, ReactionOfWallsIsReported)
{
  // between two walls that squeeze: the lower pushes up, the upper down
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, r - 1.0e-6, r) +
         "\nfix slit all wall/gran/lsd/coulomb 1000 0.9 0.45 zplane 0 " + num(2.0 * r - 4.0e-6) +
         integrate() + "\ntimestep 1e-7\nrun 0 post no");
  EXPECT_EQ(thermo("f_slit"), 2.0);
  EXPECT_NEAR(thermo("f_slit[3]"), KN * 1.0e-6, 1.0e-9);
  EXPECT_NEAR(thermo("f_slit[6]"), -KN * 3.0e-6, 1.0e-9);
  EXPECT_NEAR(f(1)[2], -KN * 2.0e-6, 1.0e-9);

  // anew, at the same step
  script("displace_atoms all move 0 0 1e-6\nrun 0 post no");
  EXPECT_EQ(thermo("f_slit"), 1.0);
  EXPECT_NEAR(thermo("f_slit[3]"), 0.0, 1.0e-9);
  EXPECT_NEAR(thermo("f_slit[6]"), -KN * 4.0e-6, 1.0e-9);
}

TEST_F(ContactTest, WallKnowsGrainsThatAreSorted)
{
  // grains of many sizes bounce on a floor while they drift past each other, so
  // that LAMMPS changes their order; without contacts among them that is no matter
  std::vector<double> unsorted;
  for (const char *sort : {"0 0", "10 4e-4"}) {
    start();
    std::string text = box();
    for (int n = 0; n < 8; n++) {
      const double r = 2.0e-4 + 2.0e-5 * n;
      text += grain(n + 1, 1.0e-3 * (n - 4), r, 0, r) + velocity(n + 1, 0.2 * (4 - n), -0.5, 0.0);
    }
    script(text + "\natom_modify sort " + sort + "\npair_style zero 1e-4\npair_coeff * *" +
           "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.02 yplane 0 0.001" + integrate() +
           "\ntimestep 5e-7\nrun 20000 post no");
    for (int id = 1; id <= 8; id++) {
      if (*sort == '0')
        unsorted.insert(unsorted.end(), {x(id)[1], v(id)[0]});
      else {
        EXPECT_EQ(x(id)[1], unsorted[2 * id - 2]) << "grain " << id;
        EXPECT_EQ(v(id)[0], unsorted[2 * id - 1]) << "grain " << id;
      }
    }
  }
}

TEST_F(ContactTest, ShearingWallDragsAGrainAlong)
{
  // until it rolls on the wall: its centre then has 2/7 of the wall's speed
  const double r = 3.0e-4, speed = 0.02;
  script(box() + grain(1, -0.004, r - sphere_mass(r) * GRAVITY / KN, 0, r) +
         "\nfix belt all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane 0 NULL shear x " + num(speed) +
         "\nfix down all gravity 9.81 vector 0 -1 0" + integrate() +
         "\ntimestep 1e-6\nrun 10000 post no");
  EXPECT_NEAR(v(1)[0] / speed, 2.0 / 7.0, 1.0e-4);
}

TEST_F(ContactTest, WigglingWallMovesAsItSays)
{
  // a quarter of a period on, the wall has moved by the amplitude
  const double r = 3.0e-4, amplitude = 1.0e-5;
  script(box() + grain(1, 0, r, 0, r) +
         "\nfix plate all wall/gran/lsd/coulomb 1000 1 0 yplane 0 NULL wiggle y " + num(amplitude) +
         " 4e-5\ntimestep 1e-7\nrun 100 post no");
  EXPECT_NEAR(f(1)[1], KN * amplitude, 1.0e-9);
}

TEST_F(ContactTest, GrainBehindAWallIsPushedBack)
{
  const double r = 3.0e-4;
  script(box() + grain(1, 0, -0.5 * r, 0, r) +
         "\nfix floor all wall/gran/lsd/coulomb 1000 0.9 0.45 yplane 0 NULL" + integrate() +
         "\ntimestep 1e-7\nrun 0 post no");
  EXPECT_NEAR(f(1)[1], KN * 1.5 * r, 1.0e-9);
}

/* ---- frozen and rigid grains ---- */

TEST_F(ContactTest, FrozenGrainIsInfinitelyHeavy)
{
  // as the first and as the second of the pair
  const double r = 3.0e-4, vn = 0.05, e = 0.8;
  const double dt = contact_time({KN, e, 0.0}, sphere_mass(r)) / 1000.3;
  for (const char *frozen : {"1", "2"}) {
    for (bool newton : {true, false}) {
      start();
      const int mover = (*frozen == '1') ? 2 : 1;
      const double sign = (mover == 1) ? 1.0 : -1.0, gap = 2.5 * dt * vn;
      script(box(false, newton) + grain(1, -r - gap, 0, 0, r) + grain(2, r, 0, 0, r) +
             velocity(mover, sign * vn, 0, 0) + pair(e, 0.0) + "\ngroup ice id " + frozen +
             "\nfix ice ice freeze" + integrate() + "\ntimestep " + num(dt) + "\nrun 1500 post no");
      EXPECT_NEAR(-sign * v(mover)[0] / vn, e, 1.0e-3);
      EXPECT_EQ(v(3 - mover)[0], 0.0);
    }
  }
}

TEST_F(ContactTest, TwoFrozenGrainsAreLeftAlone)
{
  // neither has a mass to damp: no force, and nothing infinite in the pressure
  const double r = 3.0e-4;
  script(box() + grain(1, 0, 0, 0, r) + grain(2, r, 0, 0, r) + pair(0.9, 0.45) +
         "\nfix ice all freeze\ncompute p all pressure NULL pair\nthermo_style custom step c_p"
         "\ntimestep 1e-7\nrun 10 post no");
  EXPECT_EQ(f(1)[0], 0.0);
  EXPECT_EQ(thermo("c_p"), 0.0);
}

TEST_F(ContactTest, RigidBodyWeighsAsAWhole)
{
  // a dumbbell along its axis against a wall and against a grain: twice the mass
  const double r = 3.0e-4, vn = 0.05, e = 0.8, m = sphere_mass(r);
  const double dt = contact_time({KN, e, 0.0}, m * 2.0 * m / (3.0 * m)) / 1000.3;
  const std::string clump = "\ngroup clump id 1 2\nfix body clump rigid single"
                            "\nneigh_modify exclude group clump clump\ntimestep " +
      num(dt);
  script(box() + grain(1, 0, r + 2.5 * dt * vn, 0, r) + grain(2, 0, 3.0 * r + 2.5 * dt * vn, 0, r) +
         velocity(1, 0, -vn, 0) + velocity(2, 0, -vn, 0) + pair(e, 0.0) +
         "\nfix floor all wall/gran/lsd/coulomb 1000 " + num(e) + " 0 yplane 0 NULL" + clump +
         "\nrun 3000 post no");
  EXPECT_NEAR(v(1)[1] / vn, e, 1.0e-3);

  start();
  script(box() + grain(1, 0, r + 2.5 * dt * vn, 0, r) + grain(2, 0, 3.0 * r + 2.5 * dt * vn, 0, r) +
         grain(3, 0, -r, 0, r) + velocity(1, 0, -vn, 0) + velocity(2, 0, -vn, 0) + pair(e, 0.0) +
         clump + "\ngroup free id 3\nfix move free nve/sphere\nrun 3000 post no");
  EXPECT_NEAR((v(1)[1] - v(3)[1]) / vn, e, 1.0e-3);
}

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
