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

/// Finds the contact pairs of two sets: element i of `first` and element j of `second`, each pair
/// once, in order of (i, j, image shift of j). Elements of one set never pair with each other, and
/// i need not be smaller than j: if both views show the same array, each element also pairs with
/// itself.
///
/// The sets must have the same shape and number of dimensions; all else may differ. In open space
/// elements of one set that lie far from all of the other are set aside before the search.
///
/// Throws what find_contact_pairs of one set throws.
[[nodiscard]] ABUT_API PairList find_contact_pairs(const ElementView& first,
                                                   const ElementView& second,
                                                   const Domain& domain = Domain::open(),
                                                   const Options& options = {});

/// Counts the contact pairs of two sets without storing them.
[[nodiscard]] ABUT_API Statistics count_contact_pairs(const ElementView& first,
                                                      const ElementView& second,
                                                      const Domain& domain = Domain::open(),
                                                      const Options& options = {});

/// Hands the pairs of two sets to a visitor in batches as they are found.
ABUT_API Statistics for_each_batch(const ElementView& first, const ElementView& second,
                                   const Domain& domain, const Options& options,
                                   const PairBatchVisitor& visitor);
/// Hands the pairs of two sets and their image shifts to a visitor in batches.
ABUT_API Statistics for_each_shifted_batch(const ElementView& first, const ElementView& second,
                                           const Domain& domain, const Options& options,
                                           const ShiftedBatchVisitor& visitor);

/// Calls `visitor(pair)` or `visitor(pair, worker)` once for each contact pair of two sets.
template <detail::PairVisitor Visitor>
Statistics for_each_contact_pair(const ElementView& first, const ElementView& second,
                                 const Domain& domain, const Options& options, Visitor&& visitor) {
  return for_each_batch(first, second, domain, options, detail::pair_by_pair(visitor));
}

/// Calls `visitor(pair, shift)` or `visitor(pair, shift, worker)` once for each contact pair of two
/// sets.
template <detail::ShiftedPairVisitor Visitor>
Statistics for_each_shifted_pair(const ElementView& first, const ElementView& second,
                                 const Domain& domain, const Options& options, Visitor&& visitor) {
  return for_each_shifted_batch(first, second, domain, options,
                                detail::shifted_pair_by_pair(visitor));
}

/// Builds a neighbor list with one row for each element of `first` and indices of `second`.
[[nodiscard]] ABUT_API NeighborList build_neighbor_list(const ElementView& first,
                                                        const ElementView& second,
                                                        const Domain& domain = Domain::open(),
                                                        const Options& options = {});

/// Computes the gap of element `pair.first` of `first` and element `pair.second` of `second`.
[[nodiscard]] ABUT_API double gap(const ElementView& first, const ElementView& second,
                                  ContactPair pair);
/// Computes the gap of two elements of two sets, `pair.second` moved by `shift`.
[[nodiscard]] ABUT_API double gap(const ElementView& first, const ElementView& second,
                                  const Domain& domain, ContactPair pair, const ImageShift& shift);

}  // namespace abut
