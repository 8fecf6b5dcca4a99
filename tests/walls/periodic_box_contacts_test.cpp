// Spheres against boxes in periodic domains: against all images in rational numbers.

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"
#include "walls/balls_and_solids.hpp"

#include <abut/abut.hpp>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using Numbers = std::vector<double>;

struct Moved {
  BoxContact contact;
  ImageShift shift;

  friend bool operator==(const Moved&, const Moved&) = default;
};

using System = BallsAndSolids;

/// Whole and half numbers, or numbers of all bits; some boxes are flat. Balls lie up to so many
/// cells outside.
System random_system(Random& random, const Domain& domain, int dimensions, bool coarse,
                     std::size_t cells) {
  System system{dimensions, {}, {}, {}, {}};
  const auto draw = [&] {
    return coarse ? static_cast<double>(random.below(9)) * 0.5 : random.uniform(0.0, 4.0);
  };
  for (std::size_t k = 0; k < 9; ++k) {
    std::array<double, 3> moved{};
    for (int axis = 0; axis < dimensions; ++axis) {
      if (!domain.is_periodic(axis)) continue;
      const double times = static_cast<double>(random.below(2 * cells + 1)) - double(cells);
      for (std::size_t c = 0; c < 3; ++c) moved[c] += times * domain.vector(axis)[c];
    }
    system.radius.push_back(coarse ? static_cast<double>(random.below(5)) * 0.5
                                   : random.uniform(0.0, 2.0));
    for (std::size_t axis = 0; axis < system.axes(); ++axis) {
      system.center[axis].push_back(draw() + moved[axis]);
      system.lower[axis].push_back(draw());
      const double width = random.below(4) == 0 ? 0.0 : draw();
      system.upper[axis].push_back(system.lower[axis].back() + width);
    }
  }
  return system;
}

/// Whether a moved box is so far away that rounding cannot matter.
bool clearly_apart(const System& system, const Domain& domain, double margin, const Moved& moved) {
  const auto [i, j] = std::pair(moved.contact.sphere, moved.contact.box);
  const std::int32_t numbers[] = {moved.shift.x, moved.shift.y, moved.shift.z};
  for (std::size_t axis = 0; axis < system.axes(); ++axis) {
    double x = system.center[axis][i];
    for (int k = 0; k < 3; ++k) x -= numbers[k] * domain.vector(k)[axis];
    const double reach = system.radius[i] + margin + 1e-6;
    if (x < system.lower[axis][j] - reach || x > system.upper[axis][j] + reach) return true;
  }
  return false;
}

/// Kind and sides of the nearest point of a moved box, if it is within reach.
bool touches(const System& system, const Domain& domain, double margin, Moved& moved) {
  const auto [i, j] = std::pair(moved.contact.sphere, moved.contact.box);
  const std::int32_t numbers[] = {moved.shift.x, moved.shift.y, moved.shift.z};
  mpq_class squared = 0;
  int bounds = 0;
  for (std::size_t axis = 0; axis < system.axes(); ++axis) {
    mpq_class x = system.center[axis][i];
    for (int k = 0; k < 3; ++k) x -= numbers[k] * mpq_class(domain.vector(k)[axis]);
    const mpq_class low = system.lower[axis][j];
    const mpq_class high = system.upper[axis][j];
    const mpq_class nearest = x < low ? low : x > high ? high : x;
    squared += (x - nearest) * (x - nearest);
    auto& side = moved.contact.feature.side[axis];
    side = static_cast<std::int8_t>(nearest == low ? -1 : nearest == high ? 1 : 0);
    bounds += side != 0 ? 1 : 0;
  }
  const int kind = bounds == 0 || system.dimensions == 3 ? bounds : bounds + 1;
  moved.contact.feature.kind = static_cast<FeatureKind>(kind);
  const mpq_class reach = mpq_class(system.radius[i]) + mpq_class(margin);
  return squared <= reach * reach;
}

