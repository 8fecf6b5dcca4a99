#pragma once

#include "device/bodies/directory.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/meet.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sizes.hpp"
#include "device/executor.hpp"

#include <abut/element_view.hpp>

#include <bit>
#include <cstdint>

namespace abut::device {

/// Elements in the order of their cells, and the directory of these.
template <class Spheres, class Key, class E>
class SortedElements {
  static constexpr int Dim = Spheres::dimensions;
  using Size = SizeOf<Spheres>;

 public:
  SortedElements(E& executor, const Spheres& elements, const Frame<Dim>& frame)
      : executor_(executor), elements_(elements), frame_(frame) {
    sort();
    write_directory();
    if (frame_.level_count > 1 || !elements_.has_common_radius()) gather_sizes();
    numbers_ = {};
  }

  [[nodiscard]] const PlacedRecord<Dim>* records() const noexcept { return records_.data(); }
  /// Null where all are of one.
  [[nodiscard]] const Size* all_sizes() const noexcept { return sizes_.data(); }
  [[nodiscard]] Directory<Key> directory() const noexcept {
    return {keys_.data(), heads_.data(), shift_};
  }

  /// The sizes of the elements of one level.
  [[nodiscard]] SizesOf<Spheres> sizes(const SizeLevel<Dim>& level) const noexcept {
    const double margin = frame_.margin * level.units_of_one;
    if constexpr (Spheres::shape == Shape::box) {
      return {sizes_.data(), static_cast<std::int32_t>(margin)};
    } else {
      return {sizes_.data(), static_cast<float>(level.largest_reach * level.units_of_one),
              static_cast<float>(margin)};
    }
  }

 private:
  void sort() {
    const std::uint64_t count = elements_.count;
    TwinBuffer<Key, E> keys(executor_, count);
    TwinBuffer<std::uint32_t, E> numbers(executor_, count);
    Buffer<PlacedRecord<Dim>, E> records(executor_, count);
    executor_.for_each(count, PlaceElement<Spheres, Key>{elements_, frame_, keys.current.data(),
                                                         numbers.current.data(), records.data()});
    executor_.sort_by_key(keys, numbers, count,
                          static_cast<int>(std::bit_width(frame_.key_count - 1)));
    keys_.swap(keys.current);
    numbers_.swap(numbers.current);
    keys = {};
    numbers = {};
    records_ = Buffer<PlacedRecord<Dim>, E>(executor_, count);
    executor_.for_each(count, GatherRecord<Dim>{numbers_.data(), records.data(), records_.data()});
  }

  /// At most 2 N heads and two more, however many cells there are.
  void write_directory() {
    const std::uint64_t count = elements_.count;
    shift_ = 0;
    while (frame_.key_count >> shift_ > 2 * count) ++shift_;
    const std::uint64_t heads = (frame_.key_count >> shift_) + 2;
    heads_ = Buffer<std::uint32_t, E>(executor_, heads);
    executor_.for_each(heads, FillArray<std::uint32_t>{heads_.data(), unset_head});
    executor_.for_each(count, HeadsOfSlot<Key>{keys_.data(), heads_.data(), shift_});
    executor_.for_each(heads, FindHead<Key>{keys_.data(), elements_.count, heads_.data(), shift_});
  }

  void gather_sizes() {
    sizes_ = Buffer<Size, E>(executor_, elements_.count);
    executor_.for_each(elements_.count,
                       GatherSize<Spheres>{elements_, frame_, numbers_.data(), sizes_.data()});
  }

  E& executor_;
  Spheres elements_;
  Frame<Dim> frame_;
  Buffer<Key, E> keys_;
  Buffer<std::uint32_t, E> numbers_;
  Buffer<PlacedRecord<Dim>, E> records_;
  Buffer<std::uint32_t, E> heads_;
  Buffer<Size, E> sizes_;  ///< empty where all spheres are equal
  int shift_ = 0;
};

}  // namespace abut::device
