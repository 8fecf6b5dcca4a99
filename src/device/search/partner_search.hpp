#pragma once

#include "device/bodies/partners.hpp"
#include "device/executor.hpp"

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
/// so that no capacity need be guessed. Searches of more items than `at_a_time` have several parts,
/// which are counted one by one, and once more when pairs are written, so that memory does not
/// follow the items.
template <class Search, class E>
class PartnerSearch {
 public:
  PartnerSearch(E& executor, const Search& search, std::uint64_t first_item, std::uint64_t items,
                std::uint64_t at_a_time)
      : executor_(executor),
        search_(search),
        first_item_(first_item),
        items_(items),
        items_of_part_(std::max<std::uint64_t>(std::min(items, at_a_time), 1)),
        certain_(executor, items_of_part_ + 1),
        doubtful_(executor, items_of_part_ + 1) {}

  [[nodiscard]] std::uint64_t part_count() const noexcept {
    return items_ / items_of_part_ + (items_ % items_of_part_ == 0 ? 0 : 1);
  }

  /// Counts the partners of a part's items, and puts their sums on the device. Waits for nothing.
  void count(std::uint64_t part, PartnerCount* sums) {
    const std::uint64_t items = items_of(part);
    executor_.reduce_into(&sums->tests, items, std::uint64_t{0},
                          TestsOfItem<Search>{search_, first_of(part)}, SumOfTwo{});
    give_places(part);
    executor_.for_each(1,
                       GatherPartnerCount{certain_.data() + items, doubtful_.data() + items, sums});
  }

  /// Writes the certain pairs of a part, unless `certain` is null, and those in doubt.
  void write(std::uint64_t part, ContactPair* certain, ContactPair* doubtful) {
    write_by(part, certain, doubtful, [](const FillPartners<Search>& fill) { return fill; });
  }

  /// Does that by the bodies that body_of makes of FillPartners.
  template <class BodyOf>
  void write_by(std::uint64_t part, ContactPair* certain, ContactPair* doubtful,
                const BodyOf& body_of) {
    if (part != part_with_places_) give_places(part);
    executor_.for_each(items_of(part), body_of(FillPartners<Search>{search_, first_of(part),
                                                                    places(), certain, doubtful}));
  }

 private:
  [[nodiscard]] std::uint64_t first_of(std::uint64_t part) const noexcept {
    return first_item_ + part * items_of_part_;
  }
  [[nodiscard]] std::uint64_t items_of(std::uint64_t part) const noexcept {
    return std::min(items_of_part_, items_ - part * items_of_part_);
  }
  [[nodiscard]] PartnerPlaces places() const noexcept {
    return {ItemNumbers(certain_.data()), ItemNumbers(doubtful_.data())};
  }

  void give_places(std::uint64_t part) {
    const std::uint64_t items = items_of(part);
    executor_.for_each(items + 1, CountPartners<Search>{search_, first_of(part), items, places()});
    executor_.exclusive_scan(certain_.data(), items + 1);
    executor_.exclusive_scan(doubtful_.data(), items + 1);
    part_with_places_ = part;
  }

  E& executor_;
  Search search_;
  std::uint64_t first_item_;
  std::uint64_t items_;
  std::uint64_t items_of_part_;
  Buffer<std::uint64_t, E> certain_;
  Buffer<std::uint64_t, E> doubtful_;
  std::uint64_t part_with_places_ = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace abut::device
