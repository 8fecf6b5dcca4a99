#pragma once

#include "engine/radius_histogram.hpp"

#include <optional>

namespace abut::engine {

/// Facts about a search set from which a cut between small and large elements is chosen.
struct SizeDistribution {
  double largest_radius;
  double smallest_radius;
  double margin;
  double volume;  ///< that a search set of even density would fill, in cells of the largest reach
};

/// The radius below which elements should be searched in smaller cells, without those above it,
/// which then visit them; none if cells of one size cost no more.
///
/// The estimate: a candidate test costs the same everywhere, elements are spread evenly, and what
/// is not a test (sorting, a visit's rows) costs some tests' worth for each element.
template <int Dim>
[[nodiscard]] std::optional<double> choose_size_cut(const RadiusHistogram& histogram,
                                                    const SizeDistribution& sizes);

}  // namespace abut::engine
