// Nothing: CMake compiles the headers of this target for those of the tests (tests/CMakeLists.txt).
