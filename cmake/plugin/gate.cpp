/* ----------------------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What "plugin load" opens. LAMMPS's classes differ from version to version, and LAMMPS itself loads
// whatever it is given: here nothing but its C interface is used, which does not change, to see
// whether it is the LAMMPS that the package beside this file was compiled for. The package, which
// would not even open in another one, comes after that.

#include "lammpsplugin.h"
#include "library.h"
#include "lmptype.h"
#include "version.h"

#include <cstring>
#include <dlfcn.h>
#include <string>

namespace {

constexpr const char *PACKAGE = "liblbmibb.so";
using Init = void (*)(void *, void *, void *, const char *);

std::string own_folder()
{
  Dl_info info;
  if (!dladdr(reinterpret_cast<void *>(&lammpsplugin_init), &info) || !info.dli_fname) return "";
  const std::string path = info.dli_fname;
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash + 1);
}

// why the package must not be loaded into this LAMMPS, "" if it may
std::string refusal(void *lmp)
{
  const char *running = static_cast<const char *>(lammps_extract_global(lmp, "lammps_version"));
  if (!running || std::strcmp(running, LAMMPS_VERSION) != 0)
    return std::string("compiled for LAMMPS ") + LAMMPS_VERSION + ", but this is LAMMPS " +
        (running ? running : "of unknown version") + ": build it with this one's sources";
  const int sizes[] = {lammps_extract_setting(lmp, "bigint"), lammps_extract_setting(lmp, "tagint"),
                       lammps_extract_setting(lmp, "imageint")};
  if (sizes[0] != sizeof(LAMMPS_NS::bigint) || sizes[1] != sizeof(LAMMPS_NS::tagint) ||
      sizes[2] != sizeof(LAMMPS_NS::imageint))
    return "compiled for other sizes of integers than this LAMMPS: build it with -D LAMMPS_SIZES=" +
        std::string(sizes[1] == 8 ? "bigbig" : "smallbig");
  if (!lammps_config_has_mpi_support())
    return "compiled with MPI, but this LAMMPS was built without";
  if (!lammps_config_has_package("GRANULAR"))
    return "it needs package GRANULAR, which this LAMMPS was built without";
  return "";
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  static Init init = nullptr;
  std::string why = refusal(lmp);
  if (why.empty() && !init && lammps_has_style(lmp, "fix", "lb/ibb"))
    why = "this LAMMPS has package LBM-IBB built in";
  if (why.empty() && !init) {
    const std::string name = own_folder() + PACKAGE;
    void *package = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (package) init = reinterpret_cast<Init>(dlsym(package, "lbmibb_register"));
    if (!init) {
      const char *text = dlerror();
      why = "cannot open " + name + ": " + (text ? text : "it is not the package");
    }
  }
  if (!why.empty())    // all ranks come to this
    return lammps_error(lmp, 2, ("Plugin LBM-IBB is not loaded: " + why).c_str());
  init(lmp, handle, regfunc, LAMMPS_VERSION);
}
