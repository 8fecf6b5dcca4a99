#pragma once

#include "base/asking_workers.hpp"
#include "base/progress_reporter.hpp"
#include "base/workers.hpp"
#include "exact/features/feature_geometry.hpp"
#include "geometry/spans.hpp"
#include "walls/box_measurer.hpp"
#include "walls/feature_block.hpp"
#include "walls/feature_measurer.hpp"

#include <abut/box_contacts.hpp>
#include <abut/image_shift.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>
#include <abut/simd.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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

/// Contacts with walls, the vectors to measure them in, and the workers.
template <class Measurer, class Contact>
struct WallContacts {
  const Measurer& measurer;
  std::span<const Contact> contacts;
  std::span<const ImageShift> shifts;  ///< empty: all zero
  std::size_t workers;
  Simd level;

  [[nodiscard]] ImageShift shift(std::size_t k) const noexcept {
    return shifts.empty() ? ImageShift{} : shifts[k];
  }
};

using FeatureContacts = WallContacts<FeatureMeasurer, MeshContact>;
template <int Dim>
using BoxContacts = WallContacts<BoxMeasurer<Dim>, BoxContact>;

/// The corners of the feature, or 0 where a shift moves it.
[[nodiscard]] inline int corners_in_place(const FeatureContacts& given, std::size_t k) noexcept {
  return given.shift(k) == ImageShift{} ? corner_count(given.contacts[k].feature.kind) : 0;
}

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
    if (corners_in_place(given, k) == 0) measure_one(k);
  }
  for (int corners = 1; corners <= 3; ++corners) {
    block.clear();
    for (std::size_t k = begin; k < end; ++k) {
      if (corners_in_place(given, k) != corners) continue;
      block.add(k, sphere_of(given.contacts[k].sphere), given.measurer.feature(given.contacts[k]));
    }
    for (const std::size_t k : block.measure(corners)) measure_one(k);
  }
}

/// Measures the contacts of a block: boxes in open space together, by the corners that spheres see,
/// the others and what vectors leave open one by one.
template <int Dim, class SphereOf>
void measure_block(const BoxContacts<Dim>& given, std::size_t begin, std::size_t end,
                   const PairGeometrySpans& geometry, FeatureBlock& block, SphereOf&& sphere_of) {
  const Quantities wanted = geometry::wanted_by(geometry);
  const auto measure_one = [&](std::size_t k) {
    const BoxContact& contact = given.contacts[k];
    store(given.measurer(sphere_of(contact.sphere), contact, given.shift(k), wanted), k, geometry);
  };
  std::array<std::size_t, kernels::most_features> places;
  std::array<Vector, kernels::most_features> points;
  std::size_t count = 0;
  block.clear();
  for (std::size_t k = begin; k < end; ++k) {
    std::optional<BoxCorner> seen;
    if (given.shift(k) == ImageShift{}) {
      const BoxContact& contact = given.contacts[k];
      seen = seen_corner<Dim>(sphere_of(contact.sphere), given.measurer.box(contact));
    }
    if (!seen) {
      measure_one(k);
      continue;
    }
    block.add(k, seen->sphere, seen->corner);
    places[count] = k;
    points[count++] = seen->point;
  }
  const std::span<const std::size_t> open = block.measure(1);
  for (std::size_t k = 0; k < count && !geometry.points.empty(); ++k) {
    geometry.points[places[k]] = points[k];
  }
  for (const std::size_t k : open) measure_one(k);
}

/// Fills the arrays that are not empty, one entry for each contact, with the bits of
/// exact::geometry_of. `sphere_of(number)` returns a sphere; workers call it at the same time.
template <class Given, class SphereOf>
void measure_contacts(const Given& given, const PairGeometrySpans& geometry,
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
