#pragma once

#include "device/bodies/order_images.hpp"
#include "device/bodies/order_row.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"

#include <abut/error.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <bit>
#include <cstdint>
#include <limits>

namespace abut::device {

/// Orders pairs of so many elements, and tells how many are contacts: by `first` alone where rows
/// are short enough to be sorted one by one, else by both.
template <class E>
void order_pairs(E& executor, std::uint64_t elements, FoundList<E>& found) {
  if (found.count == 0) return;
  const auto bits = static_cast<int>(std::bit_width(elements));
  TwinBuffer<ContactPair, E> pairs;
  pairs.current.swap(found.pairs);
  pairs.other = Buffer<ContactPair, E>(executor, pairs.current.size());
  executor.sort_pairs(pairs, found.count, 0, bits);
  // Waits: how many are contacts is the length of the list, which may not pass a limit, and rows
  // that are too long for one thread each are sorted otherwise.
  const OrderSummary summary =
      executor.reduce(found.count, OrderSummary{}, SummaryOfRow{pairs.current.data(), found.count},
                      JoinOrderSummaries{});
  found.count = summary.contacts;
  if (summary.longest <= longest_short_row) {
    executor.for_each(found.count, OrderRow{pairs.current.data(), found.count});
  } else {
    executor.sort_pairs(pairs, found.count, 32, 32 + bits);
    executor.sort_pairs(pairs, found.count, 0, bits);
  }
  found.pairs.swap(pairs.current);
}

/// Orders pairs with their shifts, by (first, second, shift), and tells how many are contacts. A
/// pair and its shift are moved once, in the end; what is sorted is their numbers. Images of one
/// pair are sorted where they stand, or, where there are many, by passes of their own.
template <class E>
class ImageOrder {
 public:
  ImageOrder(E& executor, std::uint64_t elements, FoundList<E>& found)
      : executor_(executor),
        bits_(static_cast<int>(std::bit_width(elements))),
        found_(found),
        keys_(executor, found.count),
        numbers_(executor, found.count) {}

  void order() {
    executor_.for_each(found_.count, FillInOrder{numbers_.current.data()});
    sort_by_pair();
    // Waits for what order_pairs waits for.
    const OrderSummary summary = executor_.reduce(
        found_.count, OrderSummary{}, SummaryOfImages{keys_.current.data(), found_.count, bits_},
        JoinOrderSummaries{});
    found_.count = summary.contacts;
    const std::uint64_t longest = summary.longest;
    if (longest > longest_short_row) sort_by_shift_and_pair();
    keys_.other = {};
    numbers_.other = {};
    gather();
    if (longest > 1 && longest <= longest_short_row) {
      executor_.for_each(found_.count,
                         OrderImages{found_.pairs.data(), found_.shifts.data(), found_.count});
    }
  }

 private:
  void sort_by_pair() {
    executor_.for_each(found_.count, PairKey{found_.pairs.data(), numbers_.current.data(), bits_,
                                             keys_.current.data()});
    executor_.sort_by_key(keys_, numbers_, found_.count, 2 * bits_);
  }

  void sort_by_shift_and_pair() {
    const ImageShift* const shifts = found_.shifts.data();
    for (const bool is_upper : {false, true}) {
      executor_.for_each(found_.count,
                         ShiftKey{shifts, numbers_.current.data(), is_upper, keys_.current.data()});
      executor_.sort_by_key(keys_, numbers_, found_.count, 64);
    }
    sort_by_pair();
  }

  void gather() {
    Buffer<ImageShift, E> shifts(executor_, found_.count);
    executor_.for_each(found_.count,
                       GatherShift{found_.shifts.data(), numbers_.current.data(), shifts.data()});
    found_.shifts.swap(shifts);
    executor_.for_each(found_.count, UnpackPair{keys_.current.data(), bits_, found_.pairs.data()});
  }

  E& executor_;
  int bits_;
  FoundList<E>& found_;
  TwinBuffer<std::uint64_t, E> keys_;
  TwinBuffer<std::uint32_t, E> numbers_;
};

template <class E>
void order_images(E& executor, std::uint64_t elements, FoundList<E>& found) {
  if (found.count == 0) return;
  if (found.count > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::limit_exceeded,
                "a device orders at most 4294967295 pairs with shifts; ask for pairs alone, or "
                "split the system");
  }
  ImageOrder<E>(executor, elements, found).order();
}

}  // namespace abut::device
