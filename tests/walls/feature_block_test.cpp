// Contacts with features measured in vectors have the bits of the scalar code at every SIMD level,
// wherever numbers lie.

#include "walls/feature_block.hpp"
#include "exact/features/feature_geometry.hpp"
#include "exact/lattice.hpp"
#include "scenes/random.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
  ImageShift shift{};
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

/// Returns how many contacts vectors left open. With a lattice all of them are moved.
std::size_t check(const std::vector<Contact>& contacts, int corners, Quantities wanted, Simd level,
                  const exact::Lattice& lattice = {}) {
  const bool are_moved = lattice.periodic != std::array<bool, 3>{};
  PairGeometry found = arrays_of(contacts.size(), wanted);
  const PairGeometrySpans spans = found.spans();
  walls::FeatureBlock block(level, spans, lattice);
  std::size_t open_count = 0;
  for (std::size_t begin = 0; begin < contacts.size(); begin += kernels::most_features) {
    const std::size_t end = std::min(begin + kernels::most_features, contacts.size());
    block.clear();
    for (std::size_t k = begin; k < end; ++k) {
      block.add(k, contacts[k].sphere, contacts[k].feature);
      if (are_moved) block.move_last(contacts[k].shift);
    }
    const auto open = block.measure(corners);
    open_count += open.size();
    for (std::size_t k = begin; k < end; ++k) {
      if (std::ranges::count(open, k) > 0) continue;
      const auto& [sphere, feature, shift] = contacts[k];
      const auto expected = exact::geometry_of(sphere, feature, shift, lattice, wanted);
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

/// Vectors of a cell: along the axes, or across; of any numbers, of few bits, or of a size of their
/// own. Some axes are not periodic, and what stands there means nothing.
exact::Lattice some_lattice(Random& random, double scale) {
  exact::Lattice lattice;
  const bool is_straight = random.below(2) == 0;
  for (std::size_t k = 0; k < 3; ++k) {
    lattice.periodic[k] = k == 0 || random.below(4) > 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_straight && axis != k) continue;
      lattice.vectors[k][axis] = some_number(random, scale);
    }
    if (!lattice.periodic[k]) lattice.vectors[k] = {NAN, INFINITY, 0x1p1000};
  }
  return lattice;
}

/// Moves the center to where the feature comes to lie.
void follow_feature(Contact& contact, const exact::Lattice& lattice) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double& x = contact.sphere.center[axis];
    for (const auto& step : exact::LatticeSteps<3>(contact.shift, lattice)) {
      x += step.number * step.vector[axis];
    }
    x = std::clamp(x, -0x1p1023, 0x1p1023);
  }
}

/// A shift of few cells or of up to 2^31, along the axes that are periodic.
ImageShift some_shift(Random& random, const exact::Lattice& lattice) {
  const std::uint64_t count = random.below(2) == 0 ? 4 : std::uint64_t{1} << 32;
  const auto number = [&](std::size_t k) {
    if (!lattice.periodic[k]) return std::int32_t{0};
    return static_cast<std::int32_t>(static_cast<std::int64_t>(random.below(count)) -
                                     static_cast<std::int64_t>(count / 2));
  };
  return {number(0), number(1), number(2)};
}

std::vector<Contact> some_moved_contacts(Random& random, std::size_t count, int corners,
                                         const exact::Lattice& lattice, double scale) {
  std::vector<Contact> contacts = some_contacts(random, count, corners, scale);
  for (Contact& contact : contacts) {
    contact.shift = some_shift(random, lattice);
    if (random.below(8) > 0) follow_feature(contact, lattice);
    const double away = std::ldexp(scale, -static_cast<int>(random.below(60)));
    if (random.below(2) == 0) contact.sphere.center[random.below(3)] += away;
  }
  return contacts;
}

TEST(FeatureBlock, HasTheBitsOfScalarCodeWhereShiftsMoveFeatures) {
  Random random(1523);
  for (const double scale : {1.0, 1e-9, 0x1p31, 0x1p63, 0x1p65, 0x1p-98, 0x1p-101, 0x1p-180,
                             0x1p-199, 0x1p-400, 0x1p600, 0x1p1000, 0x1p-1040, 0x1p-1074}) {
    SCOPED_TRACE(scale);
    for (int round = 0; round < 24; ++round) {
      const int corners = 1 + round % 3;
      const exact::Lattice lattice = some_lattice(random, round % 8 == 0 ? 0x1p600 : scale);
      const auto contacts = some_moved_contacts(random, 64, corners, lattice, scale);
      at_every_level([&](Simd level) {
        (void)check(contacts, corners, everything, level, lattice);
        (void)check(contacts, corners, Quantity::distance | Quantity::normal, level, lattice);
      });
    }
  }
}

