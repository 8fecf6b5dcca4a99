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

/// The same in a periodic domain: rows, which lists images before it searches, while direct check
/// looks for those of each pair.
[[nodiscard]] Choice choose_for_images();

}  // namespace abut::registry
