// Candidates of a Detector with a skin survive elements that come, go, come back and change places;
// each step delivers the bytes of a fresh detection.

#include "support/error_expectations.hpp"
#include "support/moving_system.hpp"

#include <abut/detector.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using Ids = std::vector<std::uint64_t>;

void expect_as_fresh(Detector& detector, const ElementView& elements, const Domain& domain) {
  const PairList fresh = find_contact_pairs(elements, domain, detector.options());
  const PairList& kept = detector.find_contact_pairs(elements, domain);
  ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
  ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
  EXPECT_EQ(detector.skin_statistics().survivors, fresh.size());
}

/// A moving system whose elements have ids, some of which are away.
class Crowd {
 public:
  Crowd(int dimensions, const Motion& motion, std::uint64_t seed)
      : system(dimensions, 300, motion, seed), random_(seed) {
    // Small ids in space, large ones in the plane.
    const std::uint64_t scale = dimensions == 3 ? 1 : 1'000'000'007;
    for (std::uint64_t k = 0; k < system.scene.size(); ++k) ids.push_back(scale * (k + 500));
  }

  /// Now and then one comes, a few go, one comes back, and all change places.
  void step(int number) {
    system.step();
    if (number % 9 == 4) add(next_++);
    if (number % 11 == 5) remove(1 + random_.below(4));
    if (number % 13 == 6 && !away_.empty()) {
      add(away_.back());
      away_.pop_back();
    }
    if (number % 29 == 7) shuffle();
  }

  MovingSystem system;
  Ids ids;

 private:
  void add(std::uint64_t id) {
    system.add();
    ids.push_back(id);
  }
  void remove(std::size_t count) {
    for (; count > 0; --count) {
      const std::size_t gone = random_.below(ids.size());
      system.remove(gone);
      away_.push_back(ids[gone]);
      ids[gone] = ids.back();
      ids.pop_back();
    }
  }
  void shuffle() {
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::size_t other = random_.below(ids.size());
      system.exchange(k, other);
      std::swap(ids[k], ids[other]);
    }
  }

  scenes::Random random_;
  Ids away_;
  std::uint64_t next_ = 3;
};

class CrowdInSpace : public ::testing::TestWithParam<Space> {};

TEST_P(CrowdInSpace, EveryStepIsThatOfAFreshDetection) {
  constexpr int steps = 300;
  for (const int dimensions : {2, 3}) {
    for (const int threads : {1, 3}) {
      SCOPED_TRACE(std::to_string(dimensions) + "D, threads " + std::to_string(threads));
      Crowd crowd(dimensions, {.space = GetParam(), .growth = 1e-5, .wrapped = true}, 2004);
      Detector detector({.shifts = Shifts::stored, .threads = threads});
      detector.set_skin(Skin::fixed(0.4));
      for (int step = 0; step < steps; ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        detector.set_ids(crowd.ids);
        expect_as_fresh(detector, crowd.system.elements(), crowd.system.domain());
        if (::testing::Test::HasFatalFailure()) return;
        crowd.step(step);
      }
      const SkinStatistics& statistics = detector.skin_statistics();
      EXPECT_EQ(statistics.detections + statistics.reuses, static_cast<std::uint64_t>(steps));
      EXPECT_LE(statistics.detections, 60U);
      EXPECT_GE(statistics.detections, 3U);
      EXPECT_GE(statistics.carried, 50U);
      EXPECT_GE(statistics.inserted, 30U);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, CrowdInSpace, ::testing::ValuesIn(all_spaces),
                         [](const auto& space) { return std::string(name_of(space.param)); });

/// Discs in a row, 1 apart, with radius 1/2: each touches the next.
scenes::Scene entry_of(const std::vector<double>& places) {
  scenes::Scene scene;
  scene.dimensions = 2;
  for (const double x : places) {
    scene.x.push_back(x);
    scene.y.push_back(0.0);
    scene.radius.push_back(0.5);
  }
  return scene;
}

struct Row {
  explicit Row(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      places.push_back(static_cast<double>(k));
      ids.push_back(k);
    }
    detector.set_skin(Skin::fixed(0.25));
  }

  void detect() {
    detector.set_ids(ids);
    const scenes::Scene scene = entry_of(places);
    expect_as_fresh(detector, view_of(scene), Domain::open());
  }

  std::vector<double> places;
  Ids ids;
  Detector detector{Options{.threads = 1}};
};

TEST(SkinIds, RemovalAndRenumberingNeedNoDetection) {
  Row row(40);
  row.detect();
  row.places.erase(row.places.begin() + 10);
  row.ids.erase(row.ids.begin() + 10);
  row.detect();
  std::ranges::reverse(row.places);
  std::ranges::reverse(row.ids);
  row.detect();
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 1U);
  EXPECT_EQ(row.detector.skin_statistics().reuses, 3U);
  EXPECT_EQ(row.detector.skin_statistics().carried, 2U);
  EXPECT_EQ(row.detector.skin_statistics().inserted, 0U);
}

