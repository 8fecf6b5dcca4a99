#pragma once

#include <abut/error.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <vector>

/// What the programs of the benchmarks share.
namespace abut::benchmarks {

/// Exit code of a program whose contestants differ.
inline constexpr int different_answers = static_cast<int>(ErrorCode::check_failed);

/// Processor time, which other people's programs on the machine do not lengthen as they do time.
template <class Work>
[[nodiscard]] double processor_seconds(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// `seconds` must not be empty.
[[nodiscard]] inline double median(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// The body of main.
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