std::vector<Moved> oracle(const System& system, const Domain& domain, double margin,
                          std::int32_t farthest) {
  const auto end = [&](int axis) { return domain.is_periodic(axis) ? farthest : 0; };
  std::vector<Moved> contacts;
  for (ElementIndex i = 0; i < system.radius.size(); ++i) {
    for (ElementIndex j = 0; j < system.lower[0].size(); ++j) {
      for (std::int32_t x = -end(0); x <= end(0); ++x) {
        for (std::int32_t y = -end(1); y <= end(1); ++y) {
          for (std::int32_t z = -end(2); z <= end(2); ++z) {
            Moved moved{{i, j, {}}, {x, y, z}};
            if (clearly_apart(system, domain, margin, moved)) continue;
            if (!touches(system, domain, margin, moved)) continue;
            for (const std::int32_t number : {x, y, z}) {
              EXPECT_LT(std::abs(number), farthest) << "the oracle looks not far enough";
            }
            contacts.push_back(moved);
          }
        }
      }
    }
  }
  return contacts;
}

std::vector<Moved> agreed(const System& system, const Domain& domain, double margin) {
  std::vector<Moved> first;
  for (const Algorithm algorithm :
       {Algorithm::automatic, Algorithm::direct_check, Algorithm::rows}) {
    for (const int threads : {1, 2, 7}) {
      const BoxContactList list = find_box_contacts(
          system.balls(), system.solids(), domain,
          {.algorithm = algorithm, .shifts = Shifts::stored, .margin = margin, .threads = threads});
      EXPECT_EQ(list.shifts().size(), list.size());
      std::vector<Moved> contacts;
      for (std::size_t k = 0; k < list.size(); ++k) contacts.push_back({list[k], list.shifts()[k]});
      if (first.empty()) first = contacts;
      EXPECT_EQ(contacts, first) << name_of(algorithm) << ", " << threads << " threads";
    }
  }
  return first;
}

TEST(PeriodicBoxContacts, AgreeWithRationalNumbers) {
  Random random(91);
  std::array<std::size_t, 4> kinds{};
  std::size_t with_shift = 0;
  const Domain in_2d[] = {Domain::periodic({3.0, 5.0}), Domain::periodic({unbounded, 2.0}),
                          Domain::lattice({3, 1}, {-1, 2.5}),
                          Domain::lees_edwards({4.0, 3.0}, 1.25)};
  const Domain in_3d[] = {Domain::periodic({3.0, 5.0, 4.0}),
                          Domain::periodic({3.0, unbounded, unbounded}),
                          Domain::lattice({0, 4, 0}, {5, 0.5, 0}, {1, -2, 3.5}),
                          Domain::lattice({0, 3, 3}, {3, 0, 3}, {3, 3, 0})};
  for (int dimensions = 2; dimensions <= 3; ++dimensions) {
    for (const Domain& domain : dimensions == 2 ? in_2d : in_3d) {
      for (const bool coarse : {true, false}) {
        const System system = random_system(random, domain, dimensions, coarse, 1);
        const double margin = coarse ? 0.0 : 0.25;
        const auto expected = oracle(system, domain, margin, 7);
        ASSERT_EQ(agreed(system, domain, margin), expected) << dimensions << "D";
        for (const Moved& moved : expected) {
          ++kinds[static_cast<std::size_t>(moved.contact.feature.kind)];
          with_shift += moved.shift != ImageShift{} ? 1 : 0;
        }
      }
    }
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 50U);
  EXPECT_GT(with_shift, 500U);
}

/// A ball in the corner of the cell, at its radius from the corner of a box in the opposite one;
/// 2, 3 and 6 away. With the radius below it is not touched.
TEST(PeriodicBoxContacts, TiesAcrossTheCornerOfTheCell) {
  const Domain domain = Domain::periodic({20.0, 20.0, 20.0});
  for (const double cells : {0.0, 1000000.0}) {
    System system{3, {}, {}, {}, {7.0}};
    const double centers[3] = {1.0, 2.0, 4.0};
    const double ends[3] = {19.0, 19.0, 18.0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      system.center[axis] = {centers[axis] + 20.0 * cells};
      system.lower[axis] = {ends[axis] - 5.0};
      system.upper[axis] = {ends[axis]};
    }
    const auto contacts = agreed(system, domain, 0.0);
    ASSERT_EQ(contacts.size(), 1U);
    const auto n = static_cast<std::int32_t>(cells) - 1;
    EXPECT_EQ(contacts[0].shift, (ImageShift{n, n, n}));
    EXPECT_EQ(contacts[0].contact.feature, (BoxFeature{FeatureKind::vertex, {1, 1, 1}}));
    system.radius[0] = std::nextafter(7.0, 0.0);
    EXPECT_TRUE(agreed(system, domain, 0.0).empty());
  }
}

