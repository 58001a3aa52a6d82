# The sources of package LBM-IBB and what they are compiled with, for the hook that puts them into
# LAMMPS (LBM-IBB.cmake) and for the plugin (plugin/CMakeLists.txt).

set(LBMIBB_ARCH native CACHE STRING
  "Processor for LBM-IBB's sources: native (this machine), none (any machine), or a -march= value")
set(LBMIBB_CXX_FLAGS "-O3 -fno-math-errno -fno-trapping-math" CACHE STRING
  "Optimisation flags for LBM-IBB's sources")

get_filename_component(LBMIBB_SRC "${CMAKE_CURRENT_LIST_DIR}/../src/LBM-IBB" ABSOLUTE)

# Flags for our sources alone; LAMMPS's own keep what the user chose.
# Eigen's alignment, and with it the layout of our classes, would depend on -march, while
# LAMMPS's sources that see our headers are compiled without it: 16 bytes is what both get.
function(lbmibb_flags result)
  include(CheckCXXCompilerFlag)
  separate_arguments(flags UNIX_COMMAND "${LBMIBB_CXX_FLAGS}")
  if(LBMIBB_ARCH AND NOT LBMIBB_ARCH STREQUAL "none")
    string(MAKE_C_IDENTIFIER "LBMIBB_HAVE_MARCH_${LBMIBB_ARCH}" have)
    check_cxx_compiler_flag("-march=${LBMIBB_ARCH}" ${have})
    if(${have})
      list(APPEND flags "-march=${LBMIBB_ARCH}")
    elseif(LBMIBB_ARCH STREQUAL "native")
      message(WARNING "LBM-IBB: the compiler has no -march=native; set LBMIBB_ARCH for full speed")
    else()
      message(FATAL_ERROR "LBM-IBB: the compiler refuses -march=${LBMIBB_ARCH} (LBMIBB_ARCH)")
    endif()
  endif()
  # a debug build is for debuggers: leave its code as written
  set(${result} "$<$<NOT:$<CONFIG:Debug>>:${flags}>" PARENT_SCOPE)
  list(JOIN flags " " shown)
  message(STATUS "LBM-IBB: flags ${shown}")
endfunction()

# Targets lbmibb_headers and lbmibb_core; sets LBMIBB_ADAPTER, the sources that are LAMMPS styles,
# and LBMIBB_FLAGS, what these are compiled with.
macro(lbmibb_add_sources)
  find_path(LBMIBB_EIGEN_DIR Eigen/Core HINTS ENV EIGEN3_INCLUDE_DIR ENV EIGEN3_ROOT
    PATH_SUFFIXES eigen3 include/eigen3 DOC "Folder with Eigen/Core")
  if(NOT LBMIBB_EIGEN_DIR)
    message(FATAL_ERROR "Package LBM-IBB needs the Eigen 3 headers: install libeigen3-dev, "
      "or name the folder that holds Eigen/Core with -D LBMIBB_EIGEN_DIR=")
  endif()

  lbmibb_flags(LBMIBB_FLAGS)
  file(GLOB core CONFIGURE_DEPENDS "${LBMIBB_SRC}/lbm_*.cpp")
  file(GLOB LBMIBB_ADAPTER CONFIGURE_DEPENDS "${LBMIBB_SRC}/[^.]*.cpp")
  list(REMOVE_ITEM LBMIBB_ADAPTER ${core})

  # What it takes to compile our sources, or to include our headers.
  add_library(lbmibb_headers INTERFACE)
  target_compile_features(lbmibb_headers INTERFACE cxx_std_17)
  target_compile_options(lbmibb_headers INTERFACE "${LBMIBB_FLAGS}")
  target_compile_definitions(lbmibb_headers INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
  target_include_directories(lbmibb_headers INTERFACE "${LBMIBB_SRC}")
  target_include_directories(lbmibb_headers SYSTEM INTERFACE "${LBMIBB_EIGEN_DIR}")
  target_link_libraries(lbmibb_headers INTERFACE $<IF:$<BOOL:${BUILD_MPI}>,MPI::MPI_CXX,mpi_stubs>
    $<$<BOOL:${BUILD_OMP}>:OpenMP::OpenMP_CXX>)

  # for fix lb/ibb/vtk, which compresses its files where there is zlib
  find_package(ZLIB)
  if(ZLIB_FOUND)
    target_link_libraries(lbmibb_headers INTERFACE ${ZLIB_LIBRARIES})
  endif()

  # The solver core includes no LAMMPS header: compiled once, used by LAMMPS and by the
  # core's unit tests, which link without LAMMPS.
  add_library(lbmibb_core OBJECT ${core})
  target_link_libraries(lbmibb_core PUBLIC lbmibb_headers)
  target_compile_options(lbmibb_core PRIVATE -Wall -Wextra)
  if(ZLIB_FOUND)
    target_compile_definitions(lbmibb_core PRIVATE LBMIBB_ZLIB)
    target_include_directories(lbmibb_core SYSTEM PRIVATE ${ZLIB_INCLUDE_DIRS})
  endif()
endmacro()
