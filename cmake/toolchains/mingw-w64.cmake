# Windows from Linux: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/mingw-w64.cmake, with Debian's
# g++-mingw-w64-x86-64-posix. Highway and OpenMP have no packages there: plain kernels, one thread.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ABUT_HIGHWAY OFF CACHE STRING "")
set(ABUT_OPENMP OFF CACHE STRING "")
