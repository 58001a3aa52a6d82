// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_state_file.h"

#include "lbm_mpi.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace lbm {
namespace {

  constexpr char MAGIC[8] = {'l', 'b', '/', 'i', 'b', 'b', ' ', '2'};
  constexpr std::int32_t BYTE_ORDER_MARK = 0x01020304;
  constexpr std::size_t BUFFER = std::size_t(1) << 25;    // bytes read or written at a time

  std::int64_t bytes_of_node(const StateHeader &h)
  {
    return std::int64_t(h.directions) * h.bytes_of_population;
  }
  std::int64_t start_of_nodes(const StateHeader &h)
  {
    return std::int64_t(sizeof(StateHeader)) + h.spheres * std::int64_t(sizeof(Trace));
  }
  std::int64_t bytes_of_file(const StateHeader &h)
  {
    return start_of_nodes(h) + bytes_of_node(h) * h.nodes[0] * h.nodes[1] * h.nodes[2];
  }

  std::uint64_t total(std::uint64_t mine, MPI_Comm comm)
  {
    std::uint64_t sum;
    MPI_Allreduce(&mine, &sum, 1, MPI_UINT64_T, MPI_SUM, comm);
    return sum;
  }

  // f(part, buffer): nodes of this rank in their order, as many planes at a time as fit into the
  // buffer; each rank as often as the one that needs most, at last with none
  template <class F>
  void for_each_piece(const Fluid &fluid, std::int64_t bytes, MPI_Comm comm, F &&f)
  {
    const Part mine{fluid.layout().lo, fluid.layout().n};
    const int outer = fluid.layout().ghost[2] > 0 ? 2 : 1;
    const Index plane = mine.nodes() / mine.n[outer];
    const int planes = int(std::max<std::int64_t>(1, std::int64_t(BUFFER) / (bytes * plane)));
    int rounds = (mine.n[outer] + planes - 1) / planes;
    MPI_Allreduce(MPI_IN_PLACE, &rounds, 1, MPI_INT, MPI_MAX, comm);
    std::vector<char> buffer(std::size_t(bytes * plane) * std::min(planes, mine.n[outer]));
    for (int k = 0; k < rounds; k++) {
      Part piece = mine;
      piece.lo[outer] += k * planes;
      piece.n[outer] = std::clamp(mine.n[outer] - k * planes, 0, planes);
      f(piece, buffer.data());
    }
  }

  // the nodes of this rank are what follows in the file for it
  void look_at_nodes(File &file, const Fluid &fluid, const StateHeader &h, const Type &node)
  {
    const Layout &at = fluid.layout();
    const int whole[3] = {h.nodes[2], h.nodes[1], h.nodes[0]};
    const int n[3] = {at.n[2], at.n[1], at.n[0]}, lo[3] = {at.lo[2], at.lo[1], at.lo[0]};
    MPI_Datatype block;
    MPI_Type_create_subarray(3, whole, n, lo, MPI_ORDER_C, node.handle(), &block);
    MPI_Type_commit(&block);
    file.keep(MPI_File_set_view(file.handle(), start_of_nodes(h), node.handle(), block, "native",
                                MPI_INFO_NULL));
    MPI_Type_free(&block);
  }

  // every member is of 4 or 8 bytes and in its place: no bytes lie between them
  std::string_view bytes_of(const StateHeader &header)
  {
    static_assert(sizeof(StateHeader) == 8 + 6 * 4 + (8 + Ledger::SIZE + 3) * 8);
    return {reinterpret_cast<const char *>(&header), sizeof header};
  }

  // why a header is not the expected one
  std::string difference(const StateHeader &found, const StateHeader &expected)
  {
    const auto number = [](std::int64_t n) {
      return std::to_string(n);
    };
    if (std::memcmp(found.magic, MAGIC, 7) != 0) return "it is no file of a fluid";
    if (found.magic[7] != MAGIC[7])
      return std::string("its form is version ") + found.magic[7] + ", not " + MAGIC[7];
    if (found.byte_order != BYTE_ORDER_MARK) return "it was written with another order of bytes";
    if (found.step != expected.step)
      return "it is of step " + number(found.step) + ", the grains are of step " +
          number(expected.step) + ": the two files were not written together";
    for (int d = 0; d < 3; d++)
      if (found.nodes[d] != expected.nodes[d])
        return "it has " + number(found.nodes[d]) + " nodes along " + "xyz"[d] + ", not " +
            number(expected.nodes[d]);
    if (found.directions != expected.directions ||
        found.bytes_of_population != expected.bytes_of_population)
      return "it has " + number(found.directions) + " populations of " +
          number(found.bytes_of_population) + " bytes a node, not " + number(expected.directions) +
          " of " + number(expected.bytes_of_population);
    if (found.checksum != expected.checksum || found.spheres != expected.spheres)
      return "its checksum is not that which the restart file names: it is of another run, or "
             "damaged";
    if (bytes_of(found) != bytes_of(expected)) return "its head is damaged";
    return "";
  }

}    // namespace

