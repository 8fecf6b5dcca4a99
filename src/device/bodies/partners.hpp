#pragma once

#include "base/host_device.hpp"
#include "device/bodies/filter.hpp"

#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// Pairs within reach for certain, pairs in doubt, and how many were compared for them.
struct PartnerCount {
  std::uint64_t certain = 0;
  std::uint64_t doubtful = 0;
  std::uint64_t tests = 0;

  ABUT_HD void add(const PartnerCount& more) noexcept {
    certain += more.certain;
    doubtful += more.doubtful;
    tests += more.tests;
  }
};

/// How many distances item k of a search compares.
template <class Search>
struct TestsOfItem {
  Search search;
  std::uint64_t first_item;

  [[nodiscard]] ABUT_HD std::uint64_t operator()(std::uint64_t k) const noexcept {
    return search.tests_of(first_item + k);
  }
};

/// What the host must know of a level, step by step: of a part of its elements, and of some of the
/// larger ones, if there are so many.
struct StepCounts {
  PartnerCount meets;
  std::uint64_t items_of_coarse;
};

struct SumOfTwo {
  [[nodiscard]] ABUT_HD std::uint64_t operator()(std::uint64_t a, std::uint64_t b) const noexcept {
    return a + b;
  }
};

/// Counts the partners of one item, of which there are fewer than 2^32.
struct PartnerCounter {
  std::uint32_t certain = 0;
  std::uint32_t doubtful = 0;

  template <class Partner>
  ABUT_HD void take(std::uint32_t, const Partner&, FilterVerdict verdict) noexcept {
    if (verdict == FilterVerdict::within) ++certain;
    if (verdict == FilterVerdict::doubtful) ++doubtful;
  }
};

/// Writes the pairs of one item to the places that are its own: first the smaller number.
struct PartnerWriter {
  ContactPair* certain;   ///< next place; null where certain pairs are only counted
  ContactPair* doubtful;  ///< next place

  ABUT_HD void take(std::uint32_t one, std::uint32_t other, FilterVerdict verdict) noexcept {
    const ContactPair pair = one < other ? ContactPair{one, other} : ContactPair{other, one};
    if (verdict == FilterVerdict::doubtful) *doubtful++ = pair;
    if (verdict == FilterVerdict::within && certain != nullptr) *certain++ = pair;
  }
};

/// A number for each item of a search: of 64 bits or, where these suffice, of 32.
class ItemNumbers {
 public:
  ABUT_HD explicit ItemNumbers(std::uint64_t* numbers) noexcept : wide_(numbers) {}
  ABUT_HD explicit ItemNumbers(std::uint32_t* numbers) noexcept : narrow_(numbers) {}

  [[nodiscard]] ABUT_HD std::uint64_t at(std::uint64_t k) const noexcept {
    return wide_ != nullptr ? wide_[k] : narrow_[k];
  }
  ABUT_HD void set(std::uint64_t k, std::uint32_t number) const noexcept {
    if (wide_ != nullptr) {
      wide_[k] = number;
    } else {
      narrow_[k] = number;
    }
  }

 private:
  std::uint64_t* wide_ = nullptr;
  std::uint32_t* narrow_ = nullptr;
};

/// How many pairs the items have, and then where these go: the sums of the counts of all items
/// before.
struct PartnerPlaces {
  ItemNumbers certain;
  ItemNumbers doubtful;
};

/// Body: counts the partners of item k of a search; see MeetInLevel, MeetCoarse. An entry behind
/// the last item is 0, and becomes the sum of all.
template <class Search>
struct CountPartners {
  Search search;
  std::uint64_t first_item;
  std::uint64_t items;
  PartnerPlaces counts;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    PartnerCounter count;
    if (k < items) search.partners_of(first_item + k, count);
    counts.certain.set(k, count.certain);
    counts.doubtful.set(k, count.doubtful);
  }
};

/// Body of a reduction: the partners of item k, which were counted, and how many distances it
/// compares.
template <class Search>
struct CountsOfItem {
  Search search;
  std::uint64_t first_item;
  PartnerPlaces counts;

  [[nodiscard]] ABUT_HD PartnerCount operator()(std::uint64_t k) const noexcept {
    return {counts.certain.at(k), counts.doubtful.at(k), search.tests_of(first_item + k)};
  }
};

struct JoinPartnerCounts {
  [[nodiscard]] ABUT_HD PartnerCount operator()(PartnerCount a,
                                                const PartnerCount& b) const noexcept {
    a.add(b);
    return a;
  }
};

/// Body: brings the sums behind the last item side by side, for one copy to the host.
struct GatherPartnerCount {
  const std::uint64_t* certain;
  const std::uint64_t* doubtful;
  PartnerCount* totals;

  ABUT_HD void operator()(std::uint64_t) const noexcept {
    totals->certain = *certain;
    totals->doubtful = *doubtful;
  }
};

/// Body: writes the partners of item k.
template <class Search>
struct FillPartners {
  Search search;
  std::uint64_t first_item;
  PartnerPlaces places;
  ContactPair* certain;  ///< null where certain pairs are only counted
  ContactPair* doubtful;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    PartnerWriter own = writer(k);
    search.partners_of(first_item + k, own);
  }

  [[nodiscard]] ABUT_HD PartnerWriter writer(std::uint64_t k) const noexcept {
    return {certain == nullptr ? nullptr : certain + places.certain.at(k),
            doubtful + places.doubtful.at(k)};
  }
};

}  // namespace abut::device
