#pragma once

#include "console.hpp"
#include "file_or_scene.hpp"
#include "listing.hpp"

#include <abut/algorithm.hpp>

#include <cstdint>
#include <vector>

namespace abut::cli {

struct CompareOptions {
  FileOrScene source;
  std::vector<Algorithm> algorithms;  ///< empty: all that can
  double margin = 0.0;
  std::uint64_t max_bytes = 0;  ///< 0: the bound of the library
  ConsoleOptions console;
  Listing listing = Listing::text;
};

/// Runs algorithms on the same elements. Throws Error{check_failed} if their pairs differ.
void run(const CompareOptions& options);

}  // namespace abut::cli
