// Quantities as callers ask for them: with a list, afterwards, into their own arrays, in a visitor.

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

constexpr Quantities all_quantities =
    Quantity::gap | Quantity::normal | Quantity::point | Quantity::distance | Quantity::vector;

struct System {
  std::vector<double> x, y, z, r;

  [[nodiscard]] ElementView view() const { return spheres(x, y, z, r); }
  [[nodiscard]] ElementView boxes() const {
    return abut::boxes(x, y, z, upper(x), upper(y), upper(z));
  }

 private:
  [[nodiscard]] std::span<const double> upper(const std::vector<double>& lower) const {
    auto& column = uppers_[&lower];
    column.resize(lower.size());
    for (std::size_t k = 0; k < lower.size(); ++k) column[k] = lower[k] + r[k];
    return column;
  }
  mutable std::map<const void*, std::vector<double>> uppers_;
};

System some_system(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  System system;
  for (std::size_t k = 0; k < count; ++k) {
    system.x.push_back(random.uniform(0.0, 4.0));
    system.y.push_back(random.uniform(0.0, 4.0));
    system.z.push_back(random.uniform(0.0, 4.0));
    system.r.push_back(random.uniform(0.1, 0.4));
  }
  return system;
}

const Domain cube = Domain::periodic({4.0, 4.0, 4.0});

void expect_alike(const PairGeometry& expected, const PairList& list) {
  EXPECT_TRUE(std::ranges::equal(expected.gaps, list.gaps()));
  EXPECT_TRUE(std::ranges::equal(expected.normals, list.normals()));
  EXPECT_TRUE(std::ranges::equal(expected.points, list.points()));
  EXPECT_TRUE(std::ranges::equal(expected.distances, list.distances()));
  EXPECT_TRUE(std::ranges::equal(expected.vectors, list.vectors()));
}

TEST(Measure, GivesTheNumbersOfAHandMadeContact) {
  const std::vector<double> x{0.0, 3.0}, y{0.0, 4.0}, r{4.0, 2.0};
  const ElementView elements = discs(x, y, r);
  const PairList list =
      find_contact_pairs(elements, Domain::open(), {.quantities = all_quantities});
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list.gaps()[0], -1.0);
  EXPECT_EQ(list.distances()[0], 5.0);
  EXPECT_EQ(list.vectors()[0], (Vector{3.0, 4.0, 0.0}));
  EXPECT_EQ(list.normals()[0], (Vector{0.6, 0.8, 0.0}));
  EXPECT_EQ(list.points()[0], (Vector{2.1, 2.8, 0.0}));
}

TEST(Measure, ByAListIsMeasuringAfterwards) {
  const System system = some_system(400, 1520);
  for (const Domain& domain : {Domain::open(), cube}) {
    for (const ElementView& elements : {system.view(), system.boxes()}) {
      Options options{.shifts = Shifts::stored, .margin = 0.2};
      const PairList plain = find_contact_pairs(elements, domain, options);
      ASSERT_GT(plain.size(), 100U);
      EXPECT_TRUE(plain.gaps().empty());
      const PairGeometry expected = measure(elements, plain, all_quantities, domain);
      for (const int threads : {1, 2, 7}) {
        options = {.shifts = Shifts::none,
                   .quantities = all_quantities,
                   .margin = 0.2,
                   .threads = threads};
        const PairList list = find_contact_pairs(elements, domain, options);
        EXPECT_TRUE(list.shifts().empty());
        expect_alike(expected, list);
        Detector detector(options);
        detector.set_skin(Skin::fixed(0.1));
        expect_alike(expected, detector.find_contact_pairs(elements, domain));
        expect_alike(expected, detector.find_contact_pairs(elements, domain));
      }
    }
  }
}

TEST(Measure, HasTheGapsOfOnePair) {
  const System system = some_system(200, 1521);
  for (const ElementView& elements : {system.view(), system.boxes()}) {
    const PairList list = find_contact_pairs(
        elements, cube, {.shifts = Shifts::stored, .quantities = Quantity::gap, .margin = 0.3});
    ASSERT_GT(list.size(), 100U);
    EXPECT_TRUE(list.normals().empty());
    for (PairCount k = 0; k < list.size(); ++k) {
      ASSERT_EQ(list.gaps()[k], gap(elements, cube, list[k], list.shifts()[k]));
    }
  }
}

TEST(Measure, GoesOnWhereItsMeasurerIsMovedTo) {
  const std::vector<double> x{0.0, 3.0}, y{0.0, 4.0}, apart{0.0, 9.0};
  PairMeasurer measurer(discs(x, y, 1.0));
  PairMeasurer moved(std::move(measurer));
  PairMeasurer assigned(discs(apart, y, 1.0));
  assigned = std::move(moved);
  const std::vector<ContactPair> pairs{{0, 1}};
  std::vector<double> distances(1);
  assigned.measure(std::span<const ContactPair>(pairs), {.distances = distances});
  EXPECT_EQ(distances[0], 5.0);
}

