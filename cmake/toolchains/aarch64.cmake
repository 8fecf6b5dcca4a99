# aarch64 from another Linux: -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/aarch64.cmake, with Debian's
# g++-aarch64-linux-gnu, the libraries of the architecture arm64 (libhwy-dev:arm64, ...) and, to run
# what is built, qemu-user-static.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)