/// Numbers of the same last place, whose sums lie in the middle between two doubles again and
/// again.
TEST(FeatureBlock, RoundsMovedCornersToEven) {
  Random random(1524);
  const auto number = [&](double size) {
    return size + 0x1p-52 * std::round(random.uniform(-9, 9));
  };
  exact::Lattice lattice;
  lattice.periodic = {true, true, true};
  for (int round = 0; round < 30; ++round) {
    for (auto& vector : lattice.vectors) {
      for (double& x : vector) x = number(1.0);
    }
    std::vector<Contact> contacts = some_contacts(random, 64, 1, 1.0);
    for (Contact& contact : contacts) {
      contact.shift = {static_cast<std::int32_t>(random.below(3)),
                       static_cast<std::int32_t>(random.below(3)), 1};
      for (double& x : contact.feature.corner[0]) x = number(1.0);
      for (double& x : contact.sphere.center) x = number(-1.5);
    }
    at_every_level([&](Simd level) {
      const std::size_t open = check(contacts, 1, everything, level, lattice);
      EXPECT_LE(open, level == Simd::scalar ? contacts.size() : 1U);
    });
  }
}

/// A sum all but in the middle between two doubles, on either side.
TEST(FeatureBlock, SeesWhatTipsTheBalanceOfAMovedCorner) {
  for (const double tip : {0x1p-150, -0x1p-150, 0x1.8p-107, -0x1.8p-107, 0x1p-52, 0x1p-54}) {
    exact::Lattice lattice;
    lattice.periodic[0] = true;
    lattice.vectors[0] = {tip, tip, tip};
    std::vector<Contact> contacts(64);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double size = k % 2 == 0 ? 1.0 : 1.0 + 0x1p-52;
      const double middle = k % 4 < 2 ? 0x1p-53 : -0x1p-54;
      const double first = k % 3 == 0 ? size : 0.75, second = k % 3 == 1 ? -size : 0.25;
      contacts[k] = {{{-middle, second, -middle}, 0.5}, {{{first, middle, size}}, 1}, {1, 0, 0}};
    }
    at_every_level([&](Simd level) { (void)check(contacts, 1, everything, level, lattice); });
  }
}

TEST(FeatureBlock, MovesFeaturesAlongSomeAxesOnly) {
  exact::Lattice lattice;
  lattice.periodic = {true, false, false};
  lattice.vectors[0] = {4.0, 0.3, 0.7};
  exact::Lattice without = lattice;
  without.vectors[0][1] = 0.0;
  const exact::Feature corner{{{0.1, 0.0, 0.2}, {}, {}}, 1};
  const exact::Sphere<3> sphere{{4.5, 0.0, 1.5}, 0.25};
  const auto expected = exact::geometry_of(sphere, corner, {1, 0, 0}, without, everything);
  at_every_level([&](Simd level) {
    PairGeometry found = arrays_of(1, everything);
    const PairGeometrySpans spans = found.spans();
    walls::FeatureBlock block(level, spans, lattice);
    block.add(0, sphere, corner);
    block.move_last({1, 0, 0}, 1U << 1);
    const bool is_open = !block.measure(1).empty();
    EXPECT_EQ(is_open, level == Simd::scalar);
    EXPECT_TRUE(is_open || has_bits_of(found, 0, expected));
  });
}

/// In a cell along the axes and in one that is not.
TEST(FeatureBlock, LeavesHardlyAnythingOpenOfAFloorBehindTheFacesOfACell) {
  Random random(1525);
  exact::Lattice straight, triclinic;
  straight.periodic = triclinic.periodic = {true, true, true};
  straight.vectors = {{{1.7, 0.0, 0.0}, {0.0, 2.3, 0.0}, {0.0, 0.0, 3.1}}};
  triclinic.vectors = {{{1.7, 0.0, 0.0}, {0.4, 2.3, 0.0}, {-0.3, 0.2, 3.1}}};
  for (const exact::Lattice& lattice : {straight, triclinic}) {
    for (int corners = 1; corners <= 3; ++corners) {
      std::vector<Contact> contacts(2000);
      for (Contact& contact : contacts) {
        const double x = random.uniform(0.2, 0.4), y = random.uniform(0.2, 0.4);
        contact = {{{x, y, random.uniform(0.1, 0.2)}, 0.3},
                   {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, corners},
                   {static_cast<std::int32_t>(random.below(100)), -7, 1}};
        follow_feature(contact, lattice);
      }
      at_every_level([&](Simd level) {
        if (level == Simd::scalar) return;
        EXPECT_LT(check(contacts, corners, everything, level, lattice), 20U) << corners;
      });
    }
  }
}

}  // namespace
}  // namespace abut::testing
