// SPDX-License-Identifier: GPL-2.0-only
// The state of the fluid on file, the same whatever the number of ranks:
//
//     StateHeader | spheres of the last step, by id | populations, node after node, x fastest
//
// Written aside and renamed when it is complete. All functions are collective, and what they return
// is the same on all ranks.

#ifndef LBM_STATE_FILE_H
#define LBM_STATE_FILE_H

#include "lbm_state_mpi.h"

#include <string>

namespace lbm {

struct StateHeader {
  char magic[8];    // of this form and version
  std::int32_t byte_order;
  std::int32_t nodes[3];    // of the whole lattice
  std::int32_t directions, bytes_of_population;
  std::int64_t step;    // by the clock of the caller
  std::int64_t spheres;
  std::uint64_t checksum;      // of spheres and populations
  double links, gaps;          // of the last step
  std::int64_t refilled[3];    // so far
  double ledger[Ledger::SIZE];
  MeanDensity mean;
};

StateHeader describe(const Fluid &fluid, const Int3 &nodes, std::int64_t step, MPI_Comm comm);

// returns why it could not be written, "" if it was
std::string write_state(const std::string &file, const Fluid &fluid, const StateHeader &header,
                        MPI_Comm comm);

// Into a fluid that has made no step. Returns why the file is not that which belongs to this
// header, or cannot be read; "" if all is well.
std::string read_state(const std::string &file, Fluid &fluid, const StateHeader &header,
                       MPI_Comm comm);

}    // namespace lbm
#endif