TEST(Measure, OfTwoSets) {
  const System first = some_system(60, 1522);
  const System second = some_system(300, 1523);
  for (const auto& [a, b] :
       {std::pair(first.view(), second.view()), std::pair(first.boxes(), second.boxes())}) {
    for (const Domain& domain : {Domain::open(), cube}) {
      const Options options{.shifts = Shifts::stored, .quantities = all_quantities, .margin = 0.1};
      const PairList list = find_contact_pairs(a, b, domain, options);
      ASSERT_GT(list.size(), 20U);
      expect_alike(measure(a, b, list, all_quantities, domain), list);
      const NeighborList rows = build_neighbor_list(a, b, domain, options);
      EXPECT_TRUE(std::ranges::equal(rows.normals(), list.normals()));
      EXPECT_TRUE(std::ranges::equal(rows.points(), list.points()));
    }
  }
}

/// In a full list the entry of j has the opposite vectors, and its point lies beside j.
TEST(Measure, OfFullRowsIsAntisymmetric) {
  const System system = some_system(200, 1524);
  const Options options{.shifts = Shifts::stored, .quantities = all_quantities};
  const NeighborList list =
      build_neighbor_list(system.view(), cube, NeighborListKind::full, options);
  std::map<std::tuple<std::size_t, ElementIndex, ImageShift>, Vector> normals;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t k = 0; k < list[i].size(); ++k) {
      normals[{i, list[i][k], list.shifts_of(i)[k]}] = list.row(i, list.normals())[k];
    }
  }
  ASSERT_GT(normals.size(), 100U);
  for (const auto& [key, normal] : normals) {
    const auto& [i, j, n] = key;
    const Vector& back = normals.at({j, static_cast<ElementIndex>(i), {-n.x, -n.y, -n.z}});
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(normal[axis], 0.0 - back[axis]);
  }
}

TEST(Measure, InAVisitor) {
  const System system = some_system(300, 1525);
  const PairList list = find_contact_pairs(system.view(), cube, {.quantities = Quantity::point});
  const PairMeasurer measurer(system.view(), cube);
  std::vector<Vector> seen;
  std::mutex mutex;
  const auto visit = [&](std::span<const ContactPair> pairs, std::span<const ImageShift> shifts,
                         WorkerNumber) {
    std::vector<Vector> points(pairs.size());
    measurer.measure({pairs, shifts}, {.points = points});
    const std::lock_guard lock(mutex);
    seen.insert(seen.end(), points.begin(), points.end());
  };
  for_each_shifted_batch(system.view(), cube, {.threads = 3}, visit);
  std::vector<Vector> expected(list.points().begin(), list.points().end());
  ASSERT_GT(expected.size(), 50U);
  std::ranges::sort(seen);
  std::ranges::sort(expected);
  EXPECT_EQ(seen, expected);
}

TEST(Measure, OfNothing) {
  const std::vector<double> none;
  const PairGeometry geometry = measure(discs(none, none, none), PairList(), all_quantities);
  EXPECT_TRUE(geometry.gaps.empty());
  const System system = some_system(10, 1526);
  EXPECT_TRUE(measure(system.view(), PairList(), all_quantities, cube).points.empty());
}

TEST(Measure, RefusesWhatDoesNotFit) {
  const System system = some_system(10, 1527);
  const ElementView elements = system.view();
  const std::vector<ContactPair> pairs{{0, 9}, {3, 10}};
  const std::vector<ContactPair> good{{0, 9}, {3, 8}};
  const std::vector<ImageShift> shifts{{0, 0, 0}, {0, 1, 0}};
  std::vector<double> short_one(1);
  expect_error(ErrorCode::wrong_usage, {"element 10", "10 elements"},
               [&] { static_cast<void>(measure(elements, std::span(pairs), Quantity::gap)); });
  expect_error(ErrorCode::wrong_usage, {"gaps has 1", "2 pairs"},
               [&] { measure(elements, std::span(good), {.gaps = short_one}); });
  expect_error(ErrorCode::wrong_usage, {"without image shifts", "Shifts::stored"},
               [&] { static_cast<void>(measure(elements, std::span(good), Quantity::gap, cube)); });
  expect_error(ErrorCode::wrong_usage, {"along y"}, [&] {
    static_cast<void>(
        measure(elements, {std::span(good), std::span(shifts)}, Quantity::gap, Domain::open()));
  });
  expect_error(ErrorCode::wrong_usage, {"image shifts has 1"}, [&] {
    static_cast<void>(
        measure(elements, {std::span(good), std::span(shifts).first(1)}, Quantity::gap, cube));
  });
}

}  // namespace
}  // namespace abut::testing
