#pragma once

#include "base/asking_workers.hpp"
#include "base/progress_reporter.hpp"
#include "base/workers.hpp"
#include "exact/features/feature_geometry.hpp"
#include "geometry/spans.hpp"
#include "walls/feature_block.hpp"
#include "walls/feature_measurer.hpp"

#include <abut/image_shift.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>
#include <abut/simd.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

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

/// Contacts with a mesh, the vectors to measure them in, and the workers.
struct FeatureContacts {
  const FeatureMeasurer& measurer;
  std::span<const MeshContact> contacts;
  std::span<const ImageShift> shifts;  ///< empty: all zero
  std::size_t workers;
  Simd level;

  [[nodiscard]] ImageShift shift(std::size_t k) const noexcept {
    return shifts.empty() ? ImageShift{} : shifts[k];
  }

  /// The corners of the feature, or 0 where a shift moves it.
  [[nodiscard]] int corners(std::size_t k) const noexcept {
    return shift(k) == ImageShift{} ? corner_count(contacts[k].feature.kind) : 0;
  }
};

/// Measures the contacts of a block: features of each kind together, what is moved and what vectors
/// leave open one by one.
template <class SphereOf>
void measure_block(const FeatureContacts& given, std::size_t begin, std::size_t end,
                   const PairGeometrySpans& geometry, FeatureBlock& block, SphereOf&& sphere_of) {
  const Quantities wanted = geometry::wanted_by(geometry);
  const auto measure_one = [&](std::size_t k) {
    const MeshContact& contact = given.contacts[k];
    store(given.measurer(sphere_of(contact.sphere), contact, given.shift(k), wanted), k, geometry);
  };
  for (std::size_t k = begin; k < end; ++k) {
    if (given.corners(k) == 0) measure_one(k);
  }
  for (int corners = 1; corners <= 3; ++corners) {
    block.clear();
    for (std::size_t k = begin; k < end; ++k) {
      if (given.corners(k) != corners) continue;
      block.add(k, sphere_of(given.contacts[k].sphere), given.measurer.feature(given.contacts[k]));
    }
    for (const std::size_t k : block.measure(corners)) measure_one(k);
  }
}

/// Fills the arrays that are not empty, one entry for each contact, with the bits of
/// exact::geometry_of. `sphere_of(number)` returns a sphere; workers call it at the same time.
template <class SphereOf>
void measure_features(const FeatureContacts& given, const PairGeometrySpans& geometry,
                      base::WorkCounter& work, SphereOf&& sphere_of) {
  /// Steps through an array that take as long as one contact.
  constexpr std::uint64_t steps_of_measuring = 16;
  base::for_each_share(given.workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, given.workers, given.contacts.size());
    FeatureBlock block(given.level, geometry);
    for (std::size_t begin = first; begin < last; begin += kernels::most_features) {
      const std::size_t end = std::min(begin + kernels::most_features, last);
      its_work.did(steps_of_measuring * (end - begin));
      measure_block(given, begin, end, geometry, block, sphere_of);
    }
  });
}

}  // namespace abut::walls
