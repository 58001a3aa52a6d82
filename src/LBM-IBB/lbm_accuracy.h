// SPDX-License-Identifier: GPL-2.0-only
// How wrong a result is to be expected, by cells per radius: a table of what was measured.
//
// The table is text, a line "quantity r_over_dx error" each; # begins a comment. Errors are
// fractions. A quantity may be followed by the fraction of solid it was measured at, as in
// drag@0.125: between fractions the logarithm of the error is interpolated, beyond them it stays.

#ifndef LBM_ACCURACY_H
#define LBM_ACCURACY_H

#include <map>
#include <string>

namespace lbm {

class Accuracy {
 public:
  // a line of the file; returns what is wrong with it, or ""
  std::string read(const std::string &line);

  bool empty() const { return quantities_.empty(); }
  bool knows(const std::string &quantity) const { return quantities_.count(quantity) > 0; }
  std::string quantities() const;    // their names, for messages
  // all of them in per cent, from the loosest to the densest bed known
  std::string errors(double r) const;

  // at so many cells per radius: between rows a power law, beyond them second order. The quantity
  // must be known.
  double error(const std::string &quantity, double r, double fraction) const;
  // fewest cells per radius from which on the error stays below
  double radius(const std::string &quantity, double error, double fraction) const;

 private:
  using Rows = std::map<double, double>;                        // error by cells per radius
  std::map<std::string, std::map<double, Rows>> quantities_;    // by fraction
  static double at(const Rows &rows, double r);
};

}    // namespace lbm
#endif
