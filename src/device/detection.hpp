#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/place.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"
#include "device/frame.hpp"
#include "device/levels.hpp"
#include "device/overview.hpp"
#include "device/pair_decision.hpp"
#include "device/search/contact_search.hpp"
#include "device/search/search_settings.hpp"
#include "device/search/stretch_layout.hpp"

#include <array>
#include <cstdint>
#include <limits>

namespace abut::device {

/// The stages from valid spheres to decided pairs: frame, place and sort, count, write, decide.
/// Pairs have the numbers of the spheres that are searched, the smaller one first.
template <class Spheres, class E>
class Detection {
  static constexpr int Dim = Spheres::dimensions;

 public:
  /// `overview` is that of the spheres, margin and slack in `settings` are in their unit.
  Detection(E& executor, const Spheres& spheres, const Overview<Dim>& overview,
            const DeviceRequest& request, const SearchSettings& settings)
      : executor_(executor),
        spheres_(spheres),
        overview_(overview),
        settings_(settings),
        decision_(executor, request) {}

  /// All contact pairs, in no order.
  void list(FoundList<E>& found) {
    found.searched = spheres_.count;
    search([&](auto& contacts) { decision_.list(contacts, found); });
  }

  /// Their number. Only pairs in doubt take memory.
  void count(FoundList<E>& found) {
    found.searched = spheres_.count;
    search([&](auto& contacts) { decision_.count(contacts, found); });
  }

  /// In which the numbers of pairs are told.
  [[nodiscard]] const Spheres& spheres() const noexcept { return spheres_; }

 private:
  template <class Use>
  void search(Use&& use) {
    const Frame<Dim> frame = make_levels();
    if (frame.key_count <= std::numeric_limits<std::uint32_t>::max()) {
      ContactSearch<Spheres, std::uint32_t, E> contacts(executor_, spheres_, frame, settings_);
      use(contacts);
    } else {
      ContactSearch<Spheres, std::uint64_t, E> contacts(executor_, spheres_, frame, settings_);
      use(contacts);
    }
  }

  [[nodiscard]] Frame<Dim> make_levels() {
    Frame<Dim> frame = make_frame(overview_.all, settings_.margin, settings_.slack);
    set_levels(frame);
    const std::array<Extent<Dim>, most_levels> extents = extents_of_levels(frame);
    for (std::uint32_t k = 0; k < frame.level_count; ++k) {
      SizeLevel<Dim>& level = frame.levels[k];
      const CellWidths widths = lay_out(level, extents[k], frame);
      if (widths.narrowest == widths.in_one_piece) continue;
      StretchLayout<Spheres, E>(executor_, spheres_, frame, k).lay_out(level, widths);
    }
    number_keys(frame);
    return frame;
  }

  /// Divides the elements into levels, which have slots then.
  void set_levels(Frame<Dim>& frame) {
    Levels levels;
    levels.ends[0] = std::numeric_limits<double>::infinity();
    levels.elements[0] = spheres_.count;
    if (overview_.all.smallest_radius < overview_.all.largest_radius) {
      levels = choose_levels(counts_of(overview_), overview_.all, settings_.margin);
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

  /// A level has whole classes.
  [[nodiscard]] std::array<Extent<Dim>, most_levels> extents_of_levels(
      const Frame<Dim>& frame) const {
    std::array<Extent<Dim>, most_levels> extents;
    extents.fill(Extent<Dim>::of_none());
    if (frame.level_count == 1) {
      extents[0] = overview_.all;
      return extents;
    }
    for (const SizeClassNumbers<Dim>& numbers : overview_.classes) {
      if (numbers.elements == 0) continue;
      const Extent<Dim> of_class = extent_of_class<Spheres::shape>(numbers);
      Extent<Dim>& extent = extents[level_of(frame, of_class.largest_radius)];
      extent = JoinExtents{}(extent, of_class);
    }
    return extents;
  }

  E& executor_;
  Spheres spheres_;
  Overview<Dim> overview_;
  SearchSettings settings_;
  PairDecision<E> decision_;
};

}  // namespace abut::device
