#pragma once

#include "fuzz/fuzz_case.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace abut::fuzz {

using testing::ImagePair;

/// What the contract says about a system.
struct Expected {
  std::vector<ImagePair> pairs;  ///< in canonical order
  bool must_refuse = false;      ///< a pair has a shift beyond 32 bits
  bool may_refuse = false;       ///< elements are far out, or reach far
};

/// None where there are more pairs and images within reach than that.
[[nodiscard]] std::optional<Expected> expected_of(const System& system, std::uint64_t most_images);

/// Whether the rule of the system allows elements `first` and `second` to pair.
[[nodiscard]] bool allows(const System& system, std::size_t first, std::size_t second);

}  // namespace abut::fuzz
