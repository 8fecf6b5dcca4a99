#pragma once

#include "device/bodies/cross_level.hpp"
#include "device/bodies/meet.hpp"
#include "device/executor.hpp"
#include "device/partner_search.hpp"
#include "device/sorted_elements.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace abut::device {

/// What a search is asked for, in the unit of its spheres.
struct SearchSettings {
  double margin;
  double slack;  ///< of distances
  std::uint64_t items_at_a_time;
};

/// Finds the pairs of all levels: elements of a level meet each other, and larger ones meet it.
template <class Spheres, class Key, class E>
class ContactSearch {
  static constexpr int Dim = Spheres::dimensions;

 public:
  using Sorted = SortedElements<Spheres, Key, E>;

  ContactSearch(E& executor, const Spheres& elements, const Frame<Dim>& frame,
                const SearchSettings& settings)
      : executor_(executor),
        elements_(elements),
        frame_(frame),
        settings_(settings),
        sorted_(executor, elements, frame) {
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      const SizeLevel<Dim>& level = frame_.levels[k];
      const Meet meet = meet_in(level);
      meets_.emplace_back(executor_, meet, level.first_slot, level.end_slot - level.first_slot,
                          std::numeric_limits<std::uint64_t>::max());
      add(meets_.back().totals());
      with_coarse(k, [this](CrossLevelSearch& search) { add(search.totals()); });
    }
  }

  [[nodiscard]] const PartnerCount& totals() const noexcept { return totals_; }
  [[nodiscard]] const Spheres& elements() const noexcept { return elements_; }

  /// Writes totals().certain pairs, unless `certain` is null, and totals().doubtful pairs.
  void write(ContactPair* certain, ContactPair* doubtful) {
    const auto write_next = [&](auto& search) {
      search.write(certain, doubtful);
      if (certain != nullptr) certain += search.totals().certain;
      doubtful += search.totals().doubtful;
    };
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      write_next(meets_[k]);
      with_coarse(k, write_next);
    }
  }

 private:
  using Meet = MeetInLevel<Spheres, Key>;
  using Across = MeetCoarse<Spheres, Key>;
  using CrossLevelSearch = PartnerSearch<Across, E>;

  void add(const PartnerCount& some) noexcept {
    totals_.certain += some.certain;
    totals_.doubtful += some.doubtful;
    totals_.tests += some.tests;
  }

  [[nodiscard]] Meet meet_in(const SizeLevel<Dim>& level) const {
    Meet meet{elements_, sorted_.records(), sorted_.directory(), sorted_.sizes(level), {}};
    for (int axis = 0; axis < Dim; ++axis) meet.pitch[axis] = level.pitch[axis];
    return meet;
  }

  /// Calls use(search) with the search of all larger elements through a level. They are counted
  /// anew each time, so that the memory of one level is enough.
  template <class Use>
  void with_coarse(std::uint32_t k, Use&& use) {
    const SizeLevel<Dim>& level = frame_.levels[k];
    const std::uint64_t coarse = elements_.count - level.end_slot;
    if (coarse == 0 || level.first_slot == level.end_slot) return;
    Buffer<std::uint64_t, E> items(executor_, coarse + 1);
    const CoarseScales scales{frame_.scale, frame_.margin, frame_.slack, settings_.margin,
                              settings_.slack};
    const Across across{
        elements_,           scales,      level, sorted_.records(), sorted_.all_sizes(),
        sorted_.directory(), items.data()};
    executor_.for_each(coarse + 1, CountItems<Across>{across, coarse, items.data()});
    const std::uint64_t all = sum_before_each(executor_, items.data(), coarse);
    CrossLevelSearch search(executor_, across, 0, all, settings_.items_at_a_time);
    use(search);
  }

  E& executor_;
  Spheres elements_;
  Frame<Dim> frame_;
  SearchSettings settings_;
  Sorted sorted_;
  std::vector<PartnerSearch<Meet, E>> meets_;
  PartnerCount totals_;
};

}  // namespace abut::device
