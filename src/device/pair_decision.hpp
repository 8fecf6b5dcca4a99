#pragma once

#include "device/bodies/apart_pair.hpp"
#include "device/bodies/decide.hpp"
#include "device/bodies/directory.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/partners.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"
#include "lattice/check_range.hpp"

#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// Writes what a search has found and decides what it left in doubt. A search has totals(),
/// write(certain, doubtful), and elements() in which the numbers of its pairs are told.
template <class E>
class PairDecision {
 public:
  PairDecision(E& executor, const DeviceRequest& request)
      : executor_(executor), request_(request) {}

  /// All contact pairs, in no order, and in between, as apart_pair, those in doubt that are apart.
  template <class Search>
  void list(Search& search, FoundList<E>& found) {
    const PartnerCount totals = search.totals();
    require_count(totals.certain, request_.max_pairs);
    found.pairs = Buffer<ContactPair, E>(executor_, totals.certain + totals.doubtful);
    ContactPair* const doubtful = found.pairs.data() + totals.certain;
    search.write(found.pairs.data(), doubtful);
    decide(search.elements(), doubtful, totals.doubtful);
    note(totals, contacts_to_order(totals, doubtful), found);
  }

  /// Their number. Only pairs in doubt take memory.
  template <class Search>
  void count(Search& search, FoundList<E>& found) {
    const PartnerCount totals = search.totals();
    Buffer<ContactPair, E> doubtful(executor_, totals.doubtful);
    search.write(nullptr, doubtful.data());
    decide(search.elements(), doubtful.data(), totals.doubtful);
    note(totals, contacts_among(doubtful.data(), totals.doubtful), found);
    require_count(found.count, request_.max_pairs);
  }

 private:
  void note(const PartnerCount& totals, std::uint64_t of_doubtful, FoundList<E>& found) {
    found.count = totals.certain + of_doubtful;
    found.exact_decisions = totals.doubtful;
    found.candidate_tests = totals.tests;
  }

  template <class Spheres>
  void decide(const Spheres& spheres, ContactPair* doubtful, std::uint64_t count) {
    executor_.for_each(count, DecideMost<Spheres>{spheres, request_.margin, doubtful});
    executor_.for_each(count, DecideOpen<Spheres>{spheres, request_.margin, doubtful});
    if (count == 0 || spheres.decides_all()) return;
    const std::uint64_t open =
        executor_.reduce(count, ElementsOfOpenPair<Spheres>::none,
                         ElementsOfOpenPair<Spheres>{spheres, doubtful}, Smaller{});
    if (open != ElementsOfOpenPair<Spheres>::none) {
      lattice::refuse_shift(open >> 32, open & 0xffffffff);
    }
  }

  /// How many of the pairs in doubt go on to be ordered: all, unless a full list would take much
  /// memory for some that are apart. Waits then; these are dropped.
  [[nodiscard]] std::uint64_t contacts_to_order(const PartnerCount& totals, ContactPair* doubtful) {
    constexpr std::uint64_t few = 16;  // certain ones for each in doubt
    const std::uint64_t count = totals.doubtful;
    if (request_.form != ListForm::full_rows || count <= totals.certain / few) return count;
    Buffer<ContactPair, E> copy(executor_, count);
    const std::uint64_t kept = executor_.select(doubtful, copy.data(), count, ContactTester{});
    executor_.for_each(kept, CopyEntry<ContactPair>{copy.data(), doubtful});
    return kept;
  }

  /// Waits, where there are any.
  [[nodiscard]] std::uint64_t contacts_among(const ContactPair* pairs, std::uint64_t count) {
    if (count == 0) return 0;
    return executor_.reduce(count, std::uint64_t{0}, ContactOfPair{pairs}, SumOfTwo{});
  }

  E& executor_;
  DeviceRequest request_;
};

}  // namespace abut::device
