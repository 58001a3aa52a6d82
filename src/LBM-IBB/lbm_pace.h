// SPDX-License-Identifier: GPL-2.0-only
// How fast this machine is: a fluid like the one that is planned, run for two tenths of a second
// on every rank at once.

#ifndef LBM_PACE_H
#define LBM_PACE_H

#include "lbm_block.h"
#include "lbm_neighbours.h"

namespace lbm {

// Links that a sphere cuts: by Cauchy's projection formula, direction e meets the surface S of a
// convex body S |e|/4 times, the rim of a flat one |e|/pi times its length.
double links_of_sphere(double r, int dimension);

// what is to be measured: the share of one rank
struct PaceSample {
  int dimension = 3;
  bool single = false;
  double tau = 0.8;
  Int3 n{};                 // nodes of a rank
  double radius = 0.0;      // cells; 0: no grains
  double fraction = 0.0;    // of solid where the grains are
  bool moving = true;       // links are then found in every step
};

// seconds of a rank while all of them work
struct Pace {
  double node = 0.0;    // of a step, by node of the lattice, messages included
  double link =
      0.0;    // more by cut link: cover, links, refilling, less solid nodes left out: may be < 0
  double bytes = 0.0;    // by node in memory, ghosts counted as nodes
};

// Blocks of all ranks stacked along the last dimension, rank 0 lowest. Collective; throws as
// Fluid::create().
Pace measure_pace(const PaceSample &sample, int rank, int ranks, Neighbours &neighbours);

}    // namespace lbm
#endif
