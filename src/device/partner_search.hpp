#pragma once

#include "device/bodies/partners.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace abut::device {

/// Turns `items` counts and a 0 into the sums of those before each; returns the sum of all.
template <class E>
std::uint64_t sum_before_each(E& executor, std::uint64_t* counts, std::uint64_t items) {
  executor.exclusive_scan(counts, items + 1);
  std::uint64_t sum = 0;
  executor.copy_to_host(&sum, counts + items, 1);
  return sum;
}

/// Counts the partners of each item of a search and gives each item its places: count, then fill,
/// so that no capacity need be guessed. Searches of more items than `at_a_time` are counted part by
/// part, and once more when pairs are written, so that memory does not follow the items. Throws
/// Error{limit_exceeded} as soon as a part makes the certain pairs more than `most_pairs`.
template <class Search, class E>
class PartnerSearch {
 public:
  PartnerSearch(E& executor, const Search& search, std::uint64_t first_item, std::uint64_t items,
                std::uint64_t at_a_time,
                std::uint64_t most_pairs = std::numeric_limits<std::uint64_t>::max())
      : executor_(executor),
        search_(search),
        first_item_(first_item),
        items_(items),
        part_(std::max<std::uint64_t>(std::min(items, at_a_time), 1)),
        certain_(executor, part_ + 1),
        doubtful_(executor, part_ + 1),
        counted_(executor, 1) {
    for (std::uint64_t first = 0; first < items_; first += part_) {
      executor_.reduce_into(&counted_.data()->tests, items_of_part(first), std::uint64_t{0},
                            TestsOfItem<Search>{search_, first_item_ + first}, SumOfTwo{});
      const PartnerCount part = count(first);
      totals_.certain += part.certain;
      totals_.doubtful += part.doubtful;
      totals_.tests += part.tests;
      require_count(totals_.certain, most_pairs);
    }
  }

  [[nodiscard]] const PartnerCount& totals() const noexcept { return totals_; }

  /// Writes totals().certain pairs, unless `certain` is null, and totals().doubtful pairs.
  void write(ContactPair* certain, ContactPair* doubtful) {
    write_by(certain, doubtful, [](const FillPartners<Search>& fill) { return fill; });
  }

  /// Does that by the bodies that body_of makes of FillPartners.
  template <class BodyOf>
  void write_by(ContactPair* certain, ContactPair* doubtful, const BodyOf& body_of) {
    for (std::uint64_t first = 0; first < items_; first += part_) {
      const PartnerCount part = part_ < items_ ? count(first) : totals_;
      executor_.for_each(
          items_of_part(first),
          body_of(FillPartners<Search>{search_, first_item_ + first, places(), certain, doubtful}));
      if (certain != nullptr) certain += part.certain;
      doubtful += part.doubtful;
    }
  }

 private:
  [[nodiscard]] std::uint64_t items_of_part(std::uint64_t first) const {
    return std::min(part_, items_ - first);
  }

  [[nodiscard]] PartnerPlaces places() const noexcept {
    return {certain_.data(), doubtful_.data()};
  }

  PartnerCount count(std::uint64_t first) {
    const std::uint64_t items = items_of_part(first);
    executor_.for_each(items + 1,
                       CountPartners<Search>{search_, first_item_ + first, items, places()});
    executor_.exclusive_scan(certain_.data(), items + 1);
    executor_.exclusive_scan(doubtful_.data(), items + 1);
    executor_.for_each(
        1, GatherPartnerCount{certain_.data() + items, doubtful_.data() + items, counted_.data()});
    // Waits: the pairs need memory, which is taken by the host.
    PartnerCount count;
    executor_.copy_to_host(&count, counted_.data(), 1);
    return count;
  }

  E& executor_;
  Search search_;
  std::uint64_t first_item_;
  std::uint64_t items_;
  std::uint64_t part_;
  Buffer<std::uint64_t, E> certain_;
  Buffer<std::uint64_t, E> doubtful_;
  Buffer<PartnerCount, E> counted_;  ///< sums of a part
  PartnerCount totals_;
};

}  // namespace abut::device
