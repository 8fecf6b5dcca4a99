// Spheres against boxes: which part is touched, against rational numbers; errors.

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"
#include "walls/balls_and_solids.hpp"

#include <abut/abut.hpp>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using Numbers = std::vector<double>;

using System = BallsAndSolids;

/// Half of the numbers whole, so that spheres lie on bounds and touch exactly.
System random_system(scenes::Random& random, int dimensions, std::size_t count) {
  System system{dimensions, {}, {}, {}, {}};
  const auto draw = [&](std::size_t k) {
    return k % 2 == 0 ? static_cast<double>(random.below(9)) : random.uniform(0.0, 8.0);
  };
  for (std::size_t k = 0; k < count; ++k) {
    system.radius.push_back(static_cast<double>(random.below(4)) * 0.5);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
      system.center[axis].push_back(draw(k));
      const double end = draw(k);
      system.lower[axis].push_back(end);
      system.upper[axis].push_back(end + std::floor(random.uniform(0.0, 3.0)));
    }
  }
  return system;
}

std::vector<BoxContact> oracle(const System& system, double margin) {
  std::vector<BoxContact> contacts;
  for (std::size_t i = 0; i < system.radius.size(); ++i) {
    for (std::size_t j = 0; j < system.lower[0].size(); ++j) {
      mpq_class squared = 0;
      std::array<std::int8_t, 3> side{};
      int bounds = 0;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(system.dimensions); ++axis) {
        const mpq_class x = system.center[axis][i];
        const mpq_class low = system.lower[axis][j];
        const mpq_class high = system.upper[axis][j];
        const mpq_class nearest = x < low ? low : x > high ? high : x;
        squared += (x - nearest) * (x - nearest);
        side[axis] = static_cast<std::int8_t>(nearest == low ? -1 : nearest == high ? 1 : 0);
        bounds += side[axis] != 0 ? 1 : 0;
      }
      const mpq_class reach = mpq_class(system.radius[i]) + mpq_class(margin);
      if (squared > reach * reach) continue;
      const int kind = bounds == 0 || system.dimensions == 3 ? bounds : bounds + 1;
      contacts.push_back({static_cast<ElementIndex>(i),
                          static_cast<ElementIndex>(j),
                          {static_cast<FeatureKind>(kind), side}});
    }
  }
  return contacts;
}

TEST(BoxContacts, AgreeWithRationalNumbers) {
  scenes::Random random(81);
  std::array<std::size_t, 4> kinds{};
  for (int k = 0; k < 20; ++k) {
    const System system = random_system(random, 2 + k % 2, 120);
    const double margin = k % 4 < 2 ? 0.0 : 0.5;
    const std::vector<BoxContact> expected = oracle(system, margin);
    for (const int threads : {1, 2, 7}) {
      const BoxContactList found = find_box_contacts(system.balls(), system.solids(),
                                                     {.margin = margin, .threads = threads});
      ASSERT_EQ(std::vector(found.begin(), found.end()), expected);
      ASSERT_EQ(found.statistics().contact_pairs, expected.size());
    }
    for (const BoxContact& contact : expected) {
      ++kinds[static_cast<std::size_t>(contact.feature.kind)];
    }
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 100U);
}

TEST(BoxContacts, OfOneCube) {
  const std::vector<std::array<float, 3>> lower{{0, 0, 0}};
  const std::vector<std::array<float, 3>> upper{{2, 2, 2}};
  const std::vector<std::array<double, 3>> centers{{1, 1, 1},  {1, 1, 3}, {-1, 1, 1},
                                                   {1, 5, -3}, {4, 5, 8}, {2, 1, 1}};
  const Numbers radius{0.0, 1.0, 1.0, 4.25, 7.0, 0.0};
  const auto column_of = [&](std::size_t axis) {
    return Column<double>{&centers[0][axis], centers.size(), sizeof centers[0]};
  };
  const BoxContactList contacts = find_box_contacts(
      spheres(column_of(0), column_of(1), column_of(2), radius), boxes(lower, upper));
  ASSERT_EQ(contacts.size(), 6U);
  using enum FeatureKind;
  EXPECT_EQ(contacts[0], (BoxContact{0, 0, {interior, {0, 0, 0}}}));
  EXPECT_EQ(contacts[1], (BoxContact{1, 0, {face, {0, 0, 1}}}));
  EXPECT_EQ(contacts[2], (BoxContact{2, 0, {face, {-1, 0, 0}}}));
  EXPECT_EQ(contacts[3], (BoxContact{3, 0, {edge, {0, 1, -1}}}));
  EXPECT_EQ(contacts[4], (BoxContact{4, 0, {vertex, {1, 1, 1}}}));
  EXPECT_EQ(contacts[5], (BoxContact{5, 0, {face, {1, 0, 0}}}));
}

/// The first sphere is far away, and the rule counts it all the same.
TEST(BoxContacts, ARuleSaysWhoMayPair) {
  const Numbers x{100.0, 0.0, 0.0}, zeros{0.0, 0.0}, ones{1.0, 1.0};
  const ElementView balls = discs(x, x, 1.0);
  const ElementView solids = rectangles(zeros, zeros, ones, ones);
  EXPECT_EQ(find_box_contacts(balls, solids).size(), 4U);
  const std::vector<std::uint32_t> of_balls{9, 0, 1}, of_solids{0, 1};
  const Options options{
      .rule = {.elements = {.groups = of_balls}, .others = {.groups = of_solids}}};
  const BoxContactList contacts = find_box_contacts(balls, solids, options);
  ASSERT_EQ(contacts.size(), 2U);
  const BoxFeature corner{FeatureKind::vertex, {-1, -1, 0}};
  EXPECT_EQ(contacts[0], (BoxContact{1, 1, corner}));
  EXPECT_EQ(contacts[1], (BoxContact{2, 0, corner}));
}

TEST(BoxContacts, BadInputIsRefused) {
  const Numbers good{1.0}, bad{std::nan("")}, less{0.0};
  const ElementView ball = spheres(good, good, good, 1.0);
  const ElementView solid = boxes(good, good, good, good, good, good);
  const auto expect = [](ErrorCode code, std::initializer_list<std::string_view> words,
                         const ElementView& balls, const ElementView& solids,
                         const Options& options = {}) {
    expect_error(code, words,
                 [&] { static_cast<void>(find_box_contacts(balls, solids, options)); });
  };
  expect(ErrorCode::wrong_usage, {"spheres, given first"}, solid, ball);
  expect(ErrorCode::wrong_usage, {"spheres, given first"}, ball, ball);
  expect(ErrorCode::wrong_usage, {"spheres have 2", "boxes 3"}, discs(good, good, 1.0), solid);
  expect(ErrorCode::invalid_input, {"element 0", "y = nan"}, spheres(good, bad, good, 1.0), solid);
  expect(ErrorCode::invalid_input, {"second set", "element 0", "zmin = 1", "zmax = 0"}, ball,
         boxes(good, good, good, good, good, less));
  expect(ErrorCode::limit_exceeded, {"1 contacts", "0"}, ball, solid, {.max_pairs = 0});
}

TEST(BoxContacts, OfNothing) {
  const Numbers none, one{1.0};
  const ElementView ball = spheres(one, one, one, 1.0);
  const ElementView solid = boxes(one, one, one, one, one, one);
  EXPECT_EQ(find_box_contacts(ball, solid).size(), 1U);
  EXPECT_TRUE(find_box_contacts(spheres(none, none, none, 1.0), solid).empty());
  EXPECT_TRUE(find_box_contacts(ball, boxes(none, none, none, none, none, none)).empty());
}

}  // namespace
}  // namespace abut::testing
