/* ----------------------------------------------------------------------
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

// Hostile input to every command of the package, in LAMMPS instances that live on: each ends in an
// error of LAMMPS's own or in a run whose numbers are numbers. A short slice here; the long part
// fuzz (fuzz.sh) has the same program read more under sanitizers, as the environment says:
//
//   LBMIBB_FUZZ_INPUTS   how many (1200)
//   LBMIBB_FUZZ_FIRST    the first of them (0): one that failed can be repeated alone
//   LBMIBB_FUZZ_SEED     of all (1)

#include "fluid_scenes.h"
#include "hostile_input.h"

#include "compute.h"
#include "force.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <unistd.h>

using namespace hostile;

namespace {

long from_environment(const char *name, long otherwise)
{
  const char *text = std::getenv(name);
  return text ? std::atol(text) : otherwise;
}

// what was read last, for whoever finds the program dead or stuck
char last_input[4000];
void tell(const char *what)
{
  for (const char *text : {what, (const char *) last_input, "\n"})
    if (write(2, text, std::strlen(text)) < 0) return;
}
void too_long(int)
{
  tell("\nno end of this input after 60 s:\n");
  std::abort();
}
void crashed(int signal)
{
  tell("\nthis input killed the program:\n");
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// an edge that no number of few digits divides: nodes are as many as the right commands ask for
constexpr double EDGE = 6.0102030405e-4;

struct Kind {
  const char *boundary;
  bool flat;
  const char *faces;
};
constexpr Kind KINDS[] = {{"p p p", false, ""},
                          {"p p f", false, "face zlo wall 1e-3 0 0 face zhi wall"},
                          {"p p f", false, "face zlo pressure 0.1 face zhi pressure v_zero"},
                          {"f p p", false, "face xlo velocity 1e-3 0 0 face xhi pressure 0"},
                          {"f p p", true, "face xlo velocity 1e-3 0 0 face xhi pressure 0"},
                          {"p f p", true, "face ylo wall 1e-3 0 0 face yhi wall"}};

const Words OPTIONS = {"every 2",
                       "every 1",
                       "collision bgk",
                       "collision trt 0.25",
                       "precision single",
                       "precision double",
                       "link bouzidi",
                       "link halfway",
                       "refill equilibrium",
                       "refill grad",
                       "accel 1e-2 0 0",
                       "accel v_fine 0 0",
                       "gradp 1 0 0",
                       "gradp v_zero 0 0",
                       "buoyancy 0 -9.81 0",
                       "buoyancy 0 v_fine 0",
                       "shrink 1e-6",
                       "average no",
                       "conserve no",
                       "check 1"};

const Words WALL_OPTIONS = {"offset 1e-7", "limit_damping yes", "shear x 1e-3",
                            "wiggle z 1e-6 1e-2"};

}    // namespace

class Fuzz : public FluidTest {
 protected:
  std::string quartz;    // the contact file
  std::map<std::string, long> outcome;
  int faults = 0;

  // a box of 6 cells an edge with two grains, one of them free
  void make_scene(const Kind &kind)
  {
    // LAMMPS's buffers for lines grow now: if they do in a line that ends in an error, what it tells
    // of the words of the line before has been freed
    script("print \"" + std::string(100000, 'x') + "$(1)\"");
    const std::string edge = " 0 " + num(EDGE);
    script("units si\natom_style sphere\natom_modify map array sort 0 0\ndimension " +
           std::string(kind.flat ? "2" : "3") + "\nboundary " + kind.boundary +
           "\ncomm_modify vel yes\nregion box block" + edge + edge +
           (kind.flat ? " -0.5e-4 0.5e-4" : edge) +
           "\ncreate_box 2 box\nneighbor 1e-4 bin\nthermo_style custom step\ntimestep 1e-3");
    fill_scene(kind);
  }
  // afresh, with its variables: an error may have left one marked as being evaluated
  void fill_scene(const Kind &kind)
  {
    script("delete_atoms group all\nreset_timestep 0");
    const double r = 2.3e-4, density = SOLID * (kind.flat ? 0.75 / r : 1.0);
    script("create_atoms 1 single 3.1e-4 2.9e-4 " + std::string(kind.flat ? "0" : "3.2e-4") +
           "\nset group all diameter " + num(2.0 * r) + "\nset group all density " + num(density) +
           "\nset group all omega 0 0 0.5");
    for (const std::string &name : NAMES)
      if (!name.empty() && name != "nowhere") script("variable " + name + " delete");
    script(VARIABLES);
  }

  // the commands of one input, separated by line ends
  std::string input(Generator &g, const Kind &kind)
  {
    const std::string fluid = "fix w all lb/ibb dx " + num(EDGE / 6) + " nu 1e-6 rho 1000 ";
    const auto spoilt = [&](const std::string &text, int first) {
      Words words = split(text);
      g.spoil(words, first);
      return line(words);
    };
    const std::string plane = kind.boundary[0] == 'f' ? "xplane"
        : kind.boundary[2] == 'f'                     ? "yplane"
                                                      : "zplane";
    const std::string wall =
        "fix wall all wall/gran/lsd/coulomb 1e-3 0.9 0.45 " + plane + " 0 6e-4 ";
    switch (g.below(10)) {
      case 0:
        return spoilt("pair_style gran/lsd/coulomb offset 1e-7 limit_damping no", 2) + "\n" +
            "pair_coeff * * 1e-3 0.9 0.45";
      case 1:
        return "pair_style gran/lsd/coulomb\n" +
            spoilt(g.once_in(3) ? "pair_coeff * * file quartz_sand.lsd quartz_soft"
                                : "pair_coeff * * 1e-3 0.9 0.45",
                   1);
      case 2:
        return spoilt(wall + g.one_of(WALL_OPTIONS) + " " + g.one_of(WALL_OPTIONS), 4);
      case 3:
        return fluid + kind.faces + "\n" +
            spoilt("compute p all lb/ibb/profile w " + std::string(g.once_in(2) ? "x" : "y") +
                       (g.once_in(2) ? " layers 3 gravity 9.81 critical 0.9"
                                     : " width " + num(EDGE / 3)),
                   4);
      case 4:
        std::ofstream("hostile.lsd", std::ios::binary) << g.spoiled(quartz);
        return "pair_style gran/lsd/coulomb\npair_coeff * * file hostile.lsd quartz_soft";
      default: {
        std::string options = kind.faces;
        for (int k = g.below(4); k > 0; k--) options += " " + g.one_of(OPTIONS);
        return spoilt(fluid + options, g.once_in(3) ? 4 : 10);
      }
    }
  }

  // what users and other commands see and is no number, or ""
  std::string no_number()
  {
    if (auto *w = lmp->modify->get_fix_by_id("w")) {
      if (!std::isfinite(w->compute_scalar())) return "f_w";
      for (int k = 0; k < w->size_vector; k++)
        if (!std::isfinite(w->compute_vector(k))) return "f_w[" + std::to_string(k + 1) + "]";
      int ncol;
      w->get_griddata_by_index(w->get_griddata_by_name(0, "velocity", ncol));
    }
    if (auto *p = lmp->modify->get_compute_by_id("p")) {
      p->compute_array();
      for (int i = 0; i < p->size_array_rows; i++)
        for (int j = 0; j < p->size_array_cols; j++)
          if (!std::isfinite(p->array[i][j])) return "c_p[" + std::to_string(j + 1) + "]";
    }
    for (int i = 0; i < lmp->atom->nlocal; i++)
      for (int d = 0; d < 3; d++)
        if (!std::isfinite(lmp->atom->x[i][d] + lmp->atom->f[i][d])) return "place or force";
    return "";
  }
  void fault(const std::string &what)
  {
    ADD_FAILURE() << what;
    faults++;
  }
  void tidy_up()
  {
    for (const char *id : {"w", "wall", "free"})
      if (lmp->modify->get_fix_by_id(id)) {
        if (lmp->modify->get_compute_by_id("p")) script("uncompute p");
        script(std::string("unfix ") + id);
      }
    script("pair_style none");
  }

  void read(std::uint64_t seed, std::uint64_t n, std::unique_ptr<LAMMPS_NS::LAMMPS> *instances)
  {
    Generator g(seed, n);
    const int k = g.below(int(std::size(KINDS)));
    const Kind &kind = KINDS[k];
    lmp.swap(instances[k]);
    if (!lmp) {
      start();
      make_scene(kind);
    }
    const std::string text = input(g, kind);
    snprintf(last_input, sizeof(last_input), "seed %llu, input %llu: %s", (unsigned long long) seed,
             (unsigned long long) n, text.c_str());
    SCOPED_TRACE(last_input);
    alarm(60);
    std::string stage = "refused";
    try {
      script(text);
      stage = "stopped";
      script(std::string("fix free all nve/sphere") + (kind.flat ? " disc" : ""));
      script(g.once_in(4) ? "run 0 post no" : "run 6 post no");
      stage = "ran";
      const std::string wrong = no_number();
      if (!wrong.empty()) fault("ran, but no number: " + wrong);
    } catch (LAMMPS_NS::LAMMPSException &error) {
      const std::string message = error.what();
      if (message.find("ERROR") == std::string::npos) fault("says no more than: " + message);
      if (stage == "ran") fault("ran, but: " + message);
    } catch (std::exception &error) {
      fault(std::string("no error of LAMMPS: ") + error.what());
    }
    outcome[stage]++;
    // LAMMPS keeps requests for neighbour lists of a pair style when set-up ends in an error of another
    if (stage == "stopped" && lmp->force->pair) {
      lmp.reset();
      return;
    }
    try {
      tidy_up();
      if (stage != "refused") fill_scene(kind);
    } catch (std::exception &error) {
      fault(std::string("cannot go on after it: ") + error.what());
      lmp.reset();
    }
    lmp.swap(instances[k]);
  }
};

TEST_F(Fuzz, EveryInputEndsInAnErrorOrARun)
{
  std::ifstream file(std::string(std::getenv("LBMIBB_SOURCE_DIR")) + "/potentials/quartz_sand.lsd");
  std::stringstream all;
  all << file.rdbuf();
  quartz = all.str();
  ASSERT_FALSE(quartz.empty());
  const long inputs = from_environment("LBMIBB_FUZZ_INPUTS", 1200),
             first = from_environment("LBMIBB_FUZZ_FIRST", 0),
             seed = from_environment("LBMIBB_FUZZ_SEED", 1);
  printf("seed %ld, inputs %ld to %ld\n", seed, first, first + inputs - 1);
  fflush(stdout);
  std::signal(SIGALRM, too_long);
#ifndef __SANITIZE_ADDRESS__    // whose own handlers tell more, and call this one through SIGABRT
  for (const int deadly : {SIGSEGV, SIGFPE, SIGBUS, SIGILL}) std::signal(deadly, crashed);
#endif
  std::signal(SIGABRT, crashed);
  lmp.reset();
  std::unique_ptr<LAMMPS_NS::LAMMPS> instances[std::size(KINDS)];
  for (long n = first; n < first + inputs && faults < 20; n++) read(seed, n, instances);
  alarm(0);
  std::remove("hostile.lsd");
  for (const auto &[what, count] : outcome) printf("%s: %ld\n", what.c_str(), count);
  // a generator whose inputs all end the same way tests nothing
  if (inputs >= 1000 && !faults)
    for (const char *what : {"refused", "stopped", "ran"})
      EXPECT_GT(outcome[what], inputs / 50) << what;
}
