/* -*- c++ -*- ----------------------------------------------------------
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

// A reader of VTK's XML files, written from the description of the format, not from what writes them.

#ifndef LBMIBB_VTK_FILE_H
#define LBMIBB_VTK_FILE_H

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#if __has_include(<zlib.h>)
#include <zlib.h>
#endif

class VtkReader {
 public:
  explicit VtkReader(const std::string &name) : all(text_of(name))
  {
    if (all.empty()) throw std::runtime_error("no file " + name);
  }

  static std::string text_of(const std::string &name)
  {
    std::ifstream file(name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  // value of an attribute of the first element of that name
  std::string attribute(const std::string &element, const std::string &name) const
  {
    return attribute_of(tag("<" + element), name);
  }
  std::vector<double> numbers(const std::string &element, const std::string &name) const
  {
    std::istringstream in(attribute(element, name));
    std::vector<double> values;
    for (double value; in >> value;) values.push_back(value);
    return values;
  }
  double time() const
  {
    const auto at = all.find("Name=\"TimeValue\"");
    return std::stod(all.substr(all.find('>', at) + 1));
  }

  // numbers of a data array
  std::vector<double> array(const std::string &name) const
  {
    const std::string head = tag("Name=\"" + name + "\"", "<DataArray");
    const std::string bytes = decoded(head), type = attribute_of(head, "type");
    if (type == "Float32") return as<float>(bytes);
    if (type == "Float64") return as<double>(bytes);
    if (type == "Int64") return as<std::int64_t>(bytes);
    throw std::runtime_error("type " + type);
  }

 private:
  using Number = std::uint64_t;
  std::string all;

  // the tag that contains this text
  std::string tag(const std::string &text, const std::string &start = "<") const
  {
    const auto at = all.find(text);
    if (at == std::string::npos) throw std::runtime_error("no " + text);
    const auto begin = all.rfind(start, at);
    return all.substr(begin, all.find('>', begin) + 1 - begin);
  }
  static std::string attribute_of(const std::string &tag, const std::string &name)
  {
    const auto at = tag.find(" " + name + "=\"");
    if (at == std::string::npos) return "";
    const auto begin = at + name.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  template <class T> static std::vector<double> as(const std::string &bytes)
  {
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return {values.begin(), values.end()};
  }
  static Number number(const std::string &bytes, std::size_t at)
  {
    if (at + sizeof(Number) > bytes.size()) throw std::runtime_error("truncated");
    Number n;
    std::memcpy(&n, &bytes[at], sizeof n);
    return n;
  }

  std::string decoded(const std::string &head) const
  {
    if (attribute("VTKFile", "byte_order") != "LittleEndian" ||
        attribute("VTKFile", "header_type") != "UInt64")
      throw std::runtime_error("not of this machine");
    const std::string format = attribute_of(head, "format");
    if (format == "binary") {
      const auto begin = all.find(head) + head.size();
      const std::string bytes = from_base64(all.substr(begin, all.find('<', begin) - begin));
      if (bytes.size() != sizeof(Number) + number(bytes, 0)) throw std::runtime_error("length");
      return bytes.substr(sizeof(Number));
    }
    if (format != "appended") throw std::runtime_error("format " + format);
    const auto underscore = all.find('_', all.find("<AppendedData encoding=\"raw\">"));
    const std::size_t at = underscore + 1 + std::stoull(attribute_of(head, "offset"));
    if (attribute("VTKFile", "compressor").empty())
      return all.substr(at + sizeof(Number), number(all, at));
    return inflated(at);
  }

  // [blocks][bytes of a block][bytes of the last, 0 if full][compressed bytes]... data
  std::string inflated(std::size_t at) const
  {
    const Number blocks = number(all, at), block = number(all, at + 8), last = number(all, at + 16);
    std::size_t data = at + 8 * (3 + blocks);
    std::string bytes;
    for (Number b = 0; b < blocks; b++) {
      const Number size = number(all, at + 8 * (3 + b));
      std::string one(b + 1 == blocks && last ? last : block, '\0');
#if __has_include(<zlib.h>)
      uLongf got = one.size();
      if (uncompress((Bytef *) &one[0], &got, (const Bytef *) &all[data], size) != Z_OK ||
          got != one.size())
        throw std::runtime_error("zlib");
#endif
      bytes += one;
      data += size;
    }
    return bytes;
  }

  static std::string from_base64(const std::string &text)
  {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int have = 0;
    for (char c : text) {
      const auto digit = digits.find(c);
      if (digit == std::string::npos) break;
      bits = bits << 6 | unsigned(digit);
      have += 6;
      if (have >= 8) {
        have -= 8;
        bytes += char(bits >> have & 255);
      }
    }
    return bytes;
  }
};

#endif
