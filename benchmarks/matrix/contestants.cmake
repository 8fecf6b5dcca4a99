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
  matrix/table.cpp
  matrix/trial.cpp)
target_link_libraries(matrix PRIVATE abut abut_scenes abut_settings CLI11::CLI11)
target_include_directories(matrix PRIVATE "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}")

# Contestants run where they are built, with all that this processor can do.
check_cxx_compiler_flag(-march=native ABUT_HAS_MARCH_NATIVE)
if(ABUT_HAS_MARCH_NATIVE)
  target_compile_options(matrix PRIVATE -march=native)
endif()

set(contestants_found "")

# contestant(NAME [WHEN condition] [LINK targets...])
function(contestant name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "WHEN" "LINK")
  if(DEFINED arg_WHEN AND NOT ${arg_WHEN})
    message(STATUS "Benchmark contestant ${name}: not installed, left out")
    return()
  endif()
  message(STATUS "Benchmark contestant ${name}: found")
  target_sources(matrix PRIVATE matrix/contestants/${name}.cpp)
  target_link_libraries(matrix PRIVATE ${arg_LINK})
  set(contestants_found "${contestants_found}ABUT_CONTESTANT(${name})\n" PARENT_SCOPE)
endfunction()

contestant(copy)
contestant(plain_grid)
contestant(abut)

file(CONFIGURE OUTPUT contestants_found.inl CONTENT "${contestants_found}" @ONLY)

if(ABUT_BUILD_TESTS)
  # So that it cannot rot: whether the answers of all contestants found are right; nothing is timed.
  add_test(NAME benchmarks.matrix COMMAND matrix --counts 0,1,2000 --repetitions 0 --threads 1)
  set_tests_properties(benchmarks.matrix PROPERTIES LABELS full TIMEOUT 300)
endif()
