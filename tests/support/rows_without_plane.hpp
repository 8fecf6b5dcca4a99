#pragma once

#include "support/oracle.hpp"

#include <abut/element_view.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::testing {

/// More elements are searched in no plane.
[[nodiscard]] std::size_t most_in_plane();

struct RowsWithoutPlane {
  PairVector pairs;  ///< as found
  std::uint64_t candidate_tests = 0;
};

/// `rows` of elements that are so few that it would search them in a plane: in tiles or in layers
/// all the same, by that many workers.
[[nodiscard]] RowsWithoutPlane rows_without_plane(const ElementView& elements, double margin,
                                                  Simd simd, std::size_t workers);

}  // namespace abut::testing