StateHeader describe(const Fluid &fluid, const Int3 &nodes, std::int64_t step, MPI_Comm comm)
{
  StateHeader h{};
  std::memcpy(h.magic, MAGIC, sizeof h.magic);
  h.byte_order = BYTE_ORDER_MARK;
  std::copy(nodes.begin(), nodes.end(), h.nodes);
  h.directions = fluid.directions();
  h.bytes_of_population = fluid.bytes_of_population();
  h.step = step;
  const auto grains = fluid.own_spheres();
  std::uint64_t check = fluid.checksum();
  for (const Sphere &s : grains) check += checksum(s);
  h.checksum = total(check, comm);
  const RefillCount &r = fluid.refilled();
  std::int64_t counts[4] = {std::int64_t(grains.size()), r.grad, r.equilibrium, r.deep};
  double last[2] = {fluid.links(), fluid.gaps()};
  MPI_Allreduce(MPI_IN_PLACE, counts, 4, MPI_INT64_T, MPI_SUM, comm);
  MPI_Allreduce(MPI_IN_PLACE, last, 2, MPI_DOUBLE, MPI_SUM, comm);
  h.spheres = counts[0];
  std::copy_n(counts + 1, 3, h.refilled);
  h.links = last[0];
  h.gaps = last[1];
  const auto ledger = fluid.ledger().numbers();
  std::copy(ledger.begin(), ledger.end(), h.ledger);
  h.mean = fluid.mean_density();
  return h;
}

std::string write_state(const std::string &name, const Fluid &fluid, const StateHeader &h,
                        MPI_Comm comm)
{
  const auto spheres = all_spheres(fluid, comm);
  const std::vector<Trace> grains(spheres.begin(), spheres.end());
  int me;
  MPI_Comm_rank(comm, &me);
  NewFile file(name, comm);
  const std::string why = file.error();
  if (!why.empty()) return "cannot open " + name + ".part: " + why;
  if (me == 0) {
    file.write(0, &h, sizeof h);
    file.write(sizeof h, grains.data(), std::int64_t(sizeof(Trace)) * h.spheres);
  }
  const std::int64_t bytes = bytes_of_node(h);
  const Type node{int(bytes)};
  look_at_nodes(file, fluid, h, node);
  for_each_piece(fluid, bytes, comm, [&](const Part &piece, char *buffer) {
    fluid.give(piece, buffer);
    MPI_Status status;
    const int code =
        MPI_File_write_all(file.handle(), buffer, int(piece.nodes()), node.handle(), &status);
    file.keep(code, status, bytes * piece.nodes());
  });
  return file.finish(bytes_of_file(h));
}

std::string read_state(const std::string &name, Fluid &fluid, const StateHeader &h, MPI_Comm comm)
{
  int me;
  MPI_Comm_rank(comm, &me);
  File file(name, MPI_MODE_RDONLY, comm);
  std::string why = file.error();
  if (!why.empty()) return why;
  const std::int64_t size = file.size();
  if (size < std::int64_t(sizeof h))
    return "it is truncated: " + std::to_string(size) + " bytes, less than its head";
  StateHeader found{};
  MPI_Status status;
  int code = MPI_File_read_at_all(file.handle(), 0, &found, sizeof found, MPI_BYTE, &status);
  file.keep(code, status, sizeof found);
  why = file.error();
  if (why.empty()) why = difference(found, h);
  if (!why.empty()) return why;
  if (size != bytes_of_file(h))
    return (size < bytes_of_file(h) ? "it is truncated: " : "it is too long: ") +
        std::to_string(size) + " bytes instead of " + std::to_string(bytes_of_file(h));

  std::vector<Trace> traces(h.spheres);
  const Type sphere(sizeof(Trace));
  code = MPI_File_read_at_all(file.handle(), sizeof h, traces.data(), int(traces.size()),
                              sphere.handle(), &status);
  file.keep(code, status, std::int64_t(sizeof(Trace)) * h.spheres);

  std::vector<Sphere> grains;
  grains.reserve(traces.size());
  for (const Trace &trace : traces) grains.push_back(trace.sphere());

  const std::int64_t bytes = bytes_of_node(h);
  const Type node{int(bytes)};
  look_at_nodes(file, fluid, h, node);
  for_each_piece(fluid, bytes, comm, [&](const Part &piece, char *buffer) {
    code = MPI_File_read_all(file.handle(), buffer, int(piece.nodes()), node.handle(), &status);
    file.keep(code, status, bytes * piece.nodes());
    fluid.take(piece, buffer);
  });
  why = file.error();
  if (!why.empty()) return why;
  std::uint64_t check = fluid.checksum();
  if (me == 0)
    for (const Sphere &s : grains) check += checksum(s);
  if (total(check, comm) != h.checksum) return "it is damaged: its checksum is wrong";

  Counts counts;    // sums, which the first rank keeps, and what all ranks know
  if (me == 0) counts = {h.links, h.gaps, {h.refilled[0], h.refilled[1], h.refilled[2]}, {}, {}};
  counts.ledger.add(h.ledger);
  counts.mean = h.mean;
  fluid.resume(grains, counts);
  return "";
}

}    // namespace lbm
