# The hook that puts package LBM-IBB into LAMMPS without changing LAMMPS's tree.
#
# CMake includes this file right after LAMMPS's own project(lammps), because
# CMAKE_PROJECT_lammps_INCLUDE names it (cmake/lbm-ibb.cmake sets that variable).
# At that moment nothing of LAMMPS is defined yet, so here we only register our
# styles (LAMMPS generates its style headers from that list later) and defer the
# rest to the end of LAMMPS's CMakeLists.txt, when target "lammps" is complete.
#
# Options, all usable with -D:
#   PKG_LBM-IBB        ON | OFF    as for every LAMMPS package
#   LBMIBB_ARCH        native | none | x86-64-v3 | ...   processor our sources are compiled for
#   LBMIBB_CXX_FLAGS   optimisation flags of our sources
#   LBMIBB_PCH         ON | OFF    precompiled header for LAMMPS: saves compile time

option(PKG_LBM-IBB "Build LBM-IBB Package" ON)
option(LBMIBB_PCH "Compile LAMMPS with a precompiled header" OFF)

include("${CMAKE_CURRENT_LIST_DIR}/sources.cmake")

# Runs at the end of LAMMPS's CMakeLists.txt.
function(lbmibb_add_to_lammps)
  if(NOT PKG_GRANULAR)
    message(FATAL_ERROR "Package LBM-IBB needs package GRANULAR: add -D PKG_GRANULAR=ON")
  endif()
  lbmibb_add_sources()
  if(ZLIB_FOUND)
    target_link_libraries(lammps PRIVATE ${ZLIB_LIBRARIES})
  endif()
  target_sources(lammps PRIVATE $<TARGET_OBJECTS:lbmibb_core>)

  # Fixes, pair styles and the like are sources of LAMMPS itself.  A precompiled header
  # made with other -m flags is of no use to them.
  target_sources(lammps PRIVATE ${LBMIBB_ADAPTER})
  set_source_files_properties(${LBMIBB_ADAPTER} TARGET_DIRECTORY lammps PROPERTIES
    COMPILE_OPTIONS "${LBMIBB_FLAGS}" COMPILE_DEFINITIONS EIGEN_MAX_ALIGN_BYTES=16
    SKIP_PRECOMPILE_HEADERS ON)

  # LAMMPS's sources see our style headers through a link in the build folder: their command
  # lines are then the same in every clone, and a compiler cache can share the objects.
  set(link "${CMAKE_CURRENT_BINARY_DIR}/packages/LBM-IBB")
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/packages")
  file(CREATE_LINK "${LBMIBB_SRC}" "${link}" RESULT failed SYMBOLIC)
  if(failed)
    set(link "${LBMIBB_SRC}")
  endif()
  get_filename_component(above "${link}" DIRECTORY)
  target_include_directories(lammps PRIVATE "${link}" "${above}")
  target_include_directories(lammps SYSTEM PRIVATE "${LBMIBB_EIGEN_DIR}")

  if(LBMIBB_PCH)
    target_precompile_headers(lammps PRIVATE <mpi.h> <algorithm> <cmath> <cstring> <map> <set>
      <string> <unordered_set> <vector> "${LAMMPS_SOURCE_DIR}/fmt/format.h"
      "${LAMMPS_SOURCE_DIR}/pointers.h")
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")    # lets ccache look through the header
      target_compile_options(lammps PRIVATE -fpch-preprocess)
    endif()
  endif()

  # For LAMMPS's Python module: the same objects as one shared library. "ninja lammps_shared", tools/python
  if(NOT BUILD_SHARED_LIBS)
    add_library(lammps_shared SHARED EXCLUDE_FROM_ALL $<TARGET_OBJECTS:lammps> $<TARGET_OBJECTS:lbmibb_core>)
    set_target_properties(lammps_shared PROPERTIES OUTPUT_NAME lammps LINKER_LANGUAGE CXX
      LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/python")
    target_link_libraries(lammps_shared PRIVATE $<TARGET_PROPERTY:lammps,LINK_LIBRARIES>)
  endif()
  message(STATUS "LBM-IBB: added to LAMMPS from ${LBMIBB_SRC}")
endfunction()

if(PKG_LBM-IBB)
  if(EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/../src/LBM-IBB")
    message(FATAL_ERROR "This LAMMPS tree holds a copy of LBM-IBB in src/ (for traditional make): "
      "remove src/LBM-IBB; CMake takes the package from ${LBMIBB_SRC}")
  endif()
  include("${CMAKE_CURRENT_SOURCE_DIR}/Modules/StyleHeaderUtils.cmake")
  RegisterStyles("${LBMIBB_SRC}")
  RegisterPackages("${LBMIBB_SRC}")    # for the message "style ... is part of package ..."

  # LAMMPS sets its list of packages later in its CMakeLists.txt; join it the moment it does,
  # so that "lmp -h" and is_installed_pkg know about us.
  macro(lbmibb_join_packages variable access)
    if("${access}" STREQUAL "MODIFIED_ACCESS" AND NOT "LBM-IBB" IN_LIST STANDARD_PACKAGES)
      list(APPEND STANDARD_PACKAGES LBM-IBB)
    endif()
  endmacro()
  variable_watch(STANDARD_PACKAGES lbmibb_join_packages)
  cmake_language(DEFER CALL lbmibb_add_to_lammps)
endif()
