# Other people's libraries that abut is measured beside; each may be missing.
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
