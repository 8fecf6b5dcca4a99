#pragma once

#include "scenes/scene.hpp"

#include <abut/pair.hpp>

#include <vector>

/// The contract, computed without any of the library: all pairs, rational arithmetic.
namespace abut::testing {

using PairVector = std::vector<ContactPair>;

/// Whether elements i and j are within reach, in rational numbers.
[[nodiscard]] bool rational_contact(const scenes::Scene& scene, std::size_t i, std::size_t j,
                                    double margin);

/// All contact pairs, in canonical order. Clear cases are told apart in double, with a band a
/// thousand times wider than rounding could need; the others in rational numbers.
[[nodiscard]] PairVector oracle_pairs(const scenes::Scene& scene, double margin = 0.0);

}  // namespace abut::testing
