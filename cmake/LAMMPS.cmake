# Finds or obtains LAMMPS's source tree and adds it, with LBM-IBB inside, to this build.
# In this order: LAMMPS_DIR; LBMIBB_LAMMPS_URL if set; Debian's source package (pinned, with
# checksum); LAMMPS's release tag.  Sets LBMIBB_LAMMPS_TREE.

# ccache shares objects between clones at different paths, given that paths below the cache
# folder are seen as relative ones and that it may look through the precompiled header
function(lbmibb_use_ccache cache)
  find_program(LBMIBB_CCACHE_PROGRAM ccache)
  if(LBMIBB_CCACHE AND LBMIBB_CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER env "CCACHE_BASEDIR=${cache}" CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      "${LBMIBB_CCACHE_PROGRAM}" PARENT_SCOPE)
    message(STATUS "LBM-IBB: with ccache")
  endif()
endfunction()

# the release that LBM-IBB is developed with; get_lammps.sh knows the same one
set(lbmibb_tag_url "https://github.com/lammps/lammps/archive/refs/tags/patch_4Feb2025.tar.gz")

# the folder that ./run and ./test use too, so that one download serves all clones
if(DEFINED ENV{LBMIBB_CACHE})
  set(lbmibb_cache "$ENV{LBMIBB_CACHE}")
elseif(DEFINED ENV{XDG_CACHE_HOME})
  set(lbmibb_cache "$ENV{XDG_CACHE_HOME}/lbm-ibb")
else()
  set(lbmibb_cache "$ENV{HOME}/.cache/lbm-ibb")
endif()

function(lbmibb_fetch url result)
  string(SHA256 key "${url}")
  string(SUBSTRING "${key}" 0 10 key)
  set(tree "${lbmibb_cache}/lammps-url-${key}")
  if(NOT EXISTS "${tree}/src/version.h")
    message(STATUS "LBM-IBB: fetching LAMMPS from ${url}")
    include(FetchContent)
    set(FETCHCONTENT_QUIET OFF)
    FetchContent_Populate(lammps_tree URL "${url}" SOURCE_DIR "${tree}"
      SUBBUILD_DIR "${CMAKE_BINARY_DIR}/fetch" BINARY_DIR "${CMAKE_BINARY_DIR}/fetch-unused"
      DOWNLOAD_EXTRACT_TIMESTAMP ON)
  endif()
  set(${result} "${tree}" PARENT_SCOPE)
endfunction()

if(LAMMPS_DIR)
  get_filename_component(tree "${LAMMPS_DIR}" ABSOLUTE)
elseif(LBMIBB_LAMMPS_URL)
  lbmibb_fetch("${LBMIBB_LAMMPS_URL}" tree)
else()
  execute_process(COMMAND bash "${CMAKE_CURRENT_LIST_DIR}/get_lammps.sh"
    OUTPUT_VARIABLE tree OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
  if(failed EQUAL 3)
    message(FATAL_ERROR "LBM-IBB: Debian's archive of LAMMPS is not what it should be")
  elseif(failed)
    message(STATUS "LBM-IBB: no source package of LAMMPS to be had here")
    lbmibb_fetch("${lbmibb_tag_url}" tree)
  endif()
endif()
if(NOT EXISTS "${tree}/cmake/CMakeLists.txt" OR NOT EXISTS "${tree}/src/version.h")
  message(FATAL_ERROR "No LAMMPS source tree at ${tree} (it should hold cmake/ and src/version.h). "
    "Set LAMMPS_DIR to one, or LBMIBB_LAMMPS_URL to an archive of one.")
endif()

set(LBMIBB_LAMMPS_TREE "${tree}")
file(STRINGS "${tree}/src/version.h" version REGEX LAMMPS_VERSION)
message(STATUS "LBM-IBB: LAMMPS in ${tree}: ${version}")

lbmibb_use_ccache("${lbmibb_cache}")
set(MPI_CXX_SKIP_MPICXX TRUE)    # the obsolete C++ bindings only cost compile time
find_package(MPI COMPONENTS CXX)    # here, not only inside LAMMPS: our tests link what it links
find_package(OpenMP COMPONENTS CXX)

include(cmake/lbm-ibb.cmake)
add_subdirectory("${tree}/cmake" "${CMAKE_BINARY_DIR}/lammps")
