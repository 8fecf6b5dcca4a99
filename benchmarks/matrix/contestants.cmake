# The matrix of tasks and contestants. A contestant is one file in contestants/, which defines
# enter_NAME(), and one line here; those whose library is not installed are left out.
include(CheckCXXCompilerFlag)

add_executable(matrix
  matrix.cpp
  matrix/apart.cpp
  matrix/case.cpp
  matrix/check.cpp
  matrix/contestants.cpp
  matrix/pinning.cpp
  matrix/plan.cpp
  matrix/table.cpp
  matrix/trial.cpp)
target_link_libraries(matrix PRIVATE abut abut_scenes abut_settings CLI11::CLI11)
target_include_directories(matrix PRIVATE "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}")

# Contestants run where they are built, with all that this processor can do.
check_cxx_compiler_flag(-march=native ABUT_HAS_MARCH_NATIVE)

set(contestants_found "")

# contestant(NAME [PORTABLE] [WHEN condition] [LINK targets...] [INCLUDE folders...]
#            [DEFINE definitions...])
# PORTABLE: its library was compiled for any processor, and the layout of its types depends on that.
# Objects of their own, so that nobody gets the settings of another one's library.
function(contestant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "PORTABLE" "WHEN" "LINK;INCLUDE;DEFINE")
  if(DEFINED arg_WHEN AND NOT ${arg_WHEN})
    message(STATUS "Benchmark contestant ${name}: not installed, left out")
    return()
  endif()
  message(STATUS "Benchmark contestant ${name}: found")
  set(objects contestant_${name})
  add_library(${objects} OBJECT matrix/contestants/${name}.cpp)
  target_link_libraries(${objects} PRIVATE abut abut_scenes abut_settings ${arg_LINK})
  target_include_directories(${objects} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_include_directories(${objects} SYSTEM PRIVATE ${arg_INCLUDE})
  target_compile_definitions(${objects} PRIVATE ${arg_DEFINE})
  if(ABUT_HAS_MARCH_NATIVE AND NOT arg_PORTABLE)
    target_compile_options(${objects} PRIVATE -march=native)
  endif()
  target_link_libraries(matrix PRIVATE ${objects})
  set(contestants_found "${contestants_found}ABUT_CONTESTANT(${name})\n" PARENT_SCOPE)
endfunction()

find_package(CGAL QUIET)
find_package(nanoflann QUIET)
find_package(embree 3 QUIET)
find_package(Boost 1.74 QUIET)
find_package(Bullet QUIET MODULE)
find_package(Eigen3 QUIET CONFIG)  # which fcl wants, and CGAL's own module hides
find_package(fcl QUIET)

find_program(ABUT_PYTHON python3 HINTS /usr/bin DOC "Python that may have SciPy")
if(ABUT_PYTHON)
  execute_process(COMMAND "${ABUT_PYTHON}" -c "import scipy.spatial; print(scipy.__version__, end='')"
    OUTPUT_VARIABLE scipy_version ERROR_QUIET RESULT_VARIABLE scipy_missing)
endif()
if(ABUT_PYTHON AND scipy_missing EQUAL 0)
  set(SCIPY_FOUND TRUE)
endif()

contestant(copy)
contestant(plain_grid)
contestant(abut)
contestant(cgal_box WHEN CGAL_FOUND LINK CGAL::CGAL)
contestant(nanoflann WHEN nanoflann_FOUND LINK nanoflann::nanoflann)
contestant(embree WHEN embree_FOUND LINK embree)
contestant(boost_rtree WHEN Boost_FOUND LINK Boost::headers)
contestant(bullet_dbvt WHEN BULLET_FOUND INCLUDE ${BULLET_INCLUDE_DIRS}
  LINK ${BULLET_COLLISION_LIBRARY} ${BULLET_MATH_LIBRARY})
contestant(scipy_ckdtree WHEN SCIPY_FOUND DEFINE "ABUT_PYTHON=\"${ABUT_PYTHON}\""
  "ABUT_SCIPY_VERSION=\"${scipy_version}\""
  "ABUT_SCIPY_SCRIPT=\"${CMAKE_CURRENT_SOURCE_DIR}/matrix/contestants/scipy_ckdtree.py\"")
contestant(fcl PORTABLE WHEN fcl_FOUND LINK fcl)

file(CONFIGURE OUTPUT contestants_found.inl CONTENT "${contestants_found}" @ONLY)
