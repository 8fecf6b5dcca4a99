#pragma once

#include <abut/error.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>

/// Frame of a program of the benchmarks: errors and exit codes.
namespace abut::benchmarks {

/// Exit code of a program whose contestants differ.
inline constexpr int different_answers = static_cast<int>(ErrorCode::check_failed);

/// Runs the body of main. An exception becomes a line on stderr and an exit code.
[[nodiscard]] inline int run_program(const char* name, int (*body)(int, char**), int argc,
                                     char** argv) {
  try {
    return body(argc, argv);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return EXIT_FAILURE;
  }
}

}  // namespace abut::benchmarks
