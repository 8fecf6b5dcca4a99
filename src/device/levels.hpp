#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/size_class.hpp"

#include <array>
#include <cstdint>

namespace abut::device {

/// How many elements are of each size class; the largest first, as size_class_of counts them.
using SizeCounts = std::array<std::uint64_t, size_classes>;

/// A division of elements by size.
struct Levels {
  std::uint32_t count = 1;
  std::array<double, most_levels> ends{};  ///< radii of a level are smaller; of the last infinite
  std::array<std::uint64_t, most_levels> elements{};  ///< of each level
};

/// The levels that cost least to search by an estimate. Elements of a level meet each other in
/// cells of their own reach, and each larger element meets them. What a level costs does not
/// depend on how larger elements are divided, so that the best of all divisions is found.
template <int Dim>
[[nodiscard]] Levels choose_levels(const SizeCounts& counts, const Extent<Dim>& extent,
                                   double margin);

}  // namespace abut::device