/// A floor as wide as the cell, whose images meet: a ball over the seam touches both, at an edge.
TEST(PeriodicBoxContacts, AFloorThatSpansTheCell) {
  const Domain domain = Domain::periodic({4.0, 4.0, unbounded});
  const System system{3,
                      {Numbers{1.0, 4.0}, {1.0, 1.0}, {1.0, 1.0}},
                      {Numbers{0.0}, {0.0}, {-1.0}},
                      {Numbers{4.0}, {4.0}, {0.0}},
                      {1.0, 1.0}};
  const auto contacts = agreed(system, domain, 0.0);
  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_EQ(contacts[0].contact.feature, (BoxFeature{FeatureKind::face, {0, 0, 1}}));
  EXPECT_EQ(contacts[1].contact.feature, (BoxFeature{FeatureKind::edge, {1, 0, 1}}));
  EXPECT_EQ(contacts[2].contact.feature, (BoxFeature{FeatureKind::edge, {-1, 0, 1}}));
  EXPECT_EQ(contacts[2].shift, (ImageShift{1, 0, 0}));
}

TEST(PeriodicBoxContacts, WithARule) {
  const Domain domain = Domain::periodic({4.0, 4.0});
  const System system{2,
                      {Numbers{0.25, 3.5}, {0.5, 0.5}, {}},
                      {Numbers{3.0, 1.0}, {0.0, 0.0}, {}},
                      {Numbers{3.25, 1.25}, {1.0, 1.0}, {}},
                      {1.0, 1.0}};
  EXPECT_EQ(agreed(system, domain, 0.0).size(), 3U);
  const std::vector<ContactPair> pairs{{0, 0}};
  const ExclusionList exclusions(pairs, 2, 2);
  const Options options{.rule = {.exclusions = &exclusions}};
  const auto list = find_box_contacts(system.balls(), system.solids(), domain, options);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_TRUE(list.shifts().empty());
  EXPECT_EQ(list[0].box, 1U);
}

/// In cells of any size an error names what lies too far out, and nothing that does not.
TEST(PeriodicBoxContacts, WhatLiesTooFarOutIsNamedAtEveryScale) {
  for (const int exponent : {0, -500, -801, -1000, -1030}) {
    const double s = std::ldexp(1.0, exponent);
    const Numbers inside{0.5 * s}, radius{0.25 * s}, zero{0.0}, one{s};
    const Numbers far{0x1p40 * s}, farther{0x1p41 * s};
    const Domain square = Domain::periodic({s, s});
    expect_error(ErrorCode::invalid_input, {"element 1 has xmin", "counted from 1"}, [&] {
      static_cast<void>(find_box_contacts(discs(inside, inside, radius),
                                          rectangles(far, zero, farther, one), square));
    });
    expect_error(ErrorCode::invalid_input, {"element 0 has y"}, [&] {
      static_cast<void>(
          find_box_contacts(discs(inside, far, radius), rectangles(zero, zero, one, one), square));
    });
  }
}

TEST(PeriodicBoxContacts, BadInputIsRefused) {
  const Numbers far{0x1p40}, one{1.0};
  const Domain square = Domain::periodic({1.0, 1.0});
  const auto expect = [&](ErrorCode code, std::initializer_list<std::string_view> words,
                          const ElementView& balls, const Domain& domain) {
    expect_error(code, words, [&] {
      static_cast<void>(find_box_contacts(balls, rectangles(one, one, one, one), domain));
    });
  };
  expect(ErrorCode::invalid_input, {"element 0 has y = 1099511627776", "cells"},
         discs(one, far, 1.0), square);
  expect(ErrorCode::wrong_usage, {"3 dimensions"}, discs(one, one, 1.0),
         Domain::periodic({1.0, 1.0, 1.0}));
}

}  // namespace
}  // namespace abut::testing
