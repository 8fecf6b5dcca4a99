#pragma once

#include "device/bodies/directory.hpp"
#include "device/bodies/partners.hpp"
#include "device/executor.hpp"
#include "device/search/part_sums.hpp"
#include "device/search/partner_search.hpp"
#include "device/search/search_settings.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <cstdint>

namespace abut::device {

/// Counts the partners of the elements of one level and gives each element its places, from the
/// first of its part on: 32 bits for each. A part of more pairs than these can tell is counted once
/// more when pairs are written, some elements at a time, by 64 bits.
template <class Search, class E>
class LevelSearch {
 public:
  LevelSearch(E& executor, const Search& search, const SlotRun& slots,
              const SearchSettings& settings)
      : executor_(executor),
        search_(search),
        slots_(slots),
        settings_(settings),
        certain_(executor, slots.size()),
        doubtful_(executor, slots.size()) {}

  [[nodiscard]] std::uint64_t part_count() const noexcept {
    const std::uint64_t most = settings_.elements_of_part();
    return slots_.size() / most + (slots_.size() % most == 0 ? 0 : 1);
  }

  /// Counts the partners of a part's elements, and puts their sums on the device. Waits for
  /// nothing.
  void count(std::uint64_t part, PartnerCount* sums) {
    const std::uint64_t elements = elements_of(part);
    const std::uint64_t first_slot = slots_.first + first_of(part);
    executor_.for_each(elements,
                       CountPartners<Search>{search_, first_slot, elements, places_of(part)});
    executor_.reduce_into(sums, elements, PartnerCount{},
                          CountsOfItem<Search>{search_, first_slot, places_of(part)},
                          JoinPartnerCounts{});
    executor_.exclusive_scan(certain_.data() + first_of(part), elements);
    executor_.exclusive_scan(doubtful_.data() + first_of(part), elements);
  }

  /// Writes the certain pairs of a part, unless `certain` is null, and those in doubt.
  void write(std::uint64_t part, const PartnerCount& sums, ContactPair* certain,
             ContactPair* doubtful) {
    const bool is_narrow = sums.doubtful <= settings_.narrow_places &&
                           (certain == nullptr || sums.certain <= settings_.narrow_places);
    if (!is_narrow) return write_by_wide_places(part, certain, doubtful);
    executor_.for_each(elements_of(part),
                       FillPartners<Search>{search_, slots_.first + first_of(part), places_of(part),
                                            certain, doubtful});
  }

 private:
  [[nodiscard]] std::uint64_t first_of(std::uint64_t part) const noexcept {
    return part * settings_.elements_of_part();
  }
  [[nodiscard]] std::uint64_t elements_of(std::uint64_t part) const noexcept {
    return std::min(settings_.elements_of_part(), slots_.size() - first_of(part));
  }

  [[nodiscard]] PartnerPlaces places_of(std::uint64_t part) const noexcept {
    return {ItemNumbers(certain_.data() + first_of(part)),
            ItemNumbers(doubtful_.data() + first_of(part))};
  }

  /// Waits for each of the smaller parts: the host tells where their pairs begin.
  void write_by_wide_places(std::uint64_t part, ContactPair* certain, ContactPair* doubtful) {
    PartnerSearch<Search, E> search(executor_, search_, slots_.first + first_of(part),
                                    elements_of(part), settings_.items_at_a_time);
    PartSums<E> sums(executor_);
    for (std::uint64_t k = 0; k < search.part_count(); ++k) {
      search.count(k, sums.next());
      sums.collect();
      search.write(k, certain, doubtful);
      const PartnerCount& written = sums.on_host().back();
      if (certain != nullptr) certain += written.certain;
      doubtful += written.doubtful;
    }
  }

  E& executor_;
  Search search_;
  SlotRun slots_;
  SearchSettings settings_;
  Buffer<std::uint32_t, E> certain_;
  Buffer<std::uint32_t, E> doubtful_;
};

}  // namespace abut::device
