// Contacts with features measured in vectors have the bits of the scalar code at every SIMD level,
// wherever numbers lie.

#include "walls/feature_block.hpp"
#include "exact/features/feature_geometry.hpp"
#include "scenes/random.hpp"

#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

constexpr Quantities everything =
    Quantity::gap | Quantity::distance | Quantity::normal | Quantity::point | Quantity::vector;

struct Contact {
  exact::Sphere<3> sphere{};
  exact::Feature feature{};
};

bool alike(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool alike(const Vector& a, const Vector& b) {
  return alike(a[0], b[0]) && alike(a[1], b[1]) && alike(a[2], b[2]);
}

/// A number of a scale: smooth, on a grid, tiny beside the others, or 0.
double some_number(Random& random, double scale) {
  const double fine = random.uniform(-1.0, 1.0);
  switch (random.below(8)) {
    case 0:
      return scale * (std::round(fine * 4.0) / 4.0);
    case 1:
      return 0.0;
    case 2:
      return std::ldexp(scale * fine, -static_cast<int>(random.below(600)));
    default:
      return scale * fine;
  }
}

/// Places of features: anywhere; the third corner all but on the line of the others; the center all
/// but on the feature, or above its middle.
Contact some_contact(Random& random, int corners, double scale) {
  Contact contact;
  contact.feature.corners = corners;
  for (auto& corner : contact.feature.corner) {
    for (double& x : corner) x = some_number(random, scale);
  }
  for (double& x : contact.sphere.center) x = some_number(random, scale);
  contact.sphere.radius = std::fabs(some_number(random, scale));
  auto& [p, q, r] = contact.feature.corner;
  const double thin = scale * std::ldexp(1.0, -static_cast<int>(random.below(80)));
  const std::uint64_t kind = random.below(4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double away = thin * random.uniform(-1.0, 1.0);
    if (kind == 0) r[axis] = p[axis] + 0.5 * (q[axis] - p[axis]) + away;
    if (kind == 1 || kind == 2) {
      const double third = corners == 3 ? 0.25 * r[axis] : 0.0;
      const double second = corners > 1 ? 0.5 * q[axis] : 0.0;
      const double first = (corners == 1 ? 1.0 : corners == 2 ? 0.5 : 0.25) * p[axis];
      const double lift = kind == 1 ? away : 0.25 * scale * random.uniform(-1.0, 1.0);
      contact.sphere.center[axis] = first + second + third + lift;
    }
  }
  return contact;
}

PairGeometry arrays_of(std::size_t count, Quantities wanted) {
  PairGeometry geometry;
  if (wanted.has(Quantity::gap)) geometry.gaps.resize(count);
  if (wanted.has(Quantity::distance)) geometry.distances.resize(count);
  if (wanted.has(Quantity::normal)) geometry.normals.resize(count);
  if (wanted.has(Quantity::point)) geometry.points.resize(count);
  if (wanted.has(Quantity::vector)) geometry.vectors.resize(count);
  return geometry;
}

/// Tells whether the entries of the arrays are the bits of one contact.
bool has_bits_of(const PairGeometry& found, std::size_t k, const exact::FeatureGeometry& one) {
  return (found.gaps.empty() || alike(found.gaps[k], one.gap)) &&
         (found.distances.empty() || alike(found.distances[k], one.distance)) &&
         (found.normals.empty() || alike(found.normals[k], one.normal)) &&
         (found.points.empty() || alike(found.points[k], one.point)) &&
         (found.vectors.empty() || alike(found.vectors[k], one.vector));
}

/// Returns how many contacts vectors left open.
std::size_t check(const std::vector<Contact>& contacts, int corners, Quantities wanted,
                  Simd level) {
  PairGeometry found = arrays_of(contacts.size(), wanted);
  const PairGeometrySpans spans = found.spans();
  walls::FeatureBlock block(level, spans);
  std::size_t open_count = 0;
  for (std::size_t begin = 0; begin < contacts.size(); begin += kernels::most_features) {
    const std::size_t end = std::min(begin + kernels::most_features, contacts.size());
    block.clear();
    for (std::size_t k = begin; k < end; ++k) {
      block.add(k, contacts[k].sphere, contacts[k].feature);
    }
    const auto open = block.measure(corners);
    open_count += open.size();
    for (std::size_t k = begin; k < end; ++k) {
      if (std::ranges::count(open, k) > 0) continue;
      const auto& [sphere, feature] = contacts[k];
      const auto expected = exact::geometry_of(sphere, feature, {}, {}, wanted);
      EXPECT_TRUE(has_bits_of(found, k, expected)) << k << ", " << corners << " corners";
    }
  }
  return open_count;
}

template <class Act>
void at_every_level(Act&& act) {
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    SCOPED_TRACE(name_of(level));
    act(level);
  }
}

std::vector<Contact> some_contacts(Random& random, std::size_t count, int corners, double scale) {
  std::vector<Contact> contacts;
  for (std::size_t k = 0; k < count; ++k) {
    contacts.push_back(some_contact(random, corners, scale));
  }
  return contacts;
}

TEST(FeatureBlock, HasTheBitsOfScalarCodeAtEveryScale) {
  Random random(1520);
  for (const double scale : {1.0, 1e-9, 0x1p63, 0x1p65, 0x1p-98, 0x1p-101, 0x1p-180, 0x1p-400,
                             0x1p600, 0x1p1023, 0x1p-1040, 0x1p-1074}) {
    SCOPED_TRACE(scale);
    for (int corners = 1; corners <= 3; ++corners) {
      const auto contacts = some_contacts(random, 400, corners, scale);
      at_every_level([&](Simd level) { (void)check(contacts, corners, everything, level); });
    }
  }
}

TEST(FeatureBlock, MeasuresAnyNumberAndAnyQuantities) {
  Random random(1521);
  for (const std::size_t count : {0u, 1u, 3u, 8u, 63u, 64u, 65u, 255u, 256u, 257u}) {
    for (unsigned subset = 0; subset < 32; ++subset) {
      Quantities wanted;
      const Quantity each[] = {Quantity::gap, Quantity::distance, Quantity::normal, Quantity::point,
                               Quantity::vector};
      for (unsigned k = 0; k < 5; ++k) {
        if ((subset >> k & 1u) != 0) wanted = wanted | each[k];
      }
      const int corners = 1 + static_cast<int>(subset % 3);
      const auto contacts = some_contacts(random, count, corners, 1.0);
      at_every_level([&](Simd level) { (void)check(contacts, corners, wanted, level); });
    }
  }
}

/// What is ordinary is measured in vectors: else all would be right and slow.
TEST(FeatureBlock, LeavesHardlyAnythingOpenOfASmoothFloor) {
  Random random(1522);
  std::vector<Contact> contacts;
  for (int k = 0; k < 2000; ++k) {
    const double x = random.uniform(0.2, 0.4), y = random.uniform(0.2, 0.4);
    contacts.push_back({{{x, y, random.uniform(0.1, 0.2)}, 0.3},
                        {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, 3}});
  }
  at_every_level([&](Simd level) {
    if (level == Simd::scalar) return;
    for (int corners = 1; corners <= 3; ++corners) {
      for (Contact& contact : contacts) contact.feature.corners = corners;
      EXPECT_LT(check(contacts, corners, everything, level), 20u) << corners;
    }
  });
}

}  // namespace
}  // namespace abut::testing
