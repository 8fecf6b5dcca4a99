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
  [[nodiscard]] bool is_moved(std::size_t k) const noexcept {
    return !shifts.empty() && (shifts[k].x | shifts[k].y | shifts[k].z) != 0;
  }
};

using FeatureContacts = WallContacts<FeatureMeasurer, MeshContact>;
template <int Dim>
using BoxContacts = WallContacts<BoxMeasurer<Dim>, BoxContact>;

/// Which contacts of a block are measured together.
class ContactGroups {
 public:
  void clear() noexcept { occurring_ = 0; }
  void add(std::size_t k, unsigned group) noexcept {
    group_[k] = static_cast<std::uint8_t>(group);
    occurring_ |= 1u << group;
  }
  [[nodiscard]] bool has(unsigned group) const noexcept { return (occurring_ >> group & 1u) != 0; }
  [[nodiscard]] bool is_in(std::size_t k, unsigned group) const noexcept {
    return group_[k] == group;
  }

 private:
  std::array<std::uint8_t, kernels::most_features> group_;
  unsigned occurring_ = 0;
};

/// Measures the contacts of a block: features of each kind together, those that a shift moves
/// apart, and what vectors leave open one by one.
template <class SphereOf>
void measure_block(const FeatureContacts& given, std::size_t begin, std::size_t end,
                   const PairGeometrySpans& geometry, FeatureBlock& block, SphereOf&& sphere_of) {
  const Quantities wanted = geometry::wanted_by(geometry);
  ContactGroups groups;
  for (std::size_t k = begin; k < end; ++k) {
    const auto corners = static_cast<unsigned>(corner_count(given.contacts[k].feature.kind));
    groups.add(k - begin, 2 * corners + (given.is_moved(k) ? 1 : 0));
  }
  for (unsigned group = 2; group < 8; ++group) {
    if (!groups.has(group)) continue;
    block.clear();
    for (std::size_t k = begin; k < end; ++k) {
      if (!groups.is_in(k - begin, group)) continue;
      const MeshContact& contact = given.contacts[k];
      block.add(k, sphere_of(contact.sphere), given.measurer.feature(contact));
      if (group % 2 == 1) block.move_last(given.shifts[k]);
    }
    for (const std::size_t k : block.measure(static_cast<int>(group / 2))) {
      const MeshContact& contact = given.contacts[k];
      store(given.measurer(sphere_of(contact.sphere), contact, given.shift(k), wanted), k,
            geometry);
    }
  }
}

/// The contacts of a block with boxes, those that a shift moves or the others: together by the
/// corners that spheres see, those in boxes and what vectors leave open one by one.
template <int Dim, class SphereOf>
void measure_boxes(const BoxContacts<Dim>& given, std::size_t begin, std::size_t end,
                   bool are_moved, const PairGeometrySpans& geometry, FeatureBlock& block,
                   SphereOf&& sphere_of) {
  const Quantities wanted = geometry::wanted_by(geometry);
  const auto measure_one = [&](std::size_t k) {
    const BoxContact& contact = given.contacts[k];
    store(given.measurer(sphere_of(contact.sphere), contact, given.shift(k), wanted), k, geometry);
  };
  std::array<std::size_t, kernels::most_features> places;
  std::array<NearestCoordinates, kernels::most_features> points;
  BoxCorner seen;
  std::size_t count = 0;
  block.clear();
  for (std::size_t k = begin; k < end; ++k) {
    if (given.is_moved(k) != are_moved) continue;
    const BoxContact& contact = given.contacts[k];
    const auto sphere = sphere_of(contact.sphere);
    const bool is_outside = are_moved ? given.measurer.see(sphere, contact, given.shifts[k], seen)
                                      : given.measurer.see(sphere, contact, seen);
    if (!is_outside) {
      measure_one(k);
      continue;
    }
    block.add(k, seen.sphere, seen.corner);
    if (are_moved) block.move_last(given.shifts[k], seen.point.axes);
    places[count] = k;
    points[count++] = seen.point;
  }
  const std::span<const std::size_t> open = block.measure(1);
  for (std::size_t k = 0; k < count && !geometry.points.empty(); ++k) {
    points[k].write_to(geometry.points[places[k]]);
  }
  for (const std::size_t k : open) measure_one(k);
}

template <int Dim, class SphereOf>
void measure_block(const BoxContacts<Dim>& given, std::size_t begin, std::size_t end,
                   const PairGeometrySpans& geometry, FeatureBlock& block, SphereOf&& sphere_of) {
  bool some_are_moved = false;
  for (std::size_t k = begin; k < end; ++k) some_are_moved = some_are_moved || given.is_moved(k);
  measure_boxes(given, begin, end, false, geometry, block, sphere_of);
  if (some_are_moved) measure_boxes(given, begin, end, true, geometry, block, sphere_of);
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
    FeatureBlock block(given.level, geometry, given.measurer.lattice());
    for (std::size_t begin = first; begin < last; begin += kernels::most_features) {
      const std::size_t end = std::min(begin + kernels::most_features, last);
      its_work.did(steps_of_measuring * (end - begin));
      measure_block(given, begin, end, geometry, block, sphere_of);
    }
  });
}

}  // namespace abut::walls
