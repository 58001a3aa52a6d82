# Preset that builds a LAMMPS tree of yours with package LBM-IBB; the tree is not changed:
#
#   cmake -C <clone>/cmake/lbm-ibb.cmake -S lammps/cmake -B build && cmake --build build
#
# Other options and presets of LAMMPS go before or after it as usual.

set(CMAKE_PROJECT_lammps_INCLUDE "${CMAKE_CURRENT_LIST_DIR}/LBM-IBB.cmake"
  CACHE FILEPATH "hook of package LBM-IBB" FORCE)
set(PKG_LBM-IBB ON CACHE BOOL "Build LBM-IBB Package" FORCE)
set(PKG_GRANULAR ON CACHE BOOL "Build GRANULAR Package" FORCE)    # our styles derive from its classes

# not needed by the package, but by its examples: clumps, and pictures in newer LAMMPS
set(PKG_RIGID ON CACHE BOOL "Build RIGID Package")
set(PKG_GRAPHICS ON CACHE BOOL "Build GRAPHICS Package")
