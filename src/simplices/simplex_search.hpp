#pragma once

#include <abut/domain.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>
#include <abut/simplex_contacts.hpp>

namespace abut::simplices {

/// One call: which simplices, and how their contacts are to be found. The caller's objects outlive
/// it.
struct SimplexRequest {
  const SimplexView& first;
  const Domain& domain;
  const Options& options;
  SharedVertices shared;
  const SimplexView* others = nullptr;  ///< the second set, where there are two
};

/// Finds the contacts of simplices: a search among the boxes around them, whose pairs are decided
/// where they are found.
template <int Dim>
[[nodiscard]] PairList find(const SimplexRequest& request);

/// Throws Error{wrong_usage} for what contacts of simplices do not have.
void require_supported(const SimplexRequest& request);

/// Throws Error{wrong_usage} for two sets of unequal dimensions.
void require_same_dimensions(const SimplexView& first, const SimplexView& second);

}  // namespace abut::simplices
