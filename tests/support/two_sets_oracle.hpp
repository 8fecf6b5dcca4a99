#pragma once

#include "scenes/scene.hpp"
#include "support/oracle.hpp"
#include "support/periodic_oracle.hpp"

#include <abut/domain.hpp>

#include <cstdint>
#include <vector>

/// The contract for two sets: the cross product, each pair in rational arithmetic where it is not
/// clear, computed without any of the library.
namespace abut::testing {

/// The elements of `first`, then those of `second`.
[[nodiscard]] scenes::Scene joined(const scenes::Scene& first, const scenes::Scene& second);

/// Pairs (i of `first`, j of `second`) in canonical order.
[[nodiscard]] PairVector oracle_cross_pairs(const scenes::Scene& first, const scenes::Scene& second,
                                            double margin = 0.0);

/// The same in a periodic domain; `farthest` as for oracle_image_pairs.
[[nodiscard]] std::vector<ImagePair> oracle_cross_image_pairs(const scenes::Scene& first,
                                                              const scenes::Scene& second,
                                                              const Domain& domain, double margin,
                                                              std::int32_t farthest);

}  // namespace abut::testing
