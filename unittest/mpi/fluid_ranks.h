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

// Scenes that are run on all ranks together, arranged in every way, and once more on every rank
// alone: to round-off they must come out the same.

#ifndef LBMIBB_FLUID_RANKS_H
#define LBMIBB_FLUID_RANKS_H

#include "../lammps/fluid_scenes.h"

#include "comm.h"

#include <map>

class FluidRanks : public FluidTest {
 protected:
  // position, velocity, spin, force and torque of the own atoms by ID; under 0 the outputs
  std::map<int, std::vector<double>> result()
  {
    std::map<int, std::vector<double>> all;
    for (int i = 0; i < lmp->atom->nlocal; i++) {
      const int id = lmp->atom->tag[i];
      auto &values = all[id];
      for (double *vec : {x(id), v(id), omega(id)}) values.insert(values.end(), vec, vec + 3);
      values.insert(values.end(), load(id), load(id) + 6);
    }
    all[0] = {mass()};
    for (int k = 1; k <= fix()->size_vector; k++)    // without the machine's speed, and rounding
      if (k != 14 && k != 28) all[0].push_back(out(k));
    return all;
  }

  // all ways to arrange so many ranks
  static std::vector<std::string> bricks()
  {
    int nprocs;
    MPI_Comm_size(MPI_COMM_WORLD, &nprocs);
    std::vector<std::string> all;
    for (int x = 1; x <= nprocs; x++)
      for (int y = 1; nprocs % x == 0 && y <= nprocs / x; y++)
        if (nprocs / x % y == 0)
          all.push_back(std::to_string(x) + " " + std::to_string(y) + " " +
                        std::to_string(nprocs / x / y));
    return all;
  }

  // scene() writes the script of a box with these extra lines
  template <class Scene> void compare(Scene &&scene)
  {
    start(MPI_COMM_SELF);
    script(scene(""));
    const auto alone = result();
    for (const std::string &brick : bricks()) {
      if (n[2] == 1 && brick.substr(brick.size() - 2) != " 1") continue;
      start(MPI_COMM_WORLD);
      script(scene("processors " + brick));
      SCOPED_TRACE(brick);
      expect_same(alone);
    }
  }

  // the present state is this one of another run, but for round-off; collective over the ranks of
  // this LAMMPS
  void expect_same(const std::map<int, std::vector<double>> &alone)
  {
    // scales of length, velocity, spin, force and torque: the largest of all grains
    std::vector<double> scale(5, 1e-300);
    for (const auto &[id, values] : alone)
      for (int k = 0; id > 0 && k < 15; k++)
        scale[k / 3] = std::max(scale[k / 3], std::fabs(values[k]));
    for (std::size_t k = OBSTACLES; k < alone.at(0).size(); k++) {
      double &size = scale[(k - OBSTACLES) % 6 < 3 ? 3 : 4];
      size = std::max(size, std::fabs(alone.at(0)[k]));
    }
    const auto together = result();
    int mine = (int) together.size() - 1, all;
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_SUM, lmp->world);
    EXPECT_EQ(all, (int) alone.size() - 1);
    for (const auto &[id, values] : together) {
      if (!alone.count(id)) {    // without leaving the others alone
        ADD_FAILURE() << "no grain " << id;
        continue;
      }
      const auto &expected = alone.at(id);
      for (std::size_t k = 0; k < values.size(); k++) {
        const double size = id > 0
            ? scale[k / 3]
            : std::max(std::fabs(expected[k]), floor_of(k, expected[0], scale));
        EXPECT_NEAR(values[k], expected[k], 1e-12 * size) << "grain " << id << " value " << k;
      }
    }
  }

  // where among the results what was gained of mass starts, and forces and torques on obstacles
  enum { LEDGER = 14, OBSTACLES = LEDGER + 15 };
  // What may cancel is compared by its size: components of forces and fluxes, outputs 6-8 and 9-11,
  // and gains by the mass of the fluid
  static double floor_of(std::size_t k, double mass, const std::vector<double> &scale)
  {
    if (k >= OBSTACLES) return (k - OBSTACLES) % 6 < 3 ? scale[3] : scale[4];
    if (k >= LEDGER) return mass;
    if (k >= 6 && k <= 8) return scale[3];
    return k >= 9 && k <= 11 ? 1e-3 : 0.0;
  }

  // grains of radius 2 to 3 cells on a lattice of 6 cells, moved off it a little
  std::string heap(const Cells &count, double speed) const
  {
    std::string text;
    unsigned int seed = 4711;
    auto uniform = [&seed]() {
      seed = 1664525u * seed + 1013904223u;
      return seed / 2147483648.0 - 1.0;
    };
    int id = 0;
    for (int k = 0; k < count[2]; k++)
      for (int j = 0; j < count[1]; j++)
        for (int i = 0; i < count[0]; i++) {
          const Triple c{6.0 * i + 3.0 + 0.3 * uniform(), 6.0 * j + 3.0 + 0.3 * uniform(),
                         6.0 * k + 3.0 + 0.3 * uniform()};
          text += grain(++id, c, 2.6 + 0.4 * uniform(),
                        {speed * uniform(), speed * uniform(), speed * uniform()});
        }
    return text;
  }
};

#endif
