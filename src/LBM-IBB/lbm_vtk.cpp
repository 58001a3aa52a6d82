// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_vtk.h"

#include <algorithm>
#include <cstring>

#ifdef LBMIBB_ZLIB
#include <zlib.h>
#endif

namespace lbm {
namespace {

  using Number = std::uint64_t;    // of the headers, header_type="UInt64"

  constexpr const char *TYPE[] = {"Float32", "Float64", "Int64"};
  constexpr int WIDTH[] = {4, 8, 8};

  template <class T>
  VtkArray filled(const std::string &name, VtkArray::Type type, int components,
                  const std::vector<T> &values)
  {
    const char *from = reinterpret_cast<const char *>(values.data());
    return {name, type, components, {from, from + values.size() * sizeof(T)}};
  }

  std::string number(double value)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%.16g", value);
    return text;
  }
  std::string numbers(const Vec3 &v)
  {
    return number(v[0]) + " " + number(v[1]) + " " + number(v[2]);
  }

  std::string attribute(const std::string &name, const std::string &value)
  {
    return " " + name + "=\"" + value + "\"";
  }

  Number total(Number mine, MPI_Comm comm)
  {
    MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, MPI_SUM, comm);
    return mine;
  }

  // An array as it is in the file: its header, on the first rank, and what this rank has of it.
  struct Appended {
    std::vector<Number> header;
    std::vector<char> data;
    Number header_bytes = 0, before = 0, data_bytes = 0;    // before: of the ranks before this one
    Number bytes() const { return header_bytes + data_bytes; }
  };

  // blocks of this rank, one after the other
  std::vector<char> compressed(const VtkArray &array, std::size_t block, std::vector<Number> &sizes)
  {
    std::vector<char> all;
#ifdef LBMIBB_ZLIB
    std::vector<char> one(compressBound(uLong(block)));
    for (std::size_t at = 0; at < array.bytes.size(); at += block) {
      uLongf size = uLongf(one.size());
      compress2(reinterpret_cast<Bytef *>(one.data()), &size,
                reinterpret_cast<const Bytef *>(&array.bytes[at]),
                uLong(std::min(block, array.bytes.size() - at)), Z_BEST_SPEED);
      sizes.push_back(size);
      all.insert(all.end(), one.begin(), one.begin() + std::ptrdiff_t(size));
    }
#else
    (void) array;
    (void) block;
    (void) sizes;
#endif
    return all;
  }

  // number of blocks | bytes of a block | bytes of the last one if it is not full | compressed sizes
  std::vector<Number> block_header(const std::vector<Number> &mine, Number block, Number bytes,
                                   MPI_Comm comm)
  {
    int ranks;
    MPI_Comm_size(comm, &ranks);
    std::vector<int> count(ranks), first(ranks, 3);
    const int n = int(mine.size());
    MPI_Gather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, 0, comm);
    for (int r = 1; r < ranks; r++) first[r] = first[r - 1] + count[r - 1];
    std::vector<Number> header(first.back() + count.back());
    MPI_Gatherv(mine.data(), n, MPI_UINT64_T, header.data(), count.data(), first.data(),
                MPI_UINT64_T, 0, comm);
    header[0] = header.size() - 3;
    header[1] = block;
    header[2] = bytes % block;
    return header;
  }

  Appended encoded(const VtkArray &array, VtkEncoding encoding, MPI_Comm comm)
  {
    Appended a;
    const Number bytes = total(array.bytes.size(), comm);
    if (encoding == VtkEncoding::ZLIB) {
      const std::size_t block = std::size_t(VTK_BLOCK) * array.components * WIDTH[array.type];
      std::vector<Number> sizes;
      a.data = compressed(array, block, sizes);
      a.header = block_header(sizes, block, bytes, comm);
      a.header_bytes = sizeof(Number) * (3 + total(sizes.size(), comm));
    } else {
      a.data = array.bytes;
      a.header = {bytes};
      a.header_bytes = sizeof(Number);
    }
    const Number mine = a.data.size();
    MPI_Exscan(&mine, &a.before, 1, MPI_UINT64_T, MPI_SUM, comm);
    a.data_bytes = total(mine, comm);
    return a;
  }

  std::string base64(const Appended &a)
  {
    constexpr char DIGIT[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string from(reinterpret_cast<const char *>(a.header.data()), a.header_bytes);
    from.append(a.data.begin(), a.data.end());
    const std::size_t missing = (3 - from.size() % 3) % 3;
    from.append(missing, '\0');
    std::string text;
    text.reserve(from.size() / 3 * 4);
    for (std::size_t i = 0; i < from.size(); i += 3) {
      unsigned bits = 0;
      for (std::size_t k = 0; k < 3; k++)
        bits = bits << 8 | static_cast<unsigned char>(from[i + k]);
      for (int shift = 18; shift >= 0; shift -= 6) text += DIGIT[bits >> shift & 63];
    }
    std::fill(text.end() - std::ptrdiff_t(missing), text.end(), '=');
    return text;
  }

  // the text before the data; arrays in the order of the sections
  std::string head(const VtkFile &file, const std::vector<Appended> &arrays, VtkEncoding encoding)
  {
    const std::uint16_t one = 1;
    char low;
    std::memcpy(&low, &one, 1);
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile" + attribute("type", file.type) +
        attribute("version", "1.0") + attribute("byte_order", low ? "LittleEndian" : "BigEndian") +
        attribute("header_type", "UInt64");
    if (encoding == VtkEncoding::ZLIB) text += attribute("compressor", "vtkZLibDataCompressor");
    text += ">\n<" + file.type + file.whole + ">\n<Piece" + file.piece + ">\n";
    Number offset = 0;
    auto a = arrays.begin();
    for (const auto &section : file.sections) {
      text += "<" + section.name + ">\n";
      for (const VtkArray &array : section.arrays) {
        text += "<DataArray" + attribute("type", TYPE[array.type]) + attribute("Name", array.name) +
            attribute("NumberOfComponents", std::to_string(array.components));
        if (encoding == VtkEncoding::BASE64)
          text += attribute("format", "binary") + ">" + base64(*a) + "</DataArray>\n";
        else
          text += attribute("format", "appended") + attribute("offset", std::to_string(offset)) +
              "/>\n";
        offset += a++->bytes();
      }
      text += "</" + section.name + ">\n";
    }
    // behind the piece: OVITO's reader of grains does not find one that comes after it
    text += "</Piece>\n<FieldData><DataArray" + attribute("type", "Float64") +
        attribute("Name", "TimeValue") + attribute("NumberOfTuples", "1") +
        attribute("format", "ascii") + ">" + number(file.time) + "</DataArray></FieldData>\n</" +
        file.type + ">\n";
    return encoding == VtkEncoding::BASE64 ? text + "</VTKFile>\n"
                                           : text + "<AppendedData encoding=\"raw\">\n_";
  }

}    // namespace

