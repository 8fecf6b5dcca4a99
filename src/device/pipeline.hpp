#pragma once

#include "base/progress_reporter.hpp"
#include "device/axis_stretches.hpp"
#include "device/bodies/check.hpp"
#include "device/bodies/decide.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/order_row.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/size_class.hpp"
#include "device/contact_search.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/frame.hpp"
#include "device/levels.hpp"
#include "elements/reject_element.hpp"

#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace abut::device {

/// The contact pairs in canonical order, in the memory of an executor.
template <class E>
struct FoundList {
  Buffer<ContactPair, E> pairs;
  std::uint64_t count = 0;  ///< of the pairs; there is room for more
  std::uint64_t exact_decisions = 0;
};

/// One detection of spheres in an open domain, stage by stage, on any executor:
/// check, frame, place and sort, count, write, decide, order. The host waits where it must know a
/// number: the extent, the numbers of pairs, of contacts among those in doubt, the longest row.
template <int Dim, class T, class E>
class Pipeline {
 public:
  Pipeline(E& executor, const SphereColumns<Dim, T>& elements, const DeviceRequest& request,
           base::ProgressReporter& progress)
      : executor_(executor), elements_(elements), request_(request), progress_(progress) {}

  /// All contact pairs.
  [[nodiscard]] FoundList<E> list() {
    FoundList<E> found;
    search([&](auto& contacts) { write_and_decide(contacts, found); });
    order(found);
    return found;
  }

  /// Their number. Only pairs in doubt take memory.
  [[nodiscard]] FoundList<E> count() {
    FoundList<E> found;
    search([&](auto& contacts) {
      const PartnerCount totals = contacts.totals();
      Buffer<ContactPair, E> doubtful(executor_, totals.doubtful);
      contacts.write(nullptr, doubtful.data());
      decide(doubtful.data(), totals.doubtful);
      Buffer<ContactPair, E> kept(executor_, totals.doubtful);
      found.count = totals.certain + keep_contacts(doubtful.data(), kept.data(), totals.doubtful);
      found.exact_decisions = totals.doubtful;
    });
    require_count(found.count);
    return found;
  }

 private:
  using Stretches = AxisStretches<Dim, T, E>;

  template <class Use>
  void search(Use&& use) {
    progress_.begin("gather", elements_.count);
    if (elements_.count == 0) return;
    const Extent<Dim> extent = checked_extent();
    if (extent.smallest_radius == extent.largest_radius) take_common(extent.largest_radius);
    progress_.begin("search", elements_.count);
    std::vector<Stretches> stretches;  // as long as the search, which looks into them
    const Frame<Dim> frame = frame_of(extent, stretches);
    if (frame.key_count <= std::numeric_limits<std::uint32_t>::max()) {
      ContactSearch<Dim, T, std::uint32_t, E> contacts(executor_, elements_, frame, request_);
      use(contacts);
    } else {
      ContactSearch<Dim, T, std::uint64_t, E> contacts(executor_, elements_, frame, request_);
      use(contacts);
    }
  }

  /// Radii that are all equal need not be read again.
  void take_common(double radius) noexcept {
    elements_.radii.first = nullptr;
    elements_.common_radius = radius;
  }

  [[nodiscard]] Extent<Dim> checked_extent() {
    const Extent<Dim> extent = executor_.reduce(elements_.count, Extent<Dim>::of_none(),
                                                ElementExtent<Dim, T>{elements_}, JoinExtents{});
    if (extent.first_bad != no_element) {
      elements::reject_element(extent.first_bad, sphere_on_host(extent.first_bad));
    }
    return extent;
  }

  [[nodiscard]] exact::Sphere<Dim> sphere_on_host(std::uint32_t number) {
    const auto number_of = [&](const typename SphereColumns<Dim, T>::Column& column) {
      T value{};
      const std::byte* const place =
          column.first + static_cast<std::ptrdiff_t>(number) * column.stride_bytes;
      executor_.copy_to_host(&value, reinterpret_cast<const T*>(place), 1);
      return static_cast<double>(value);
    };
    exact::Sphere<Dim> sphere{};
    for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = number_of(elements_.center[axis]);
    sphere.radius =
        elements_.radii.first == nullptr ? elements_.common_radius : number_of(elements_.radii);
    return sphere;
  }

  [[nodiscard]] Frame<Dim> frame_of(const Extent<Dim>& extent, std::vector<Stretches>& stretches) {
    Frame<Dim> frame = make_frame(extent, request_.margin);
    set_levels(frame, extent);
    for (std::uint32_t k = 0; k < frame.level_count; ++k) {
      SizeLevel<Dim>& level = frame.levels[k];
      const CellWidths widths =
          lay_out(level, frame.level_count == 1 ? extent : extent_of_level(frame, k), frame);
      if (widths.narrowest == widths.in_one_piece) continue;
      stretches.emplace_back(executor_, elements_, frame, k);
      stretches.back().lay_out(level, widths);
    }
    number_keys(frame);
    return frame;
  }

