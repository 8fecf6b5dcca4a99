#pragma once

#include "device/bodies/directory.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/meet.hpp"
#include "device/bodies/order_images.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sizes.hpp"
#include "device/bodies/sorted_stretches.hpp"
#include "device/bodies/stretch.hpp"
#include "device/executor.hpp"
#include "device/search/axis_stretches.hpp"

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
    find_slots_of_stretches();
    write_directory();
    if (frame_.level_count > 1 || !elements_.has_common_radius()) gather_sizes();
    numbers_ = {};
  }

  /// The levels; larger elements find their cells in those that are divided by what is sorted here.
  [[nodiscard]] const Frame<Dim>& frame() const noexcept { return frame_; }
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
    TwinBuffer<Key, E> keys;
    TwinBuffer<std::uint32_t, E> numbers;
    keys.current = Buffer<Key, E>(executor_, count);
    numbers.current = Buffer<std::uint32_t, E>(executor_, count);
    Buffer<PlacedRecord<Dim>, E> records(executor_, count);
    executor_.for_each(count, PlaceElement<Spheres, Key>{elements_, frame_, keys.current.data(),
                                                         numbers.current.data(), records.data()});
    if (has_divided_axes()) {
      numbers.current = {};
      place_on_axes(keys.current.data(), records.data());
      numbers.current = Buffer<std::uint32_t, E>(executor_, count);
      executor_.for_each(count, FillInOrder{numbers.current.data()});
    }
    keys.other = Buffer<Key, E>(executor_, count);
    numbers.other = Buffer<std::uint32_t, E>(executor_, count);
    executor_.sort_by_key(keys, numbers, count,
                          static_cast<int>(std::bit_width(frame_.key_count - 1)));
    keys_.swap(keys.current);
    numbers_.swap(numbers.current);
    keys = {};
    numbers = {};
    records_ = Buffer<PlacedRecord<Dim>, E>(executor_, count);
    executor_.for_each(count, GatherRecord<Dim>{numbers_.data(), records.data(), records_.data()});
  }

  [[nodiscard]] bool has_divided_axes() const noexcept {
    bool any = false;
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      any = any || frame_.levels[k].axes[0].is_divided();
    }
    return any;
  }

  /// Stretches of one axis at a time: what they take would be most of all memory otherwise. Larger
  /// elements find their cells by the lowest element of each.
  void place_on_axes(Key* keys, PlacedRecord<Dim>* records) {
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      const SizeLevel<Dim>& level = frame_.levels[k];
      if (!level.axes[0].is_divided()) continue;
      std::uint64_t keys_of_cell = 1;
      for (int axis = 0; axis < Dim; ++axis) {
        AxisStretches<Spheres, E> stretches(executor_, elements_, frame_, k, axis);
        stretches.divide(level.widest_gap, level.axes[axis].stretch_count);
        if (level.end_slot < elements_.count) {
          first_of_stretches_[k][axis] = stretches.first_elements();
        }
        stretches.forget_numbers();
        executor_.for_each(elements_.count,
                           PlaceAlongAxis<Spheres, Key>{elements_, frame_, k, axis,
                                                        stretches.number_cells(level.units_of_one),
                                                        keys_of_cell, keys, records});
        keys_of_cell *= level.pitch[axis];
      }
    }
  }

  /// Tells the lowest elements of stretches by their slots.
  void find_slots_of_stretches() {
    Buffer<std::uint32_t, E> slots;
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      for (int axis = 0; axis < Dim; ++axis) {
        const Buffer<std::uint32_t, E>& first = first_of_stretches_[k][axis];
        if (first.size() == 0) continue;
        if (slots.size() == 0) {
          slots = Buffer<std::uint32_t, E>(executor_, elements_.count);
          executor_.for_each(elements_.count, WriteSlot{numbers_.data(), slots.data()});
        }
        executor_.for_each(first.size(), GatherInPlace{slots.data(), first.data()});
        frame_.levels[k].axes[axis].first_slots = first.data();
      }
    }
  }

  /// At most 2 N heads and two more, however many cells there are; N where most cells are empty and
  /// memory is needed for stretches.
  void write_directory() {
    const std::uint64_t count = elements_.count;
    shift_ = 0;
    const std::uint64_t most = has_divided_axes() ? count : 2 * count;
    while (frame_.key_count >> shift_ > most) ++shift_;
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
  Buffer<std::uint32_t, E> first_of_stretches_[most_levels][Dim];  ///< elements, then their slots
  Buffer<Size, E> sizes_;  ///< empty where all spheres are equal
  int shift_ = 0;
};

}  // namespace abut::device