bool vtk_has_zlib()
{
#ifdef LBMIBB_ZLIB
  return true;
#else
  return false;
#endif
}

VtkArray vtk_array(const std::string &name, int components, const std::vector<float> &values)
{
  return filled(name, VtkArray::FLOAT32, components, values);
}
VtkArray vtk_array(const std::string &name, int components, const std::vector<double> &values)
{
  return filled(name, VtkArray::FLOAT64, components, values);
}
VtkArray vtk_array(const std::string &name, int components, const std::vector<std::int64_t> &values)
{
  return filled(name, VtkArray::INT64, components, values);
}

VtkFile vtk_image(const Int3 &n, const Vec3 &origin, const Vec3 &spacing, double time)
{
  std::string extent;
  for (int d = 0; d < 3; d++) extent += (d ? " 0 " : "0 ") + std::to_string(n[d] - 1);
  VtkFile file{"ImageData", "", attribute("Extent", extent), time, {{"PointData", {}}}};
  file.whole = attribute("WholeExtent", extent) + attribute("Origin", numbers(origin)) +
      attribute("Spacing", numbers(spacing));
  return file;
}

VtkFile vtk_points(const std::vector<double> &places, double time)
{
  const std::size_t n = places.size() / 3;
  std::vector<std::int64_t> connectivity(n), offsets(n);
  for (std::size_t i = 0; i < n; i++) {
    connectivity[i] = std::int64_t(i);
    offsets[i] = std::int64_t(i + 1);
  }
  VtkFile file{"PolyData", "", "", time, {}};
  file.piece = attribute("NumberOfPoints", std::to_string(n)) +
      attribute("NumberOfVerts", std::to_string(n)) + attribute("NumberOfLines", "0") +
      attribute("NumberOfStrips", "0") + attribute("NumberOfPolys", "0");
  file.sections = {
      {"PointData", {}},
      {"Points", {vtk_array("points", 3, places)}},
      {"Verts", {vtk_array("connectivity", 1, connectivity), vtk_array("offsets", 1, offsets)}}};
  return file;
}

std::string write_vtk(const std::string &name, const VtkFile &file, VtkEncoding encoding,
                      MPI_Comm comm)
{
  int me;
  MPI_Comm_rank(comm, &me);
  std::vector<Appended> arrays;
  for (const auto &section : file.sections)
    for (const VtkArray &array : section.arrays) arrays.push_back(encoded(array, encoding, comm));

  const std::string before = me == 0 ? head(file, arrays, encoding) : "";
  Number at = total(before.size(), comm);
  NewFile out(name, comm);
  const std::string why = out.error();
  if (!why.empty()) return "cannot open " + name + ".part: " + why;
  if (me == 0) out.write(0, before.data(), std::int64_t(before.size()));
  if (encoding != VtkEncoding::BASE64) {
    for (const Appended &a : arrays) {
      if (me == 0) out.write(std::int64_t(at), a.header.data(), std::int64_t(a.header_bytes));
      out.write(std::int64_t(at + a.header_bytes + a.before), a.data.data(),
                std::int64_t(a.data.size()));
      at += a.bytes();
    }
    const std::string after = "\n</AppendedData>\n</VTKFile>\n";
    if (me == 0) out.write(std::int64_t(at), after.data(), std::int64_t(after.size()));
    at += after.size();
  }
  return out.finish(std::int64_t(at));
}

}    // namespace lbm
