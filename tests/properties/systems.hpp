#pragma once

#include "scenes/scene.hpp"
#include "support/oracle.hpp"

#include <abut/algorithm.hpp>

#include <rapidcheck.h>

#include <cstddef>
#include <functional>
#include <vector>

/// Small random systems on a lattice of some unit, where borderline pairs are common, and what the
/// relations do to them.
namespace abut::testing {

using scenes::Scene;

/// Where every sum and product of a relation must be exact: multiples of 1/4.
inline constexpr double exact_unit = 0.25;

/// Up to `most` elements on multiples of `unit`.
[[nodiscard]] rc::Gen<Scene> system_on(double unit, int most = 40);

/// On multiples of 1/4, of 0.1 or of sqrt(1/2), as they are or rounded to float.
[[nodiscard]] rc::Gen<Scene> any_system();

/// Pairs of the library, canonical. `rows` runs at any SIMD level there is with 1, 2, 3, 7 or 16
/// threads; what fits float is handed over as float or double. To be called within a property.
/// Programs choose what detects: this and the next are defined in detections.cpp, or elsewhere for
/// other engines.
[[nodiscard]] PairVector pairs_of(const Scene& scene, Algorithm algorithm, double margin = 0.0);

/// Runs `relation(algorithm)` for all algorithms that carry the system.
void for_each_algorithm(const Scene& scene, const std::function<void(Algorithm)>& relation);

/// One axis after the other: x, y(, z).
[[nodiscard]] std::vector<std::vector<double>*> axes_of(Scene& scene);

/// Replaces every number k of the pairs by new_number[k] and brings them into canonical order.
[[nodiscard]] PairVector renumbered(const PairVector& pairs,
                                    const std::vector<std::size_t>& new_number);

}  // namespace abut::testing
