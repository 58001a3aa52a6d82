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
// rigid grains.

#include "contact_scenes.h"

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
