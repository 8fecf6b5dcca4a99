#pragma once

#include "algorithms/registry.hpp"

#include <cstddef>
#include <string_view>

namespace abut::registry {

struct Choice {
  const AlgorithmEntry* row;
  std::string_view reason;
};

/// Few elements: direct check. Otherwise rows, whose time and memory follow the elements whatever
/// the domain, the packing and the sizes; it divides by size itself.
[[nodiscard]] Choice choose_algorithm(std::size_t element_count);

}  // namespace abut::registry
