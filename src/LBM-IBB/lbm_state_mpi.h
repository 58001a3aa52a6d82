// SPDX-License-Identifier: GPL-2.0-only
// The state of the fluid from one cut of the lattice to another. All functions are collective.

#ifndef LBM_STATE_MPI_H
#define LBM_STATE_MPI_H

#include "lbm_solver.h"

#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1    // the deprecated C++ bindings only bring warnings
#endif
#include <mpi.h>

namespace lbm {

// grains of the last step, on every rank alike and in an order that does not depend on the cut
std::vector<Sphere> all_spheres(const Fluid &fluid, MPI_Comm comm);

// Packs what a fluid holds, which may then be destroyed to make room for its successor. Between
// the two the populations are held once more.
class Carried {
 public:
  // to: the nodes that this rank will have
  Carried(const Fluid &from, const Part &to, MPI_Comm comm);
  void into(Fluid &fluid);

 private:
  struct Parcel {
    int rank;
    Part part;
    std::vector<char> data;
  };
  MPI_Comm comm_;
  int bytes_of_node_;
  std::vector<Parcel> out_, in_;
  std::vector<Sphere> grains_;
  Counts counts_;
};

}    // namespace lbm
#endif
