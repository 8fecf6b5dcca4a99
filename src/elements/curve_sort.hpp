#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::elements {

/// An element and its number along a curve.
struct CurvePlace {
  std::uint64_t along;
  ElementIndex element;
};

/// Brings elements into the order of their numbers along a curve. Those of one number keep the
/// order in which they were given.
///
/// The elements of a part are divided by the bits that tell them apart first, and then those of
/// each division, until a few are left: most bits of a number are never looked at. Large parts are
/// divided by all workers.
class CurveSort {
 public:
  CurveSort(base::MemoryMeter& memory, std::size_t elements, std::size_t workers);

  /// Places to be written before the sort.
  [[nodiscard]] std::span<CurvePlace> places() noexcept { return places_; }

  /// Writes the elements in their order. It takes the places apart.
  void write_order(std::span<ElementIndex> order, base::WorkCounter& work);

 private:
  /// Places that stand together, as much room for them, and where their elements go.
  struct CurvePart {
    std::span<CurvePlace> places;
    std::span<CurvePlace> room;
    std::span<ElementIndex> order;

    /// Some of them, which have been brought to the room.
    [[nodiscard]] CurvePart in_room(std::size_t first, std::size_t count) const {
      return {room.subspan(first, count), places.subspan(first, count),
              order.subspan(first, count)};
    }
  };

  /// Bits of a number by which a part is divided.
  struct Digit {
    int shift;
    int bits;

    [[nodiscard]] std::size_t of(const CurvePlace& place) const noexcept {
      return place.along >> shift & ((std::uint64_t{1} << bits) - 1);
    }
  };

  static void sort_few(const CurvePart& part);
  static void sort_alone(const CurvePart& part);
  static void sort_rest(const CurvePart& part, const Digit& digit);
  void sort_with_all(const CurvePart& part, base::WorkCounter& work);
  [[nodiscard]] std::uint64_t differing_bits(const CurvePart& part, base::WorkCounter& work);
  void divide_with_all(const CurvePart& part, const Digit& digit, base::WorkCounter& work);

  [[nodiscard]] std::size_t* cursors_of(std::size_t worker) noexcept;

  base::Array<CurvePlace> places_;
  base::Array<CurvePlace> room_;
  base::Array<std::size_t> cursors_;      ///< of each worker, by digit
  base::Array<std::uint64_t> differing_;  ///< bits, of each worker
  std::size_t workers_;
};

}  // namespace abut::elements
