#pragma once

#include "base/asking_workers.hpp"
#include "base/progress_reporter.hpp"
#include "base/workers.hpp"
#include "exact/features/feature_geometry.hpp"
#include "geometry/spans.hpp"

#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::walls {

/// Writes the quantities that have an array into place k.
inline void store(const exact::FeatureGeometry& found, std::size_t k,
                  const PairGeometrySpans& geometry) noexcept {
  if (!geometry.gaps.empty()) geometry.gaps[k] = found.gap;
  if (!geometry.normals.empty()) geometry.normals[k] = found.normal;
  if (!geometry.points.empty()) geometry.points[k] = found.point;
  if (!geometry.distances.empty()) geometry.distances[k] = found.distance;
  if (!geometry.vectors.empty()) geometry.vectors[k] = found.vector;
}

/// Fills the arrays that are not empty, one entry for each of `count` contacts.
/// `measure(k, wanted)` returns the geometry of contact k; workers call it at the same time.
template <class Measure>
void measure_contacts(std::size_t count, const PairGeometrySpans& geometry, std::size_t workers,
                      base::WorkCounter& work, Measure&& measure) {
  /// Steps through an array that take as long as one contact.
  constexpr std::uint64_t steps_of_measuring = 64;
  const Quantities wanted = geometry::wanted_by(geometry);
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, count);
    for (std::size_t k = first; k < last; ++k) {
      its_work.did(steps_of_measuring);
      store(measure(k, wanted), k, geometry);
    }
  });
}

}  // namespace abut::walls
