#pragma once

#include "base/progress_reporter.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/measure_gap.hpp"
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

/// Measures the gaps of pairs in order.
template <class Given, class E>
void measure_gaps(E& executor, const Given& elements, const DeviceRequest& request,
                  FoundList<E>& found) {
  found.gaps = Buffer<double, E>(executor, found.count);
  const MeasuredPairs<Given> measured{elements,
                                      request.lattice,
                                      found.pairs.data(),
                                      found.shifts.data(),
                                      request.margin == 0.0,
                                      found.gaps.data()};
  executor.for_each(found.count, MeasureGap<Given>{measured});
  executor.for_each(found.count, MeasureOpenGap<Given>{measured});
}

/// Brings what was found into canonical order and into the form that is asked for. Pairs have the
/// numbers of the caller, and shifts where these matter; a list in rows has as many as the first
/// set has elements.
template <class Given, class E>
void finish_list(E& executor, const Given& elements, std::uint64_t rows,
                 const DeviceRequest& request, base::ProgressReporter& progress,
                 FoundList<E>& found) {
  progress.begin("order", found.count);
  if (request.form == ListForm::full_rows) add_reversed(executor, found);
  if (found.shifts.data() != nullptr) {
    order_images(executor, elements.count, found);
  } else {
    order_pairs(executor, elements.count, found);
  }
  require_count(found.contact_pairs(), request.max_pairs);
  if (request.wants_gaps()) {
    progress.begin("measure", found.count);
    measure_gaps(executor, elements, request, found);
  }
  if (request.shifts == Shifts::none) {
    found.shifts = {};
  } else if (found.shifts.data() == nullptr) {
    found.shifts = Buffer<ImageShift, E>(executor, found.count);
    executor.for_each(found.count, FillArray<ImageShift>{found.shifts.data(), {}});
  }
  if (request.form != ListForm::pairs) make_rows(executor, rows, found);
}

}  // namespace abut::device
