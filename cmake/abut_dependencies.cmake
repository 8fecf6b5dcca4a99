# What the core uses where it is there: Highway for vectors, and what OpenMP says of threads. Both
# are private.
# ABUT_HIGHWAY and ABUT_OPENMP: ON demands one, OFF does without, AUTO takes what is found.

set(ABUT_USE_HIGHWAY OFF)
if(NOT ABUT_HIGHWAY STREQUAL OFF)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(HWY QUIET libhwy)
  endif()
  set(ABUT_USE_HIGHWAY ${HWY_FOUND})
  if(ABUT_HIGHWAY STREQUAL ON AND NOT HWY_FOUND)
    message(FATAL_ERROR "ABUT_HIGHWAY is ON, but libhwy is not found by pkg-config; "
      "install libhwy-dev and pkgconf, or take AUTO or OFF")
  endif()
endif()

set(ABUT_USE_OPENMP OFF)
if(NOT ABUT_OPENMP STREQUAL OFF)
  find_package(OpenMP QUIET COMPONENTS CXX)
  if(OpenMP_CXX_FOUND)
    set(ABUT_USE_OPENMP ON)
  elseif(ABUT_OPENMP STREQUAL ON)
    message(FATAL_ERROR "ABUT_OPENMP is ON, but the compiler has no OpenMP; take AUTO or OFF")
  endif()
endif()

# For --version --verbose.
set(ABUT_HIGHWAY_VERSION "none: kernels in plain C++")
if(ABUT_USE_HIGHWAY)
  set(ABUT_HIGHWAY_VERSION "${HWY_VERSION}")
endif()
set(ABUT_OPENMP_VERSION "none: one thread unless more are asked for")
if(ABUT_USE_OPENMP)
  set(ABUT_OPENMP_VERSION "${OpenMP_CXX_VERSION}")
endif()

# By name and by flag, never by path: an installed tree may be moved to another machine.
set(ABUT_CORE_LIBRARIES -pthread)
if(ABUT_USE_HIGHWAY)
  list(APPEND ABUT_CORE_LIBRARIES ${HWY_LIBRARIES})
endif()
if(ABUT_USE_OPENMP)
  list(APPEND ABUT_CORE_LIBRARIES ${OpenMP_CXX_FLAGS})
endif()

message(STATUS "abut: vectors (Highway) ${ABUT_USE_HIGHWAY}, threads (OpenMP) ${ABUT_USE_OPENMP}")
