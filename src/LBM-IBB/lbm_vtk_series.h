// SPDX-License-Identifier: GPL-2.0-only
// The list of the files of a series with their times, NAME.pvd, which ParaView opens as one. Written
// anew, aside and renamed, with every file: whatever stops a run, the list is whole, and so is every
// file it names. For one rank.

#ifndef LBM_VTK_SERIES_H
#define LBM_VTK_SERIES_H

#include <cstdint>
#include <string>
#include <vector>

namespace lbm {

class VtkSeries {
 public:
  // files are NAME-000001000.EXTENSION, with the step
  VtkSeries(const std::string &name, const std::string &extension);

  // go on with the list that is there, as far as this step: what is later is done again
  void resume(std::int64_t step);
  bool has(std::int64_t step) const;
  std::string file(std::int64_t step) const;
  // the file of this step is complete; returns why the list cannot be written, "" if it is
  std::string add(std::int64_t step, double time);

 private:
  struct Entry {
    std::int64_t step;
    std::string time;
  };
  std::string name_, extension_;
  std::vector<Entry> entries_;
};

}    // namespace lbm
#endif
