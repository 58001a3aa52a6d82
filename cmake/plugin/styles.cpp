/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// Tells LAMMPS of all styles of the package; the lists of headers are made by CMake. They are read
// twice, as LAMMPS itself does: for the classes, and for the lines like FixStyle(lb/ibb,FixLbIbb).

#include "lammpsplugin.h"

// what their headers need for the classes
#include "command.h"
#include "lammps.h"
#include "plugin_command.h"
#include "plugin_compute.h"
#include "plugin_fix.h"
#include "plugin_pair.h"
#include "plugin_region.h"

using namespace LAMMPS_NS;

namespace {

template <class Style> Style *create(LAMMPS *lmp)
{
  return new Style(lmp);
}
template <class Style> Style *create_with_words(LAMMPS *lmp, int narg, char **arg)
{
  return new Style(lmp, narg, arg);
}

}    // namespace

extern "C" void lbmibb_register(void *lmp, void *handle, void *regfunc, const char *version)
{
  lammpsplugin_t plugin{};
  plugin.version = version;
  plugin.info = "LBM-IBB: lattice Boltzmann fluid and resolved grains";
  plugin.author = "LBM-IBB developers";
  plugin.handle = handle;
  [[maybe_unused]] auto add = [&](const char *kind, const char *name, auto creator) {
    plugin.style = kind;
    plugin.name = name;
    if constexpr (std::is_same_v<decltype(creator), lammpsplugin_factory1 *>)
      plugin.creator.v1 = creator;
    else
      plugin.creator.v2 = creator;
    reinterpret_cast<lammpsplugin_regfunc>(regfunc)(&plugin, lmp);
  };
#define ALONE(kind, key, Class) \
  add(kind, #key, reinterpret_cast<lammpsplugin_factory1 *>(&create<Class>))
#define WITH_WORDS(kind, key, Class) \
  add(kind, #key, reinterpret_cast<lammpsplugin_factory2 *>(&create_with_words<Class>))

#define COMMAND_CLASS
#define CommandStyle(key, Class) ALONE("command", key, Class)
#include "plugin_command.h"
#undef COMMAND_CLASS

#define COMPUTE_CLASS
#define ComputeStyle(key, Class) WITH_WORDS("compute", key, Class)
#include "plugin_compute.h"
#undef COMPUTE_CLASS

#define FIX_CLASS
#define FixStyle(key, Class) WITH_WORDS("fix", key, Class)
#include "plugin_fix.h"
#undef FIX_CLASS

#define PAIR_CLASS
#define PairStyle(key, Class) ALONE("pair", key, Class)
#include "plugin_pair.h"
#undef PAIR_CLASS

#define REGION_CLASS
#define RegionStyle(key, Class) WITH_WORDS("region", key, Class)
#include "plugin_region.h"
#undef REGION_CLASS
}
