#pragma once

#include "device/axis_stretches.hpp"
#include "device/bodies/check.hpp"
#include "device/bodies/decide.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/place.hpp"
#include "device/checked_elements.hpp"
#include "device/contact_search.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"
#include "device/frame.hpp"
#include "device/levels.hpp"
#include "lattice/check_range.hpp"

#include <abut/pair.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace abut::device {

/// The stages from valid spheres to decided pairs: frame, place and sort, count, write, decide.
/// Pairs have the numbers of the spheres that are searched, the smaller one first.
template <class Spheres, class E>
class Detection {
  static constexpr int Dim = Spheres::dimensions;

 public:
  /// `extent` is that of the spheres, margin and slack in `settings` are in their unit.
  Detection(E& executor, const Spheres& spheres, const Extent<Dim>& extent,
            const DeviceRequest& request, const SearchSettings& settings)
      : executor_(executor),
        spheres_(spheres),
        extent_(extent),
        request_(request),
        settings_(settings) {}

  /// All contact pairs, in no order.
  void list(FoundList<E>& found) {
    found.searched = spheres_.count;
    search([&](auto& contacts) { write_and_decide(contacts, found); });
  }

  /// Their number. Only pairs in doubt take memory.
  void count(FoundList<E>& found) {
    found.searched = spheres_.count;
    search([&](auto& contacts) {
      const PartnerCount totals = contacts.totals();
      Buffer<ContactPair, E> doubtful(executor_, totals.doubtful);
      contacts.write(nullptr, doubtful.data());
      decide(doubtful.data(), totals.doubtful);
      Buffer<ContactPair, E> kept(executor_, totals.doubtful);
      found.count = totals.certain + keep_contacts(doubtful.data(), kept.data(), totals.doubtful);
      found.exact_decisions = totals.doubtful;
      found.candidate_tests = totals.tests;
    });
    require_count(found.count, request_.max_pairs);
  }

 private:
  using Stretches = AxisStretches<Spheres, E>;

  template <class Use>
  void search(Use&& use) {
    std::vector<Stretches> stretches;  // as long as the search, which looks into them
    const Frame<Dim> frame = make_levels(stretches);
    if (frame.key_count <= std::numeric_limits<std::uint32_t>::max()) {
      ContactSearch<Spheres, std::uint32_t, E> contacts(executor_, spheres_, frame, settings_);
      use(contacts);
    } else {
      ContactSearch<Spheres, std::uint64_t, E> contacts(executor_, spheres_, frame, settings_);
      use(contacts);
    }
  }

  [[nodiscard]] Frame<Dim> make_levels(std::vector<Stretches>& stretches) {
    Frame<Dim> frame = make_frame(extent_, settings_.margin, settings_.slack);
    set_levels(frame);
    const std::vector<Extent<Dim>> extents = extents_of_levels(frame);
    for (std::uint32_t k = 0; k < frame.level_count; ++k) {
      SizeLevel<Dim>& level = frame.levels[k];
      const CellWidths widths = lay_out(level, extents[k], frame);
      if (widths.narrowest == widths.in_one_piece) continue;
      stretches.emplace_back(executor_, spheres_, frame, k);
      stretches.back().lay_out(level, widths);
    }
    number_keys(frame);
    return frame;
  }

  /// Divides the elements into levels, which have slots then.
  void set_levels(Frame<Dim>& frame) {
    Levels levels;
    levels.ends[0] = std::numeric_limits<double>::infinity();
    levels.elements[0] = spheres_.count;
    if (extent_.smallest_radius < extent_.largest_radius) {
      levels = choose_levels(count_sizes(executor_, spheres_, extent_), extent_, settings_.margin);
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

  /// Waits once for all levels: the host lays their cells out.
  [[nodiscard]] std::vector<Extent<Dim>> extents_of_levels(const Frame<Dim>& frame) {
    if (frame.level_count == 1) return {extent_};
    std::vector<Extent<Dim>> extents(frame.level_count);
    Buffer<Extent<Dim>, E> on_device(executor_, frame.level_count);
    for (std::uint32_t k = 0; k < frame.level_count; ++k) {
      executor_.reduce_into(on_device.data() + k, spheres_.count, Extent<Dim>::of_none(),
                            ExtentInLevel<Spheres>{spheres_, frame, k}, JoinExtents{});
    }
    executor_.copy_to_host(extents.data(), on_device.data(), frame.level_count);
    return extents;
  }

  template <class Contacts>
  void write_and_decide(Contacts& contacts, FoundList<E>& found) {
    const PartnerCount totals = contacts.totals();
    require_count(totals.certain, request_.max_pairs);
    found.pairs = Buffer<ContactPair, E>(executor_, totals.certain + totals.doubtful);
    ContactPair* const doubtful = found.pairs.data() + totals.certain;
    contacts.write(found.pairs.data(), doubtful);
    decide(doubtful, totals.doubtful);
    Buffer<ContactPair, E> copy(executor_, totals.doubtful);
    const std::uint64_t kept = keep_contacts(doubtful, copy.data(), totals.doubtful);
    executor_.for_each(kept, CopyEntry<ContactPair>{copy.data(), doubtful});
    found.count = totals.certain + kept;
    found.exact_decisions = totals.doubtful;
    found.candidate_tests = totals.tests;
    require_count(found.count, request_.max_pairs);
  }

  void decide(ContactPair* doubtful, std::uint64_t count) {
    executor_.for_each(count, DecideMost<Spheres>{spheres_, request_.margin, doubtful});
    executor_.for_each(count, DecideOpen<Spheres>{spheres_, request_.margin, doubtful});
    if (count == 0 || spheres_.decides_all()) return;
    const std::uint64_t open =
        executor_.reduce(count, PlaceOfOpenPair::no_place, PlaceOfOpenPair{doubtful}, Smaller{});
    if (open == PlaceOfOpenPair::no_place) return;
    ContactPair pair{};
    executor_.copy_to_host(&pair, doubtful + open, 1);
    lattice::refuse_shift(element_on_host(executor_, spheres_, pair.first),
                          element_on_host(executor_, spheres_, pair.second));
  }

  [[nodiscard]] std::uint64_t keep_contacts(const ContactPair* pairs, ContactPair* kept,
                                            std::uint64_t count) {
    // Waits: how many are contacts is the length of the list, which may not pass a limit.
    return count == 0 ? 0 : executor_.select(pairs, kept, count, ContactTester{});
  }

  E& executor_;
  Spheres spheres_;
  Extent<Dim> extent_;
  DeviceRequest request_;
  SearchSettings settings_;
};

}  // namespace abut::device
