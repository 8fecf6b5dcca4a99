#pragma once

#include "console.hpp"
#include "file_or_scene.hpp"
#include "listing.hpp"
#include "options/device_option.hpp"
#include "options/rule_options.hpp"

#include <abut/algorithm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace abut::cli {

struct BenchOptions {
  FileOrScene source;
  RuleOptions rule;
  std::vector<Algorithm> algorithms;       ///< empty: rows, and those that are fast enough
  std::vector<int> threads;                ///< empty: one, and what OpenMP takes
  std::optional<std::size_t> repetitions;  ///< as many as a few seconds allow
  DeviceChoice device;                     ///< is measured besides
  double margin = 0.0;
  std::uint64_t max_bytes = 0;  ///< 0: the bound of the library
  ConsoleOptions console;
  Listing listing = Listing::text;
};

/// Measures algorithms on the same elements. Throws Error{check_failed} if their pairs differ.
void run(const BenchOptions& options);

}  // namespace abut::cli