  /// Divides the elements into levels, which have slots then.
  void set_levels(Frame<Dim>& frame, const Extent<Dim>& extent) {
    Levels levels;
    levels.ends[0] = std::numeric_limits<double>::infinity();
    levels.elements[0] = elements_.count;
    if (extent.smallest_radius < extent.largest_radius) {
      levels = choose_levels(size_counts(extent), extent, request_.margin);
    }
    frame.level_count = levels.count;
    std::uint64_t slot = 0;
    for (std::uint32_t k = 0; k < levels.count; ++k) {
      frame.levels[k].radius_end = levels.ends[k];
      frame.levels[k].first_slot = static_cast<std::uint32_t>(slot);
      slot += levels.elements[k];
      frame.levels[k].end_slot = static_cast<std::uint32_t>(slot);
    }
  }

  [[nodiscard]] Extent<Dim> extent_of_level(const Frame<Dim>& frame, std::uint32_t level) {
    return executor_.reduce(elements_.count, Extent<Dim>::of_none(),
                            ExtentInLevel<Dim, T>{elements_, frame, level}, JoinExtents{});
  }

  [[nodiscard]] SizeCounts size_counts(const Extent<Dim>& extent) {
    Buffer<std::uint64_t, E> bins(executor_, size_classes);
    executor_.histogram(bins.data(), size_classes, elements_.count,
                        SizeClassOf<Dim, T>{elements_, half_octave_of(extent.largest_radius)});
    SizeCounts counts{};
    executor_.copy_to_host(counts.data(), bins.data(), size_classes);
    return counts;
  }

  template <class Contacts>
  void write_and_decide(Contacts& contacts, FoundList<E>& found) {
    const PartnerCount totals = contacts.totals();
    require_count(totals.certain);
    found.pairs = Buffer<ContactPair, E>(executor_, totals.certain + totals.doubtful);
    ContactPair* const doubtful = found.pairs.data() + totals.certain;
    contacts.write(found.pairs.data(), doubtful);
    decide(doubtful, totals.doubtful);
    Buffer<ContactPair, E> copy(executor_, totals.doubtful);
    const std::uint64_t kept = keep_contacts(doubtful, copy.data(), totals.doubtful);
    executor_.for_each(kept, CopyPair{copy.data(), doubtful});
    found.count = totals.certain + kept;
    found.exact_decisions = totals.doubtful;
    require_count(found.count);
  }

  void decide(ContactPair* doubtful, std::uint64_t count) {
    executor_.for_each(count, DecideMost<Dim, T>{elements_, request_.margin, doubtful});
    executor_.for_each(count, DecideOpen<Dim, T>{elements_, request_.margin, doubtful});
  }

  [[nodiscard]] std::uint64_t keep_contacts(const ContactPair* pairs, ContactPair* kept,
                                            std::uint64_t count) {
    return count == 0 ? 0 : executor_.select(pairs, kept, count, ContactTester{});
  }

  /// By `first` alone where rows are short enough to be sorted one by one, else by both.
  void order(FoundList<E>& found) {
    progress_.begin("order", found.count);
    if (found.count < 2) return;
    const auto bits = static_cast<int>(std::bit_width(elements_.count));
    TwinBuffer<ContactPair, E> pairs;
    pairs.current.swap(found.pairs);
    pairs.other = Buffer<ContactPair, E>(executor_, pairs.current.size());
    executor_.sort_pairs(pairs, found.count, 0, bits);
    const std::uint32_t longest = executor_.reduce(
        found.count, std::uint32_t{0}, RowLength{pairs.current.data(), found.count}, Larger{});
    if (longest <= longest_short_row) {
      executor_.for_each(found.count, OrderRow{pairs.current.data(), found.count});
    } else {
      executor_.sort_pairs(pairs, found.count, 32, 32 + bits);
      executor_.sort_pairs(pairs, found.count, 0, bits);
    }
    found.pairs.swap(pairs.current);
  }

  void require_count(std::uint64_t contacts) const {
    if (contacts <= request_.max_pairs) return;
    throw Error(ErrorCode::limit_exceeded,
                "there are more than " + std::to_string(request_.max_pairs) +
                    " contact pairs, the limit that was set; raise it, or count the pairs "
                    "without storing them");
  }

  E& executor_;
  SphereColumns<Dim, T> elements_;
  DeviceRequest request_;
  base::ProgressReporter& progress_;
};

}  // namespace abut::device
