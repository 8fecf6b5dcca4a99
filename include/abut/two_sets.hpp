#pragma once

#include <abut/detect.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>

#include <concepts>
#include <utility>

namespace abut {

/// Contact pairs of two sets: element i of `first` and element j of `second`, each pair once, in
/// order of (i, j, image shift of j). Elements of one set never pair with each other, and i < j
/// does not matter: where both views show the same array, each element pairs with itself too.
///
/// The sets may differ in everything but the number of dimensions. In open space elements of one
/// set that lie far from all of the other are set aside before the search.
///
/// Throws as find_contact_pairs of one set does.
[[nodiscard]] ABUT_API PairList find_contact_pairs(const ElementView& first,
                                                   const ElementView& second,
                                                   const Domain& domain = Domain::open(),
                                                   const Options& options = {});

[[nodiscard]] ABUT_API Statistics count_contact_pairs(const ElementView& first,
                                                      const ElementView& second,
                                                      const Domain& domain = Domain::open(),
                                                      const Options& options = {});

ABUT_API Statistics for_each_batch(const ElementView& first, const ElementView& second,
                                   const Domain& domain, const Options& options,
                                   const PairBatchVisitor& visitor);
ABUT_API Statistics for_each_shifted_batch(const ElementView& first, const ElementView& second,
                                           const Domain& domain, const Options& options,
                                           const ShiftedBatchVisitor& visitor);

template <detail::PairVisitor Visitor>
Statistics for_each_contact_pair(const ElementView& first, const ElementView& second,
                                 const Domain& domain, const Options& options, Visitor&& visitor) {
  return for_each_batch(first, second, domain, options, detail::pair_by_pair(visitor));
}

template <detail::ShiftedPairVisitor Visitor>
Statistics for_each_shifted_pair(const ElementView& first, const ElementView& second,
                                 const Domain& domain, const Options& options, Visitor&& visitor) {
  return for_each_shifted_batch(first, second, domain, options,
                                detail::shifted_pair_by_pair(visitor));
}

/// One row for each element of `first`, with numbers of `second`.
[[nodiscard]] ABUT_API NeighborList build_neighbor_list(const ElementView& first,
                                                        const ElementView& second,
                                                        const Domain& domain = Domain::open(),
                                                        const Options& options = {});

/// distance − (r_i + r_j) of element i of `first` and element j of `second`, as gap of one set.
[[nodiscard]] ABUT_API double gap(const ElementView& first, const ElementView& second,
                                  ContactPair pair);
[[nodiscard]] ABUT_API double gap(const ElementView& first, const ElementView& second,
                                  const Domain& domain, ContactPair pair, const ImageShift& shift);

}  // namespace abut
