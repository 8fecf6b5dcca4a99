#pragma once

#include "exact/lattice.hpp"

#include <abut/options.hpp>
#include <abut/pair_rule.hpp>
#include <abut/quantity.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::device {

/// Items of a search between levels that are counted at a time; their counts take 16 bytes each.
inline constexpr std::uint64_t most_items_at_a_time = std::uint64_t{1} << 21;
/// The places of so many pairs are told by 32 bits.
inline constexpr std::uint64_t most_narrow_places = std::numeric_limits<std::uint32_t>::max();

/// What a list of contacts holds: pairs, or rows of neighbors, each pair once or from both
/// elements.
enum class ListForm { pairs, half_rows, full_rows };

/// What a detection on a device is asked for.
struct DeviceRequest {
  double margin = 0.0;
  std::uint64_t max_pairs = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t items_at_a_time = most_items_at_a_time;
  std::uint64_t narrow_places = most_narrow_places;  ///< pairs of a part, told by 32 bits
  Shifts shifts = Shifts::none;
  ListForm form = ListForm::pairs;
  Quantities quantities = {};  ///< of lists
  exact::Lattice lattice = {};
  PairRule rule = {};  ///< its arrays lie on the device, its table and exclusions on the host

  /// Whether gaps are measured.
  [[nodiscard]] bool wants_gaps() const noexcept { return quantities.has(Quantity::gap); }

  /// Whether shifts are told of what is found in a domain that may be periodic.
  [[nodiscard]] bool finds_shifts(int dimensions) const noexcept {
    return shifts == Shifts::stored || (wants_gaps() && is_periodic(dimensions));
  }

  /// Whether Pipeline serves, for one set of elements of so many dimensions; all else is for
  /// PeriodicPipeline.
  [[nodiscard]] bool is_plain(int dimensions) const noexcept {
    return !is_periodic(dimensions) && rule.is_empty();
  }

  /// Whether elements of so many dimensions have images.
  [[nodiscard]] bool is_periodic(int dimensions) const noexcept {
    bool any = false;
    for (int axis = 0; axis < dimensions; ++axis) {
      any = any || lattice.periodic[static_cast<std::size_t>(axis)];
    }
    return any;
  }
};

}  // namespace abut::device