TEST(SkinIds, FewNewElementsAreSearchedForAlone) {
  Row row(40);
  row.detect();
  // Two that touch each other, one of them an old one too; in front, so that all numbers change.
  row.places.insert(row.places.begin(), {-1.0, -2.0});
  row.ids.insert(row.ids.begin(), {90, 80});
  row.detect();
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 1U);
  EXPECT_EQ(row.detector.skin_statistics().carried, 1U);
  EXPECT_EQ(row.detector.skin_statistics().inserted, 2U);
  EXPECT_EQ(row.detector.skin_statistics().survivors, 41U);
}

TEST(SkinIds, ManyNewElementsAreDetectedAnew) {
  Row row(40);
  row.detect();
  for (int k = 1; k <= 20; ++k) {
    row.places.push_back(-k);
    row.ids.push_back(static_cast<std::uint64_t>(100 + k));
  }
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 2U);
  EXPECT_EQ(row.detector.skin_statistics().carried, 0U);
}

/// The same id elsewhere is an element that moved far.
TEST(SkinIds, AnElementThatComesBackElsewhereInTheSameCallIsNoticed) {
  Row row(40);
  row.detect();
  row.places[3] = 100.0;
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 2U);
  std::swap(row.places[5], row.places[25]);  // without their ids
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 3U);
}

/// A new element has moved by nothing since it came, whatever the others have.
TEST(SkinIds, TheSkinIsUsedUpByTheOldElementsMotionToo) {
  Row row(40);
  row.detect();
  row.places[39] += 0.24;
  row.places.push_back(39.0 + 0.24 + 1.0 + 0.2);
  row.ids.push_back(77);
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 1U);
  row.places[39] += 0.005;
  row.places[40] -= 0.195;  // touches: the anchors are 1.44 apart
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().detections, 2U);
}

/// Without ids, elements at the end may come and go.
TEST(SkinIds, NumbersAreIdsWhereNoneAreGiven) {
  MovingSystem system(3, 400, {.space = Space::periodic, .wrapped = true}, 5);
  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(Skin::fixed(0.4));
  for (int step = 0; step < 30; ++step) {
    expect_as_fresh(detector, system.elements(), system.domain());
    if (step == 4) system.add();
    if (step == 8) system.remove(system.scene.size() - 1);
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
  EXPECT_EQ(detector.skin_statistics().carried, 2U);
  EXPECT_EQ(detector.skin_statistics().inserted, 1U);
}

/// Larger than its cell, it meets its own images in several directions.
TEST(SkinIds, ANewElementMeetsItsOwnImages) {
  MovingSystem system(2, 100, {}, 7);
  const Domain domain = Domain::periodic({2.0, 40.0});
  Ids ids;
  for (std::uint64_t k = 0; k < 100; ++k) ids.push_back(500 - k);
  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(Skin::fixed(0.1));
  detector.set_ids(ids);
  expect_as_fresh(detector, system.elements(), domain);
  for (std::uint64_t id : {1'000U, 1U}) {
    system.add();
    system.scene.radius.back() = 2.2;
    system.scene.x.back() += 37.0;
    ids.push_back(id);
    system.exchange(ids.size() - 1, 50);
    std::swap(ids.back(), ids[50]);
    detector.set_ids(ids);
    expect_as_fresh(detector, system.elements(), domain);
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
  EXPECT_EQ(detector.skin_statistics().inserted, 2U);
}

TEST(SkinIds, RefusesIdsThatComeTwiceOrAreTooFew) {
  Row row(4);
  row.detect();
  const Ids twice{5, 8, 9, 8};
  expect_error(ErrorCode::invalid_input, {"elements 1 and 3", "id 8"},
               [&] { row.detector.set_ids(twice); });
  row.detect();
  EXPECT_EQ(row.detector.skin_statistics().reuses, 1U) << "as if nothing had happened";
  const Ids few{1, 2, 3};
  row.detector.set_ids(few);
  const scenes::Scene scene = entry_of(row.places);
  expect_error(ErrorCode::invalid_input, {"3 ids", "4 elements"},
               [&] { row.detector.count_contact_pairs(view_of(scene)); });
  row.detector.set_ids({});
  EXPECT_EQ(row.detector.count_contact_pairs(view_of(scene)).contact_pairs, 3U);
}

/// Ids say nothing of two sets, and nothing to a detector without a skin.
TEST(SkinIds, NeverChangeAResult) {
  MovingSystem system(3, 300, {.space = Space::periodic}, 3);
  Ids ids;
  for (std::uint64_t k = 0; k < 300; ++k) ids.push_back(k * k);
  Detector detector({.shifts = Shifts::stored});
  detector.set_ids(ids);
  const PairList fresh = find_contact_pairs(system.elements(), system.domain(), detector.options());
  EXPECT_TRUE(std::ranges::equal(
      fresh.pairs(), detector.find_contact_pairs(system.elements(), system.domain()).pairs()));
  MovingSystem others(3, 50, {}, 4);
  EXPECT_EQ(detector.count_contact_pairs(others.elements(), system.elements(), system.domain())
                .contact_pairs,
            find_contact_pairs(others.elements(), system.elements(), system.domain()).size());
}

}  // namespace
}  // namespace abut::testing
