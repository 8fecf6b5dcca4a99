#pragma once

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

  /// All contact pairs, in no order.
  template <class Search>
  void list(Search& search, FoundList<E>& found) {
    const PartnerCount totals = search.totals();
    require_count(totals.certain, request_.max_pairs);
    found.pairs = Buffer<ContactPair, E>(executor_, totals.certain + totals.doubtful);
    ContactPair* const doubtful = found.pairs.data() + totals.certain;
    search.write(found.pairs.data(), doubtful);
    decide(search.elements(), doubtful, totals.doubtful);
    Buffer<ContactPair, E> copy(executor_, totals.doubtful);
    const std::uint64_t kept = keep_contacts(doubtful, copy.data(), totals.doubtful);
    executor_.for_each(kept, CopyEntry<ContactPair>{copy.data(), doubtful});
    note(totals, kept, found);
  }

  /// Their number. Only pairs in doubt take memory.
  template <class Search>
  void count(Search& search, FoundList<E>& found) {
    const PartnerCount totals = search.totals();
    Buffer<ContactPair, E> doubtful(executor_, totals.doubtful);
    search.write(nullptr, doubtful.data());
    decide(search.elements(), doubtful.data(), totals.doubtful);
    Buffer<ContactPair, E> kept(executor_, totals.doubtful);
    note(totals, keep_contacts(doubtful.data(), kept.data(), totals.doubtful), found);
  }

 private:
  void note(const PartnerCount& totals, std::uint64_t kept, FoundList<E>& found) {
    found.count = totals.certain + kept;
    found.exact_decisions = totals.doubtful;
    found.candidate_tests = totals.tests;
    require_count(found.count, request_.max_pairs);
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

  [[nodiscard]] std::uint64_t keep_contacts(const ContactPair* pairs, ContactPair* kept,
                                            std::uint64_t count) {
    // Waits: how many are contacts is the length of the list, which may not pass a limit.
    return count == 0 ? 0 : executor_.select(pairs, kept, count, ContactTester{});
  }

  E& executor_;
  DeviceRequest request_;
};

}  // namespace abut::device
