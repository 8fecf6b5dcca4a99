#pragma once

#include "device/bodies/frame.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/sorted_stretches.hpp"
#include "device/bodies/stretch.hpp"
#include "device/executor.hpp"
#include "device/search/partner_search.hpp"

#include <cstdint>
#include <utility>

namespace abut::device {

/// Divides one axis of a level into stretches. It sorts the coordinates of its elements along the
/// axis once, 24 bytes an element while it does and 12 from then on, 8 without their numbers.
template <class Spheres, class E>
class AxisStretches {
  static constexpr int Dim = Spheres::dimensions;

 public:
  AxisStretches(E& executor, const Spheres& elements, const Frame<Dim>& frame, std::uint32_t level,
                int axis)
      : executor_(executor), count_(frame.levels[level].end_slot - frame.levels[level].first_slot) {
    TwinBuffer<std::uint64_t, E> coordinates;
    TwinBuffer<std::uint32_t, E> numbers;
    {
      const Buffer<std::uint32_t, E> places = places_in_level(elements, frame, level);
      coordinates.current = Buffer<std::uint64_t, E>(executor_, count_);
      numbers.current = Buffer<std::uint32_t, E>(executor_, count_);
      executor_.for_each(elements.count, CoordinateInLevel<Spheres>{
                                             elements, frame, level, axis, places.data(),
                                             coordinates.current.data(), numbers.current.data()});
    }
    coordinates.other = Buffer<std::uint64_t, E>(executor_, count_);
    numbers.other = Buffer<std::uint32_t, E>(executor_, count_);
    executor_.sort_by_key(coordinates, numbers, count_, 64);
    coordinates_.swap(coordinates.current);
    numbers_.swap(numbers.current);
  }

  void forget_numbers() noexcept { numbers_ = {}; }

  struct Size {
    std::uint64_t stretches;
    std::uint64_t cells;
    double longest;  ///< of the stretches
  };

  /// Tells what stretches there are; waits.
  [[nodiscard]] Size measure(double widest_gap, double units_of_one) {
    Buffer<std::uint32_t, E> before = count_begins(widest_gap);
    std::uint32_t stretches = 0;
    executor_.copy_to_host(&stretches, before.data() + count_, 1);
    note_begins(std::move(before), stretches);
    const AxisOfStretches divided = number_cells(units_of_one);
    Size size{stretches, 0, 0.0};
    executor_.copy_to_host(&size.cells, first_cells_.data() + stretches, 1);
    size.longest = executor_.reduce(stretches, 0.0, StretchLength{divided}, Larger{});
    begins_ = {};
    first_cells_ = {};
    return size;
  }

  /// Finds the stretches, whose number is known.
  void divide(double widest_gap, std::uint32_t stretches) {
    note_begins(count_begins(widest_gap), stretches);
  }

  /// Returns the number of the lowest element in each stretch.
  [[nodiscard]] Buffer<std::uint32_t, E> first_elements() {
    Buffer<std::uint32_t, E> first(executor_, begins_.size());
    executor_.for_each(begins_.size(), GatherEntry{numbers_.data(), begins_.data(), first.data()});
    return first;
  }

  /// Gives the stretches their cells. What is returned lives as long as this.
  [[nodiscard]] AxisOfStretches number_cells(double units_of_one) {
    first_cells_ = Buffer<std::uint64_t, E>(executor_, begins_.size() + 1);
    const AxisOfStretches divided{coordinates_.data(), static_cast<std::uint32_t>(count_),
                                  begins_.data(), static_cast<std::uint32_t>(begins_.size()),
                                  first_cells_.data()};
    executor_.for_each(begins_.size() + 1,
                       CellsOfStretch{divided, units_of_one, first_cells_.data()});
    executor_.exclusive_scan(first_cells_.data(), begins_.size() + 1);
    return divided;
  }

 private:
  /// Where the elements of a level stand among each other; empty where it has all.
  [[nodiscard]] Buffer<std::uint32_t, E> places_in_level(const Spheres& elements,
                                                         const Frame<Dim>& frame,
                                                         std::uint32_t level) {
    if (count_ == elements.count) return {};
    Buffer<std::uint32_t, E> places(executor_, elements.count);
    executor_.for_each(elements.count,
                       CountInLevel<Spheres>{elements, frame, level, places.data()});
    executor_.exclusive_scan(places.data(), elements.count);
    return places;
  }

  /// How many stretches begin before each coordinate, and in all.
  [[nodiscard]] Buffer<std::uint32_t, E> count_begins(double widest_gap) {
    Buffer<std::uint32_t, E> before(executor_, count_ + 1);
    executor_.for_each(count_ + 1,
                       StretchBegin{coordinates_.data(), count_, widest_gap, before.data()});
    executor_.exclusive_scan(before.data(), count_ + 1);
    return before;
  }

  void note_begins(Buffer<std::uint32_t, E> before, std::uint32_t stretches) {
    begins_ = Buffer<std::uint32_t, E>(executor_, stretches);
    executor_.for_each(count_, WriteBegin{before.data(), begins_.data()});
  }

  E& executor_;
  std::uint64_t count_;  ///< elements of the level
  Buffer<std::uint64_t, E> coordinates_;
  Buffer<std::uint32_t, E> numbers_;  ///< of the elements in that order
  Buffer<std::uint32_t, E> begins_;
  Buffer<std::uint64_t, E> first_cells_;
};

}  // namespace abut::device
