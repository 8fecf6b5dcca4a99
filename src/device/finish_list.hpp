#pragma once

#include "base/progress_reporter.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/neighbor_rows.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"
#include "device/order_pairs.hpp"

#include <abut/image_shift.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// How many elements pairs are numbered by, and how many rows they may make.
struct ListSizes {
  std::uint64_t elements;
  std::uint64_t rows;
};

/// Writes each pair once more, as its second element sees it.
template <class E>
void add_reversed(E& executor, FoundList<E>& found) {
  const std::uint64_t count = found.count;
  Buffer<ContactPair, E> pairs(executor, 2 * count);
  executor.for_each(count, CopyEntry<ContactPair>{found.pairs.data(), pairs.data()});
  found.pairs.swap(pairs);
  if (found.shifts.data() != nullptr) {
    Buffer<ImageShift, E> shifts(executor, 2 * count);
    executor.for_each(count, CopyEntry<ImageShift>{found.shifts.data(), shifts.data()});
    found.shifts.swap(shifts);
  }
  executor.for_each(count, ReversePair{found.pairs.data(), found.shifts.data(), count});
  found.count = 2 * count;
  found.entries_of_pair = 2;
}

/// Turns pairs in order into rows.
template <class E>
void make_rows(E& executor, std::uint64_t rows, FoundList<E>& found) {
  found.offsets = Buffer<PairCount, E>(executor, rows + 1);
  executor.for_each(rows + 1, RowOffset{found.pairs.data(), found.count, found.offsets.data()});
  found.neighbors = Buffer<ElementIndex, E>(executor, found.count);
  executor.for_each(found.count, NeighborOfPair{found.pairs.data(), found.neighbors.data()});
  found.pairs = {};
}

/// Brings what was found into canonical order and into the form that is asked for. Pairs have
/// shifts where their domain is periodic, and these matter; in open space all are 0.
template <class E>
void finish_list(E& executor, const ListSizes& sizes, const DeviceRequest& request,
                 base::ProgressReporter& progress, FoundList<E>& found) {
  progress.begin("order", found.count);
  if (request.form == ListForm::full_rows) add_reversed(executor, found);
  if (found.shifts.data() != nullptr) {
    order_images(executor, sizes.elements, found);
  } else {
    order_pairs(executor, sizes.elements, found);
  }
  if (request.shifts == Shifts::stored && found.shifts.data() == nullptr) {
    found.shifts = Buffer<ImageShift, E>(executor, found.count);
    executor.for_each(found.count, FillArray<ImageShift>{found.shifts.data(), {}});
  }
  if (request.form != ListForm::pairs) make_rows(executor, sizes.rows, found);
}

}  // namespace abut::device
