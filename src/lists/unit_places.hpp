#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace abut::lists {

/// Places in a list of the pairs of units that several workers search at the same time: those of a
/// unit stand behind those of all units before it, and are known as soon as these are finished.
class UnitPlaces {
 public:
  /// Knows no unit any more.
  void clear() noexcept { known_ = 0; }

  /// Begins anew with units [first, first + count), of which the first one's pairs stand from
  /// `place` on. While no worker asks.
  void start(std::uint64_t first, std::size_t count, std::size_t place);

  /// A unit has so many pairs. Once for each unit, by any worker; other units are ignored.
  void finish(std::uint64_t unit, std::size_t pairs);

  /// Returns the place of the unit's first pair, if it is known. For any worker.
  [[nodiscard]] std::optional<std::size_t> of(std::uint64_t unit) const noexcept;

 private:
  static constexpr std::size_t unfinished = static_cast<std::size_t>(-1);

  std::uint64_t first_ = 0;
  std::vector<std::size_t> places_;     ///< of the units and of the end of the last one
  std::vector<std::size_t> pairs_;      ///< of each unit
  std::atomic<std::size_t> known_ = 0;  ///< number of places that are known: the first ones
  std::mutex mutex_;                    ///< of those who finish units
};

}  // namespace abut::lists
