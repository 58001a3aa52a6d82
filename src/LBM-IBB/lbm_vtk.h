// SPDX-License-Identifier: GPL-2.0-only
// Files in VTK's XML formats ("VTK XML file formats", VTK's documentation), written by all ranks
// together: one file, one piece, so that every reader takes it. Data are binary:
//
//   ZLIB     appended: blocks of tuples, each compressed by the rank that has it
//   RAW      appended as they are
//   BASE64   in the text, for readers that know neither of these, as OVITO; from the first rank alone

#ifndef LBM_VTK_H
#define LBM_VTK_H

#include "lbm_block.h"
#include "lbm_mpi.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lbm {

enum class VtkEncoding { ZLIB, RAW, BASE64 };
bool vtk_has_zlib();    // was it there when this was compiled?

// Tuples compressed as one block: every rank, but the last that has any, has a multiple of it.
inline constexpr int VTK_BLOCK = 8192;

// What this rank has of it follows what the ranks before it have.
struct VtkArray {
  enum Type { FLOAT32, FLOAT64, INT64 };
  std::string name;
  Type type;
  int components;
  std::vector<char> bytes;
};
VtkArray vtk_array(const std::string &name, int components, const std::vector<float> &values);
VtkArray vtk_array(const std::string &name, int components, const std::vector<double> &values);
VtkArray vtk_array(const std::string &name, int components, const std::vector<std::int64_t> &);

struct VtkFile {
  struct Section {
    std::string name;    // PointData, Points, Verts
    std::vector<VtkArray> arrays;
  };
  std::string type;            // ImageData or PolyData
  std::string whole, piece;    // attributes of these elements
  double time;
  std::vector<Section> sections;
};

// so many nodes on a lattice, values at nodes; the arrays are to be filled in
VtkFile vtk_image(const Int3 &n, const Vec3 &origin, const Vec3 &spacing, double time);
// points, each a cell of its own; all on the first rank
VtkFile vtk_points(const std::vector<double> &places, double time);

// Collective. Returns why it could not be written, "" if it was.
std::string write_vtk(const std::string &name, const VtkFile &file, VtkEncoding encoding,
                      MPI_Comm comm);

}    // namespace lbm
#endif
