#pragma once

#include "console.hpp"
#include "listing.hpp"
#include "load_snapshot.hpp"

#include <abut/algorithm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace abut::cli {

struct CompareOptions {
  InputOptions input;                  ///< a file, or with a count the name of a scene
  std::optional<std::uint64_t> count;  ///< elements of the scene
  std::uint64_t seed = 1;
  std::vector<Algorithm> algorithms;  ///< empty: all that can
  double margin = 0.0;
  std::uint64_t max_bytes = 0;  ///< 0: the bound of the library
  ConsoleOptions console;
  Listing listing = Listing::text;
};

/// Runs algorithms on the same elements. Throws Error{check_failed} if their pairs differ.
void run(const CompareOptions& options);

}  // namespace abut::cli
