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

  void add(const PartnerCount& more) noexcept {
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

/// Where the items' pairs go: the sums of the counts of all items before.
struct PartnerPlaces {
  std::uint64_t* certain;
  std::uint64_t* doubtful;
};

/// Body: counts the partners of item k of a search; see MeetInLevel, MeetCoarse. The entry
/// behind the last item is 0, and becomes the sum of all.
template <class Search>
struct CountPartners {
  Search search;
  std::uint64_t first_item;
  std::uint64_t items;
  PartnerPlaces counts;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    PartnerCounter count;
    if (k < items) search.partners_of(first_item + k, count);
    counts.certain[k] = count.certain;
    counts.doubtful[k] = count.doubtful;
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
    return {certain == nullptr ? nullptr : certain + places.certain[k],
            doubtful + places.doubtful[k]};
  }
};

}  // namespace abut::device
