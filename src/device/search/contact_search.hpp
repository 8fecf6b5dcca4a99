#pragma once

#include "device/bodies/cell_box.hpp"
#include "device/bodies/cross_level.hpp"
#include "device/bodies/meet.hpp"
#include "device/bodies/sorted_stretches.hpp"
#include "device/executor.hpp"
#include "device/search/level_search.hpp"
#include "device/search/part_sums.hpp"
#include "device/search/partner_search.hpp"
#include "device/search/search_settings.hpp"
#include "device/search/sorted_elements.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace abut::device {

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
        settings_(settings),
        sorted_(executor, elements, frame),
        frame_(sorted_.frame()) {
    count_levels();
    count_coarse();
  }

  [[nodiscard]] const PartnerCount& totals() const noexcept { return totals_; }
  [[nodiscard]] const Spheres& elements() const noexcept { return elements_; }

  /// Writes totals().certain pairs, unless `certain` is null, and totals().doubtful pairs.
  void write(ContactPair* certain, ContactPair* doubtful) {
    const auto write_next = [&](const PartnerCount& sums, const auto& write_pairs) {
      if (sums.doubtful > 0 || (sums.certain > 0 && certain != nullptr)) {
        write_pairs(certain, doubtful);
      }
      if (certain != nullptr) certain += sums.certain;
      doubtful += sums.doubtful;
    };
    auto sums_of_coarse = sums_of_coarse_.begin();
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      for (std::uint64_t part = 0; part < meets_[k].part_count(); ++part) {
        const PartnerCount& sums = step(k, part).meets;
        write_next(sums, [&](ContactPair* certain_place, ContactPair* doubtful_place) {
          meets_[k].write(part, sums, certain_place, doubtful_place);
        });
      }
      for_each_coarse_part(k, [&](CrossLevelSearch& search, std::uint64_t part) {
        write_next(*sums_of_coarse++, [&](ContactPair* certain_place, ContactPair* doubtful_place) {
          search.write(part, certain_place, doubtful_place);
        });
      });
    }
  }

 private:
  using Meet = MeetInLevel<Spheres, Key>;
  using Across = MeetCoarse<Spheres, Key>;
  using CrossLevelSearch = PartnerSearch<Across, E>;

  /// Waits once for all levels: the host takes memory for as many items as larger elements make,
  /// part by part.
  void count_levels() {
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      const SizeLevel<Dim>& level = frame_.levels[k];
      meets_.emplace_back(executor_, meet_in(level), SlotRun{level.first_slot, level.end_slot},
                          settings_);
      first_steps_.push_back(steps_.size());
      const std::uint64_t steps = std::max(meets_[k].part_count(), coarse_steps(k));
      steps_.resize(steps_.size() + steps);
    }
    first_steps_.push_back(steps_.size());
    Buffer<StepCounts, E> on_device(executor_, steps_.size());
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      for (std::uint64_t n = first_steps_[k]; n < first_steps_[k + 1]; ++n) {
        count_step(k, n - first_steps_[k], on_device.data() + n);
      }
    }
    executor_.copy_to_host(steps_.data(), on_device.data(), steps_.size());
    for (const StepCounts& counts : steps_) totals_.add(counts.meets);
  }

  void count_step(std::uint32_t k, std::uint64_t n, StepCounts* counts) {
    executor_.for_each(1, FillArray<StepCounts>{counts, {}});
    if (n < meets_[k].part_count()) meets_[k].count(n, &counts->meets);
    const SlotRun coarse = coarse_of(k, n);
    if (coarse.size() == 0) return;
    Buffer<CellBox<Dim>, E> boxes;
    executor_.reduce_into(&counts->items_of_coarse, coarse.size(), std::uint64_t{0},
                          ItemsOfCoarse<Across>{across(k, coarse, boxes)}, SumOfTwo{});
  }

  /// Waits once for all levels.
  void count_coarse() {
    PartSums<E> sums(executor_);
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      for_each_coarse_part(k, [&](CrossLevelSearch& search, std::uint64_t part) {
        search.count(part, sums.next());
      });
    }
    sums.collect();
    sums_of_coarse_ = sums.on_host();
    for (const PartnerCount& some : sums_of_coarse_) totals_.add(some);
  }

  [[nodiscard]] const StepCounts& step(std::uint32_t k, std::uint64_t n) const noexcept {
    return steps_[first_steps_[k] + n];
  }

  [[nodiscard]] Meet meet_in(const SizeLevel<Dim>& level) const {
    Meet meet{elements_, sorted_.records(), sorted_.directory(), sorted_.sizes(level), {}};
    for (int axis = 0; axis < Dim; ++axis) meet.pitch[axis] = level.pitch[axis];
    return meet;
  }

  /// Each has a number of items, and a box where the host cannot tell its cells by few numbers.
  [[nodiscard]] std::uint64_t coarse_at_a_time(std::uint32_t k) const noexcept {
    const std::uint64_t box = is_divided(k) ? sizeof(CellBox<Dim>) : 0;
    return settings_.coarse_at_a_time(sizeof(std::uint64_t) + box);
  }

  [[nodiscard]] bool is_divided(std::uint32_t k) const noexcept {
    return frame_.levels[k].axes[0].is_divided();
  }

  /// In how many steps larger elements look for partners in a level.
  [[nodiscard]] std::uint64_t coarse_steps(std::uint32_t k) const noexcept {
    const SizeLevel<Dim>& level = frame_.levels[k];
    if (level.first_slot == level.end_slot) return 0;
    const std::uint64_t most = coarse_at_a_time(k);
    return (elements_.count - level.end_slot + most - 1) / most;
  }

  /// Those of a step.
  [[nodiscard]] SlotRun coarse_of(std::uint32_t k, std::uint64_t n) const noexcept {
    if (n >= coarse_steps(k)) return {};
    const std::uint64_t most = coarse_at_a_time(k);
    const std::uint64_t first = frame_.levels[k].end_slot + n * most;
    const std::uint64_t end = std::min<std::uint64_t>(first + most, elements_.count);
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
  }

  /// The search of some of the larger elements through a level, without items. `boxes` lives as
  /// long as that.
  [[nodiscard]] Across across(std::uint32_t k, const SlotRun& coarse,
                              Buffer<CellBox<Dim>, E>& boxes) {
    const CoarseScales scales{frame_.scale, frame_.margin, frame_.slack, settings_.margin,
                              settings_.slack};
    Across across{elements_,
                  scales,
                  frame_.levels[k],
                  sorted_.records(),
                  sorted_.all_sizes(),
                  sorted_.directory(),
                  coarse,
                  nullptr,
                  nullptr};
    if (!is_divided(k)) return across;
    boxes = Buffer<CellBox<Dim>, E>(executor_, coarse.size());
    const auto cut = [&]<int axis>(std::integral_constant<int, axis>) {
      executor_.for_each(coarse.size(), FindCoarseCells<Across, std::integral_constant<int, axis>>{
                                            across, boxes.data()});
    };
    cut(std::integral_constant<int, 0>{});
    cut(std::integral_constant<int, 1>{});
    if constexpr (Dim == 3) cut(std::integral_constant<int, 2>{});
    across.boxes = boxes.data();
    return across;
  }

  /// Calls use(search, part) for all parts of the searches of larger elements through a level, some
  /// elements at a time. Their items are counted anew each time, so that memory does not follow
  /// them.
  template <class Use>
  void for_each_coarse_part(std::uint32_t k, const Use& use) {
    for (std::uint64_t n = 0; n < coarse_steps(k); ++n) {
      const std::uint64_t all = step(k, n).items_of_coarse;
      if (all == 0) continue;
      const SlotRun coarse = coarse_of(k, n);
      Buffer<CellBox<Dim>, E> boxes;
      Across its_across = across(k, coarse, boxes);
      Buffer<std::uint64_t, E> items(executor_, coarse.size() + 1);
      executor_.for_each(coarse.size() + 1,
                         CountItems<Across>{its_across, coarse.size(), items.data()});
      executor_.exclusive_scan(items.data(), coarse.size() + 1);
      its_across.items_before = items.data();
      CrossLevelSearch search(executor_, its_across, 0, all, settings_.items_at_a_time);
      for (std::uint64_t part = 0; part < search.part_count(); ++part) use(search, part);
    }
  }

  E& executor_;
  Spheres elements_;
  SearchSettings settings_;
  Sorted sorted_;
  Frame<Dim> frame_;
  std::vector<LevelSearch<Meet, E>> meets_;
  std::vector<std::size_t> first_steps_;  ///< of each level, and behind the last
  std::vector<StepCounts> steps_;
  std::vector<PartnerCount> sums_of_coarse_;  ///< of each part of each level
  PartnerCount totals_;
};

}  // namespace abut::device
