#pragma once

#include "engine/sizes/size_classes.hpp"

#include <optional>

namespace abut::engine {

/// How a search set is best searched in cells of one size or of several.
struct SizePlan {
  /// The radius below which elements should be searched in smaller cells, without those above it,
  /// which then visit them; none if cells of one size cost no more.
  std::optional<double> cut;
  double cost;  ///< of that, in candidate tests
};

/// The estimate: a candidate test costs the same everywhere, elements are spread evenly, and what
/// is not a test (sorting, a visit's rows) costs some tests' worth for each element.
template <int Dim>
[[nodiscard]] SizePlan plan_sizes(const SizeClasses& classes, const SizeDistribution& sizes);

/// The same of a search in layers without the elements above a cut, which then meet all others and
/// each other one by one: no cut if it leaves more of them than is worth that, or if more of the
/// others than `most_in_cell` would share a cell.
template <int Dim>
[[nodiscard]] SizePlan plan_coarse(const SizeClasses& classes, const SizeDistribution& sizes,
                                   double most_in_cell);

}  // namespace abut::engine
