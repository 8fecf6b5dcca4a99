#include <abut/detect.hpp>

#include "api/detection.hpp"

#include <utility>

namespace abut {

PairList find_contact_pairs(const ElementView& elements, const Domain&, const Options& options) {
  PairArray pairs;
  Statistics statistics = api::Detection().list_pairs(elements, options, pairs);
  return PairList(std::move(pairs), std::move(statistics));
}

Statistics for_each_batch(const ElementView& elements, const Domain&, const Options& options,
                          const PairBatchVisitor& visitor) {
  return api::Detection().visit_batches(elements, options, visitor);
}

Statistics count_contact_pairs(const ElementView& elements, const Domain& domain,
                               const Options& options) {
  return for_each_batch(elements, domain, options, {});
}

NeighborList build_neighbor_list(const ElementView& elements, const Domain&, NeighborListKind kind,
                                 const Options& options) {
  NeighborList::Offsets offsets;
  NeighborList::Neighbors neighbors;
  Statistics statistics =
      api::Detection().list_neighbors(elements, options, kind, offsets, neighbors);
  return NeighborList(std::move(offsets), std::move(neighbors), std::move(statistics));
}

}  // namespace abut
