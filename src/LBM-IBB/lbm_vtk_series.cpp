// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_vtk_series.h"

#include "lbm_mpi.h"

#include <cstdlib>
#include <fstream>

namespace lbm {
namespace {

  // what is between the marks
  std::string between(const std::string &line, const std::string &before, const std::string &after)
  {
    const auto at = line.find(before);
    if (at == std::string::npos) return "";
    const auto start = at + before.size(), end = line.find(after, start);
    return end == std::string::npos ? "" : line.substr(start, end - start);
  }

}    // namespace

VtkSeries::VtkSeries(const std::string &name, const std::string &extension) :
    name_(name), extension_(extension)
{
}

std::string VtkSeries::file(std::int64_t step) const
{
  char digits[32];
  std::snprintf(digits, sizeof digits, "%09lld", static_cast<long long>(step));
  return name_ + "-" + digits + "." + extension_;
}

void VtkSeries::resume(std::int64_t step)
{
  const std::string stem = name_.substr(name_.rfind('/') + 1);
  entries_.clear();
  std::ifstream list(name_ + ".pvd");
  for (std::string line; std::getline(list, line);) {
    const std::string digits = between(line, "file=\"" + stem + "-", "." + extension_ + "\"");
    const std::string time = between(line, "timestep=\"", "\"");
    if (digits.empty() || time.empty()) continue;
    const std::int64_t then = std::atoll(digits.c_str());
    if (then <= step && std::ifstream(file(then))) entries_.push_back({then, time});
  }
}

bool VtkSeries::has(std::int64_t step) const
{
  return !entries_.empty() && entries_.back().step >= step;
}

std::string VtkSeries::add(std::int64_t step, double time)
{
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.12g", time);
  entries_.push_back({step, digits});
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
                     "<Collection>\n";
  for (const Entry &entry : entries_) {
    const std::string path = file(entry.step);    // beside the list
    text += "<DataSet timestep=\"" + entry.time + "\" part=\"0\" file=\"" +
        path.substr(path.rfind('/') + 1) + "\"/>\n";
  }
  text += "</Collection>\n</VTKFile>\n";
  const auto bytes = std::int64_t(text.size());
  NewFile list(name_ + ".pvd", MPI_COMM_SELF);
  const std::string why = list.error();
  if (!why.empty()) return "cannot open " + name_ + ".pvd.part: " + why;
  list.write(0, text.data(), bytes);
  return list.finish(bytes);
}

}    // namespace lbm
