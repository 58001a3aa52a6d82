// SPDX-License-Identifier: GPL-2.0-only

#include "lbm_accuracy.h"

#include "lbm_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace lbm {

std::string Accuracy::read(const std::string &line)
{
  std::istringstream words(line.substr(0, line.find('#')));
  std::string quantity, rest;
  if (!(words >> quantity)) return "";
  double r = 0.0, error = 0.0, fraction = 0.0;
  const std::size_t mark = quantity.find('@');
  bool good = words >> r >> error && !(words >> rest) && r > 0.0 && error > 0.0 && error < 10.0;
  if (mark != std::string::npos) {
    std::istringstream number(quantity.substr(mark + 1));
    good = good && number >> fraction && number.eof() && fraction >= 0.0 && fraction < 1.0;
    quantity.resize(mark);
  }
  if (!good || quantity.empty())
    return "expected 'quantity[@fraction] r_over_dx error' with positive numbers, not '" + line +
        "'";
  if (!quantities_[quantity][fraction].emplace(r, error).second)
    return "'" + line + "' has a radius that is there already";
  return "";
}

std::string Accuracy::quantities() const
{
  std::string names;
  for (const auto &entry : quantities_) names += (names.empty() ? "" : ", ") + entry.first;
  return names;
}

std::string Accuracy::errors(double r) const
{
  std::string text;
  for (const auto &[name, tables] : quantities_) {
    text += print("%s%s %.2g", text.empty() ? "" : ", ", name.c_str(),
                  100.0 * at(tables.begin()->second, r));
    if (tables.size() > 1) text += print(" to %.2g", 100.0 * at(tables.rbegin()->second, r));
    text += " %";
  }
  return text;
}

double Accuracy::at(const Rows &rows, double r)
{
  const auto above = rows.lower_bound(r);
  // interpolated bounce-back is of second order: Bouzidi et al. 2001, Ginzburg et al. 2008
  auto second_order = [&](const Rows::value_type &row) {
    return row.second * (row.first / r) * (row.first / r);
  };
  if (above == rows.begin()) return second_order(*above);
  const auto below = std::prev(above);
  if (above == rows.end()) return second_order(*below);
  const double slope =
      std::log(above->second / below->second) / std::log(above->first / below->first);
  return below->second * std::pow(r / below->first, slope);
}

double Accuracy::error(const std::string &quantity, double r, double fraction) const
{
  const auto &tables = quantities_.at(quantity);
  const auto above = tables.lower_bound(fraction);
  if (above == tables.begin()) return at(above->second, r);
  const auto below = std::prev(above);
  if (above == tables.end()) return at(below->second, r);
  const double part = (fraction - below->first) / (above->first - below->first);
  return std::pow(at(below->second, r), 1.0 - part) * std::pow(at(above->second, r), part);
}

double Accuracy::radius(const std::string &quantity, double wanted, double fraction) const
{
  double last = 0.0;
  for (const auto &table : quantities_.at(quantity))
    last = std::max(last, table.second.rbegin()->first);
  // beyond the last row the error falls steadily; errors of the rows may do as they like
  double r = last * std::max(1.0, std::sqrt(error(quantity, last, fraction) / wanted));
  constexpr double FINER = 0.999, LEAST = 1e-3;
  while (r > LEAST && error(quantity, r * FINER, fraction) <= wanted) r *= FINER;
  return r;
}

}    // namespace lbm
