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

// Helper of the tests that drive the LAMMPS library: one LAMMPS a test, quiet,
// fed with lines of an input script.

#ifndef LBMIBB_LAMMPS_FIXTURE_H
#define LBMIBB_LAMMPS_FIXTURE_H

#include "atom.h"
#include "error.h"
#include "exceptions.h"
#include "input.h"
#include "lammps.h"
#include "library.h"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

class LammpsTest : public ::testing::Test {
 protected:
  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp;

  void SetUp() override { start(); }

  // a fresh LAMMPS, e.g. to run several scenes in one test

  void start(MPI_Comm comm = MPI_COMM_WORLD)
  {
    lmp.reset();
    std::vector<std::string> words = {"test", "-log", "none", "-screen", "none", "-nocite"};
    std::vector<char *> args;
    for (auto &word : words) args.push_back(&word[0]);
    lmp = std::make_unique<LAMMPS_NS::LAMMPS>((int) args.size(), args.data(), comm);
  }

  // all lines of a piece of script; throws what LAMMPS throws

  void script(const std::string &text)
  {
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) lmp->input->one(line);
  }

  // the message of the error that a piece of script runs into, "" if none

  std::string error_of(const std::string &text)
  {
    try {
      script(text);
    } catch (LAMMPS_NS::LAMMPSException &except) {
      return except.what();
    }
    return "";
  }

  int warnings() const { return lmp->error->get_numwarn(); }

  // index of an own atom by its ID; one rank only

  int index(int id) const
  {
    const auto *atom = lmp->atom;
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->tag[i] == id) return i;
    throw std::out_of_range("no atom " + std::to_string(id));
  }

  double *x(int id) const { return lmp->atom->x[index(id)]; }
  double *v(int id) const { return lmp->atom->v[index(id)]; }
  double *f(int id) const { return lmp->atom->f[index(id)]; }
  double *omega(int id) const { return lmp->atom->omega[index(id)]; }
  double *torque(int id) const { return lmp->atom->torque[index(id)]; }
  double mass(int id) const { return lmp->atom->rmass[index(id)]; }
  double radius(int id) const { return lmp->atom->radius[index(id)]; }

  // value of a thermo keyword, e.g. "ke" or "f_ID[3]", by way of a variable

  double thermo(const std::string &expression)
  {
    script("variable lbmibb_test delete\nvariable lbmibb_test equal " + expression);
    double *value = (double *) lammps_extract_variable(lmp.get(), "lbmibb_test", nullptr);
    if (!value) throw std::runtime_error("LAMMPS cannot evaluate " + expression);
    const double result = *value;
    lammps_free(value);
    return result;
  }
};

#define EXPECT_ERROR(text, piece)                                            \
  do {                                                                       \
    const std::string message = error_of(text);                              \
    EXPECT_NE(message, "") << "no error from: " << (text);                   \
    EXPECT_NE(message.find(piece), std::string::npos) << "got: " << message; \
  } while (0)

#endif
