#pragma once

#include "device/bodies/cross_level.hpp"
#include "device/bodies/meet.hpp"
#include "device/executor.hpp"
#include "device/part_sums.hpp"
#include "device/partner_search.hpp"
#include "device/sorted_elements.hpp"

#include <cstdint>
#include <limits>
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
    count_levels();
    count_coarse();
  }

  [[nodiscard]] const PartnerCount& totals() const noexcept { return totals_; }
  [[nodiscard]] const Spheres& elements() const noexcept { return elements_; }

  /// Writes totals().certain pairs, unless `certain` is null, and totals().doubtful pairs.
  void write(ContactPair* certain, ContactPair* doubtful) {
    const auto write_next = [&](auto& search, std::uint64_t part, const PartnerCount& sums) {
      if (sums.doubtful > 0 || (sums.certain > 0 && certain != nullptr)) {
        search.write(part, certain, doubtful);
      }
      if (certain != nullptr) certain += sums.certain;
      doubtful += sums.doubtful;
    };
    auto sums_of_part = sums_of_coarse_.begin();
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      write_next(meets_[k], 0, counts_[k].meets);
      with_coarse(k, [&](CrossLevelSearch& search) {
        for (std::uint64_t part = 0; part < search.part_count(); ++part) {
          write_next(search, part, *sums_of_part++);
        }
      });
    }
  }

 private:
  using Meet = MeetInLevel<Spheres, Key>;
  using Across = MeetCoarse<Spheres, Key>;
  using CrossLevelSearch = PartnerSearch<Across, E>;

  /// What the host must know of a level.
  struct LevelCounts {
    PartnerCount meets;
    std::uint64_t items_of_coarse;
  };

  /// Waits once for all levels: the host takes memory for as many items as larger elements make,
  /// part by part.
  void count_levels() {
    Buffer<LevelCounts, E> on_device(executor_, frame_.level_count);
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      const SizeLevel<Dim>& level = frame_.levels[k];
      LevelCounts* const counts = on_device.data() + k;
      meets_.emplace_back(executor_, meet_in(level), level.first_slot,
                          level.end_slot - level.first_slot,
                          std::numeric_limits<std::uint64_t>::max());
      meets_.back().count(0, &counts->meets);
      executor_.reduce_into(&counts->items_of_coarse, coarse_of(k), std::uint64_t{0},
                            ItemsOfCoarse<Across>{across(k, nullptr)}, SumOfTwo{});
    }
    counts_.resize(frame_.level_count);
    executor_.copy_to_host(counts_.data(), on_device.data(), frame_.level_count);
    for (const LevelCounts& counts : counts_) totals_.add(counts.meets);
  }

  /// Waits once for all levels.
  void count_coarse() {
    PartSums<E> sums(executor_);
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      with_coarse(k, [&](CrossLevelSearch& search) {
        for (std::uint64_t part = 0; part < search.part_count(); ++part) {
          search.count(part, sums.next());
        }
      });
    }
    sums.collect();
    sums_of_coarse_ = sums.on_host();
    for (const PartnerCount& some : sums_of_coarse_) totals_.add(some);
  }

  [[nodiscard]] Meet meet_in(const SizeLevel<Dim>& level) const {
    Meet meet{elements_, sorted_.records(), sorted_.directory(), sorted_.sizes(level), {}};
    for (int axis = 0; axis < Dim; ++axis) meet.pitch[axis] = level.pitch[axis];
    return meet;
  }

  /// How many larger elements look for partners in a level.
  [[nodiscard]] std::uint64_t coarse_of(std::uint32_t k) const noexcept {
    const SizeLevel<Dim>& level = frame_.levels[k];
    return level.first_slot == level.end_slot ? 0 : elements_.count - level.end_slot;
  }

  [[nodiscard]] Across across(std::uint32_t k, const std::uint64_t* items_before) const {
    const CoarseScales scales{frame_.scale, frame_.margin, frame_.slack, settings_.margin,
                              settings_.slack};
    return {
        elements_,           scales,      frame_.levels[k], sorted_.records(), sorted_.all_sizes(),
        sorted_.directory(), items_before};
  }

  /// Calls use(search) with the search of all larger elements through a level. Their items are
  /// counted anew each time, so that the memory of one level is enough.
  template <class Use>
  void with_coarse(std::uint32_t k, Use&& use) {
    if (counts_[k].items_of_coarse == 0) return;
    const std::uint64_t coarse = coarse_of(k);
    Buffer<std::uint64_t, E> items(executor_, coarse + 1);
    const Across its_across = across(k, items.data());
    executor_.for_each(coarse + 1, CountItems<Across>{its_across, coarse, items.data()});
    executor_.exclusive_scan(items.data(), coarse + 1);
    CrossLevelSearch search(executor_, its_across, 0, counts_[k].items_of_coarse,
                            settings_.items_at_a_time);
    use(search);
  }

  E& executor_;
  Spheres elements_;
  Frame<Dim> frame_;
  SearchSettings settings_;
  Sorted sorted_;
  std::vector<PartnerSearch<Meet, E>> meets_;
  std::vector<LevelCounts> counts_;
  std::vector<PartnerCount> sums_of_coarse_;  ///< of each part of each level
  PartnerCount totals_;
};

}  // namespace abut::device
