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

// Hostile input: commands of the package, right ones to begin with, and what a tired, hurried or
// malicious user makes of them. The n-th input depends on the seed and n alone.

#ifndef LBMIBB_HOSTILE_INPUT_H
#define LBMIBB_HOSTILE_INPUT_H

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace hostile {

using Words = std::vector<std::string>;

// variables of a scene: right, wrong from the start, and wrong from the third step on
inline const char *const VARIABLES = "\nvariable fine equal 1e-3*step"
                                     "\nvariable zero equal 0"
                                     "\nvariable nan equal exp(800)-exp(800)"
                                     "\nvariable inf equal exp(800)"
                                     "\nvariable huge equal 1e300"
                                     "\nvariable latenan equal exp(800*(step>1))-exp(800*(step>1))"
                                     "\nvariable lateinf equal exp(800*(step>1))"
                                     "\nvariable latehuge equal 1e200*(step>1)"
                                     "\nvariable div equal 1/(step-2)"
                                     "\nvariable root equal sqrt(1-step)"
                                     "\nvariable self equal v_self+1"
                                     "\nvariable syntax equal 1+*2"
                                     "\nvariable empty equal \"\""
                                     "\nvariable missing equal v_nowhere"
                                     "\nvariable nofix equal f_nowhere[3]"
                                     "\nvariable nocompute equal c_nowhere"
                                     "\nvariable own equal f_w"
                                     "\nvariable ownmach equal 1e-3*f_w[3]"
                                     "\nvariable ownfar equal f_w[99]"
                                     "\nvariable peratom atom x"
                                     "\nvariable text string 5"
                                     "\nvariable loop loop 3"
                                     "\nvariable list index 1 2 3"
                                     "\nvariable thermo equal temp"
                                     "\nvariable dt equal dt";
inline const Words NAMES = {"fine",    "zero",     "nan",   "inf",       "huge", "latenan",
                            "lateinf", "latehuge", "div",   "root",      "self", "syntax",
                            "empty",   "missing",  "nofix", "nocompute", "own",  "ownmach",
                            "ownfar",  "peratom",  "text",  "loop",      "list", "thermo",
                            "dt",      "nowhere",  ""};

inline const Words KEYWORDS = {"dx",          "nu",
                               "rho",         "every",
                               "collision",   "bgk",
                               "trt",         "precision",
                               "double",      "single",
                               "link",        "cli",
                               "bouzidi",     "halfway",
                               "refill",      "grad",
                               "equilibrium", "face",
                               "xlo",         "xhi",
                               "ylo",         "yhi",
                               "zlo",         "zhi",
                               "wall",        "pressure",
                               "velocity",    "accel",
                               "gradp",       "buoyancy",
                               "shrink",      "average",
                               "conserve",    "check",
                               "yes",         "no",
                               "offset",      "limit_damping",
                               "xplane",      "yplane",
                               "zplane",      "shear",
                               "wiggle",      "x",
                               "y",           "z",
                               "NULL",        "file",
                               "quartz",      "quartz_sand.lsd",
                               "hostile.lsd", "layers",
                               "width",       "gravity",
                               "critical",    "all",
                               "nobody",      "w",
                               "*",           "1*2",
                               "0*9",         "2*1"};

// words that are no numbers, or none that serve
inline const Words STRANGE = {"0",
                              "-0",
                              "-1",
                              "1",
                              "2",
                              "3",
                              "1e-300",
                              "1e300",
                              "-1e300",
                              "4.9e-324",
                              "1e308",
                              "1e400",
                              "-1e400",
                              "nan",
                              "NaN",
                              "-nan",
                              "NAN",
                              "inf",
                              "-inf",
                              "+inf",
                              "Infinity",
                              "INF",
                              "0x10",
                              "1e",
                              "1e+",
                              "--1",
                              "+5",
                              "1.5.2",
                              "1,5",
                              "1d-3",
                              "1.5",
                              "2147483647",
                              "2147483648",
                              "-2147483648",
                              "4294967296",
                              "9223372036854775807",
                              "9223372036854775808",
                              "1e10",
                              "00001",
                              ".",
                              "-",
                              "+",
                              "e",
                              "\"\"",
                              "''",
                              "\"a b\"",
                              "\" \"",
                              "NULL",
                              "true",
                              "false",
                              "on",
                              "off",
                              "YES",
                              "v_",
                              "c_",
                              "f_",
                              "v_fine[1]",
                              "v_fine 1",
                              "f_w",
                              "c_p",
                              "$",
                              "$x",
                              "${nowhere}",
                              "$(1/0)",
                              "$(v_fine)",
                              "#",
                              "#x",
                              "%s%s%n",
                              "%d",
                              "{}",
                              "{0}",
                              "{:d}",
                              "{",
                              "}",
                              "\\",
                              "\\n",
                              "\t",
                              "*",
                              "/",
                              ".",
                              "..",
                              "/nowhere/file",
                              "~",
                              "\xc2\xb5",
                              "\xe6\x97\xa5\xe6\x9c\xac",
                              "\xef\xbc\x91",
                              "\xe2\x88\x92"
                              "1",
                              "1\xc2\xa0",
                              "\xff\xfe",
                              "\x01",
                              "\x7f",
                              "\xc3",
                              "\xf0\x9f\xa7\xaa"};

class Generator {
 public:
  Generator(std::uint64_t seed, std::uint64_t n) : random(seed * 1000003u + n) {}

  int below(int n) { return int(std::uniform_int_distribution<int>(0, n - 1)(random)); }
  bool once_in(int n) { return below(n) == 0; }
  const std::string &one_of(const Words &list) { return list[below(int(list.size()))]; }

  // a number of any size
  std::string number()
  {
    char text[40];
    const double exponent = std::uniform_real_distribution<double>(-9.0, 6.0)(random);
    snprintf(text, sizeof(text), "%s%.*g", once_in(4) ? "-" : "", 1 + below(4),
             once_in(20) ? std::pow(10.0, 50.0 * exponent) : std::pow(10.0, exponent));
    return text;
  }
  std::string word()
  {
    switch (below(10)) {
      case 0:
      case 1:
        return number();
      case 2:
        return "v_" + one_of(NAMES);
      case 3:
      case 4:
        return one_of(KEYWORDS);
      case 5:
        if (once_in(20)) return std::string(once_in(2) ? 300 : 20000, once_in(2) ? 'a' : '1');
        return noise(1 + below(12));
      default:
        return one_of(STRANGE);
    }
  }
  // bytes, but for those that end a line
  std::string noise(int length)
  {
    std::string text;
    for (int i = 0; i < length; i++) text += char(1 + below(255));
    for (char &c : text)
      if (c == '\n' || c == '\r') c = '?';
    return text;
  }

  // a right command made wrong, words from the first-th on; some stay right
  void spoil(Words &words, int first)
  {
    const int blows = below(8) == 0 ? 0 : 1 + below(3);
    for (int k = 0; k<blows &&int(words.size())> first; k++) {
      const int at = first + below(int(words.size()) - first);
      const auto place = words.begin() + at;
      switch (below(9)) {
        case 0:
          words.erase(place);
          break;
        case 1:
          words.insert(place, words[at]);
          break;
        case 2:
          words.resize(at);
          break;
        case 3:
          words.insert(place, word());
          break;
        case 4:
          std::swap(words[at], words[first + below(int(words.size()) - first)]);
          break;
        case 5: {    // the end once more
          const Words end(place, words.end());
          words.insert(words.end(), end.begin(), end.end());
          break;
        }
        default:
          words[at] = word();
      }
    }
  }

  // bytes flipped, cut off, doubled, numbers blown up: of a file
  std::string spoiled(std::string text)
  {
    for (int k = 1 + below(4); k > 0 && !text.empty(); k--) {
      const std::size_t at = std::size_t(below(int(text.size())));
      switch (below(8)) {
        case 0:
        case 1:
          text[at] = char(text[at] ^ (1 << below(8)));
          break;
        case 2:
          text.resize(at);
          break;
        case 3:
          text.insert(at, text.substr(at / 2, 1 + below(200)));
          break;
        case 4:
          text.insert(at, 1 + below(3000), once_in(2) ? ' ' : '9');
          break;
        case 5:
          text.insert(at, word());
          break;
        case 6:
          text.insert(at, 1, "\n\0\r\t#"[below(5)]);
          break;
        default: {    // in place of a number
          const std::size_t digit = text.find_first_of("0123456789", at);
          if (digit != std::string::npos) text.replace(digit, 1, word());
        }
      }
    }
    return text;
  }

 private:
  std::mt19937_64 random;
};

inline std::string line(const Words &words)
{
  std::string text;
  for (const std::string &word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

inline Words split(const std::string &text)
{
  Words words;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(' ', at)) != std::string::npos) {
    const std::size_t end = text.find(' ', at);
    words.push_back(text.substr(at, end - at));
    at = end == std::string::npos ? text.size() : end;
  }
  return words;
}

}    // namespace hostile
#endif
