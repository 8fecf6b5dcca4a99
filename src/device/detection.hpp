#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/place.hpp"
#include "device/checked_elements.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"
#include "device/frame.hpp"
#include "device/levels.hpp"
#include "device/pair_decision.hpp"
#include "device/search/contact_search.hpp"
#include "device/search/search_settings.hpp"
#include "device/search/stretch_layout.hpp"

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
    Frame<Dim> frame = make_frame(extent_, settings_.margin, settings_.slack);
    set_levels(frame);
    const std::vector<Extent<Dim>> extents = extents_of_levels(frame);
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

  E& executor_;
  Spheres spheres_;
  Extent<Dim> extent_;
  SearchSettings settings_;
  PairDecision<E> decision_;
};

}  // namespace abut::device
