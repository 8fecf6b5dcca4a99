#pragma once

#include <abut/image_shift.hpp>
#include <abut/page_allocator.hpp>
#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/statistics.hpp>

#include <span>
#include <utility>
#include <vector>

namespace abut {

/// Array of pairs.
using PairArray = std::vector<ContactPair, detail::PageAllocator<ContactPair>>;

/// Array of image shifts.
using ShiftArray = std::vector<ImageShift, detail::PageAllocator<ImageShift>>;

/// The contact pairs of one detection, each once, in the order that was asked for.
class PairList {
 public:
  /// Makes an empty list.
  PairList() = default;
  /// Makes a list without shifts; called by the library.
  PairList(PairArray pairs, Statistics statistics)
      : pairs_(std::move(pairs)), statistics_(std::move(statistics)) {}
  /// Makes a list with shifts; called by the library.
  PairList(PairArray pairs, ShiftArray shifts, Statistics statistics)
      : pairs_(std::move(pairs)), shifts_(std::move(shifts)), statistics_(std::move(statistics)) {}
  /// Makes a list with shifts and quantities; called by the library.
  PairList(PairArray pairs, ShiftArray shifts, PairGeometry geometry, Statistics statistics)
      : pairs_(std::move(pairs)),
        shifts_(std::move(shifts)),
        geometry_(std::move(geometry)),
        statistics_(std::move(statistics)) {}

  /// Number of pairs.
  [[nodiscard]] PairCount size() const noexcept { return pairs_.size(); }
  /// True if there is no pair.
  [[nodiscard]] bool empty() const noexcept { return pairs_.empty(); }
  /// Pair k, from 0; k must be < size().
  [[nodiscard]] const ContactPair& operator[](PairCount k) const noexcept { return pairs_[k]; }
  /// Iterator to the first pair.
  [[nodiscard]] auto begin() const noexcept { return pairs_.begin(); }
  /// Iterator behind the last pair.
  [[nodiscard]] auto end() const noexcept { return pairs_.end(); }
  /// All pairs.
  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }

  /// Image shifts n, one for each pair: `second`, moved by n, is within reach of `first`. Empty
  /// unless Options::shifts asks for them; zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Gaps, one for each pair; see PairGeometry for these and what follows. Each of them is empty
  /// unless Options::quantities asks for it.
  [[nodiscard]] std::span<const double> gaps() const noexcept { return geometry_.gaps; }
  /// Unit normals from i to j, one for each pair.
  [[nodiscard]] std::span<const Vector> normals() const noexcept { return geometry_.normals; }
  /// Points of contact, one for each pair.
  [[nodiscard]] std::span<const Vector> points() const noexcept { return geometry_.points; }
  /// Distances of the centers, one for each pair.
  [[nodiscard]] std::span<const double> distances() const noexcept { return geometry_.distances; }
  /// Vectors from center to center, one for each pair.
  [[nodiscard]] std::span<const Vector> vectors() const noexcept { return geometry_.vectors; }

  /// Statistics of the detection that found the pairs.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  PairArray pairs_;
  ShiftArray shifts_;
  PairGeometry geometry_;
  Statistics statistics_;
};

}  // namespace abut
