// Candidates of elements whose numbers follow space are kept in one order only, which is canonical;
// what a Detector makes of them is, byte for byte, what a fresh detection finds.

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "skin/candidate_layout.hpp"
#include "support/error_expectations.hpp"
#include "support/moving_system.hpp"

#include <abut/column.hpp>
#include <abut/detector.hpp>
#include <abut/simd.hpp>
#include <abut/spatial_order.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::size_t many = 1500;

void sort_along_space(scenes::Scene& scene) {
  const std::vector<ElementIndex> order = spatial_order(view_of(scene));
  for (auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
    if (column->empty()) continue;
    const std::vector<double> before = *column;
    for (std::size_t k = 0; k < order.size(); ++k) (*column)[k] = before[order[k]];
  }
}

void expect_as_fresh(Detector& detector, const ElementView& elements, const Domain& domain) {
  const PairList fresh = find_contact_pairs(elements, domain, detector.options());
  const PairList& kept = detector.find_contact_pairs(elements, domain);
  ASSERT_GT(fresh.size(), elements.size() / 4);
  ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
  ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
}

skin::CandidateLayout arranged(base::MemoryMeter& memory, const scenes::Scene& scene,
                               double margin) {
  const PairList found = find_contact_pairs(view_of(scene), Domain::open(), {.margin = margin});
  base::ProgressReporter progress;
  base::WorkCounter work(progress, 0);
  const std::span<const ContactPair> piece = found.pairs();
  skin::CandidateLayout layout(memory);
  layout.arrange(lists::PairPieces(&piece, 1), {}, scene.size(), 1, work);
  return layout;
}

/// What the other tests of this file say about elements along space they say of one order only
/// because of this.
TEST(CandidatesAlongSpace, StandInOneOrder) {
  for (const int dimensions : {2, 3}) {
    base::MemoryMeter memory;
    scenes::Scene scene = MovingSystem(dimensions, many, {}, 3).scene;
    const skin::CandidateLayout shuffled = arranged(memory, scene, 0.3);
    EXPECT_FALSE(shuffled.follows_space());
    sort_along_space(scene);
    const skin::CandidateLayout sorted = arranged(memory, scene, 0.3);
    EXPECT_TRUE(sorted.follows_space());
    const PairList canonical = find_contact_pairs(view_of(scene), Domain::open(),
                                                  {.order = Order::canonical, .margin = 0.3});
    ASSERT_EQ(sorted.candidates().size(), canonical.size());
    for (std::size_t k = 0; k < canonical.size(); ++k) {
      ASSERT_EQ(sorted.pair_of(sorted.candidates()[k]), canonical[k]);
    }
  }
}

/// Fewer candidates than elements: only elements with candidates are read, in slots.
TEST(CandidatesAlongSpace, AFewOfThemStandInSlots) {
  base::MemoryMeter memory;
  scenes::Scene scene = MovingSystem(3, many, {}, 3).scene;
  for (double& radius : scene.radius) radius *= 0.5;
  sort_along_space(scene);
  const skin::CandidateLayout layout = arranged(memory, scene, 0.0);
  EXPECT_FALSE(layout.follows_space());
  EXPECT_GT(layout.candidates().size(), 0U);
  EXPECT_LT(layout.slot_count(), many);
}

class AlongSpace : public ::testing::TestWithParam<Space> {};

TEST_P(AlongSpace, EveryStepIsThatOfAFreshDetection) {
  for (const int dimensions : {2, 3}) {
    for (const int threads : {1, 3}) {
      for (const Simd level : simd_levels()) {
        if (!available(level)) continue;
        SCOPED_TRACE(std::to_string(dimensions) + "D, threads " + std::to_string(threads));
        MovingSystem system(dimensions, many, {.space = GetParam(), .wrapped = true}, 7);
        sort_along_space(system.scene);
        Detector detector({.order = Order::canonical,
                           .shifts = Shifts::stored,
                           .threads = threads,
                           .simd = level});
        detector.set_skin(Skin::fixed(0.3));
        for (int step = 0; step < 12; ++step) {
          SCOPED_TRACE("step " + std::to_string(step));
          expect_as_fresh(detector, system.elements(), system.domain());
          if (::testing::Test::HasFatalFailure()) return;
          system.step();
        }
        EXPECT_GE(detector.skin_statistics().reuses, 9U);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, AlongSpace, ::testing::ValuesIn(all_spaces),
                         [](const auto& space) { return std::string(name_of(space.param)); });

TEST(CandidatesAlongSpace, OfFloatsAndWithQuantities) {
  MovingSystem system(3, many, {}, 9);
  sort_along_space(system.scene);
  const auto in_floats = [](const std::vector<double>& column) {
    return std::vector<float>(column.begin(), column.end());
  };
  Detector detector(
      {.order = Order::canonical, .quantities = Quantity::gap | Quantity::normal, .threads = 1});
  detector.set_skin(Skin::fixed(0.3));
  for (int step = 0; step < 4; ++step, system.step()) {
    const std::array<std::vector<float>, 4> columns{
        in_floats(system.scene.x), in_floats(system.scene.y), in_floats(system.scene.z),
        in_floats(system.scene.radius)};
    const ElementView elements = spheres(columns[0], columns[1], columns[2], columns[3]);
    const PairList fresh = find_contact_pairs(elements, Domain::open(), detector.options());
    expect_as_fresh(detector, elements, Domain::open());
    const PairList& kept = detector.find_contact_pairs(elements);
    EXPECT_TRUE(std::ranges::equal(fresh.gaps(), kept.gaps()));
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
}

/// Elements that leave, come and change places, and go back to shuffled numbers.
TEST(CandidatesAlongSpace, AreCarriedOverToOtherNumbers) {
  MovingSystem system(3, many, {.space = Space::periodic, .wrapped = true}, 11);
  sort_along_space(system.scene);
  std::vector<std::uint64_t> ids(many);
  for (std::size_t k = 0; k < many; ++k) ids[k] = k;
  Detector detector({.order = Order::canonical, .shifts = Shifts::stored, .threads = 1});
  detector.set_skin(Skin::fixed(0.3));
  scenes::Scene& scene = system.scene;
  const auto swap = [&](std::size_t i, std::size_t k) {
    for (auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
      std::swap((*column)[i], (*column)[k]);
    }
    std::swap(ids[i], ids[k]);
  };
  scenes::Random random(5);
  for (int step = 0; step < 6; ++step) {
    detector.set_ids(ids);
    for (int call = 0; call < 2; ++call) {
      expect_as_fresh(detector, system.elements(), system.domain());
      if (::testing::Test::HasFatalFailure()) return;
    }
    if (step == 3) {
      for (std::size_t k = 0; k < many; ++k) swap(k, random.below(many));
    }
    swap(10, 700);
    ids[20] = 10000 + static_cast<std::uint64_t>(step);
    scene.x[20] = random.uniform(0.0, system.side());
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
  EXPECT_EQ(detector.skin_statistics().carried, 5U);
}

/// The first one, though a worker that sees an element far beyond the skin looks no further, and
/// another one finds a bad element too.
TEST(CandidatesAlongSpace, ABadElementIsNamedInAReuse) {
  for (const int threads : {1, 3}) {
    MovingSystem system(3, 3 * many, {}, 13);
    sort_along_space(system.scene);
    Detector detector({.threads = threads});
    detector.set_skin(Skin::fixed(0.3));
    const std::size_t contacts = detector.find_contact_pairs(system.elements()).size();
    EXPECT_EQ(detector.find_contact_pairs(system.elements()).size(), contacts);
    const scenes::Scene before = system.scene;
    system.scene.x[5] += 100.0;  // no error
    system.scene.y[1400] = std::numeric_limits<double>::quiet_NaN();
    system.scene.radius[3900] = -1.0;
    expect_error(ErrorCode::invalid_input, {"1400", "y"},
                 [&] { detector.find_contact_pairs(system.elements()); });
    system.scene = before;
    EXPECT_EQ(detector.find_contact_pairs(system.elements()).size(), contacts);
    EXPECT_EQ(detector.skin_statistics().detections, 1U);
  }
}

/// Radii that change from call to call, up and down, and margins that do.
TEST(CandidatesAlongSpace, RadiiAndMarginsChange) {
  for (const int dimensions : {2, 3}) {
    MovingSystem system(dimensions, many, {.growth = 0.003}, 17);
    sort_along_space(system.scene);
    Detector detector({.order = Order::canonical});
    detector.set_skin(Skin::fixed(0.3));
    for (int step = 0; step < 40; ++step, system.step()) {
      detector.set_options({.order = Order::canonical, .margin = 0.02 * (step % 3)});
      for (std::size_t k = 0; k < many; k += 7) system.scene.radius[k] *= step % 2 == 0 ? 0.9 : 1.1;
      expect_as_fresh(detector, system.elements(), Domain::open());
      if (::testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GE(detector.skin_statistics().reuses, 20U);
  }
}

/// Elements that were not gathered in one call are in the next, where they are to be measured.
TEST(CandidatesAlongSpace, QuantitiesAreThoseOfThisCall) {
  MovingSystem system(3, many, {}, 19);
  sort_along_space(system.scene);
  Detector detector;
  detector.set_skin(Skin::fixed(0.3));
  for (int step = 0; step < 6; ++step, system.step()) {
    Options options{.order = Order::canonical};
    if (step % 3 == 2) options.quantities = Quantity::gap;
    detector.set_options(options);
    const PairList fresh = find_contact_pairs(system.elements(), Domain::open(), options);
    const PairList& kept = detector.find_contact_pairs(system.elements());
    ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
    ASSERT_TRUE(std::ranges::equal(fresh.gaps(), kept.gaps()));
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
}

/// Whole numbers are chosen before the elements are read. They hold for elements that have left the
/// box of their anchors, as far as the skin lets them: two beyond it are not taken for one.
TEST(CandidatesAlongSpace, MayDriftOutOfTheBoxOfTheirAnchors) {
  std::vector<double> x;
  for (int k = 0; k < 64; ++k) x.push_back(k - 31.5);
  x.insert(x.end() - 1, 31.25);
  const std::vector<double> y(x.size(), 0.0);
  Detector detector;
  detector.set_skin(Skin::fixed(2.2));
  for (const double drift : {0.0, 1.05, -2.0}) {
    for (double& place : x) place += drift;
    EXPECT_EQ(detector.find_contact_pairs(discs(x, y, 0.1)).size(), 0U);
  }
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
}

/// Pairs that touch exactly are decided on the caller's numbers, however these are stored: a few,
/// which are read where they lie, and many, for which elements are gathered.
TEST(CandidatesAlongSpace, TiesAreReadWhereTheyLie) {
  struct Ball {
    float radius, x, other, y, z;
  };
  MovingSystem system(3, many, {}, 23);
  sort_along_space(system.scene);
  const scenes::Scene& scene = system.scene;
  for (const std::size_t between : {std::size_t{100}, std::size_t{3}}) {
    std::vector<Ball> balls(many);
    const auto read = [&](const std::vector<double>& column, std::size_t k) {
      return static_cast<float>(column[k]);
    };
    for (std::size_t k = 0; k < many; ++k) {
      balls[k] = {read(scene.radius, k), read(scene.x, k), -7.0f, read(scene.y, k),
                  read(scene.z, k)};
    }
    for (std::size_t k = 0; k + 1 < many; k += between) {
      balls[k].radius = balls[k + 1].radius = 0.25f;
      balls[k].x = std::floor(balls[k].x);
      balls[k + 1] = balls[k];
      balls[k + 1].x += 0.5f;
    }
    const auto columns = [&](float Ball::*number) {
      return Column<float>{&(balls[0].*number), many, sizeof(Ball)};
    };
    const ElementView elements(std::array{columns(&Ball::x), columns(&Ball::y), columns(&Ball::z)},
                               columns(&Ball::radius));
    Detector detector({.order = Order::canonical});
    detector.set_skin(Skin::fixed(0.3));
    for (int call = 0; call < 3; ++call) {
      expect_as_fresh(detector, elements, Domain::open());
      const PairList& kept = detector.find_contact_pairs(elements);
      EXPECT_GE(kept.statistics().exact_decisions + 2, many / between);
      balls[call == 0 ? 101 : 201].x += call == 0 ? 1e-7f : -1e-7f;
    }
    EXPECT_EQ(detector.skin_statistics().detections, 1U);
  }
}

/// A row whose candidates are the next two of each. None is lost when the two largest displacements
/// come as close to the skin as a double can, nor when they use it up.
TEST(CandidatesAlongSpace, LastToTheLimitOfTheSkin) {
  constexpr std::size_t count = 300;
  std::vector<double> x;
  for (std::size_t k = 0; k < count; ++k) x.push_back(1.5 * static_cast<double>(k));
  const std::vector<double> y(count, 0.0);
  Detector detector;
  detector.set_skin(Skin::fixed(2.0));
  const auto pairs = [&] { return detector.find_contact_pairs(discs(x, y, 0.5)).size(); };
  EXPECT_EQ(pairs(), 0U);
  EXPECT_EQ(detector.skin_statistics().candidates, 2 * count - 3);
  x[100] += 0.25;
  EXPECT_EQ(pairs(), 0U);
  x[101] -= 0.25;
  EXPECT_EQ(pairs(), 1U);
  x[200] -= 1.75 - 0x1p-40;
  EXPECT_EQ(pairs(), 2U);
  EXPECT_EQ(detector.skin_statistics().detections, 1U);
  x[200] -= 0x1p-40;
  EXPECT_EQ(pairs(), 2U);
  x[201] -= 2.5;
  EXPECT_EQ(pairs(), 4U);
  EXPECT_GE(detector.skin_statistics().detections, 2U);
}

TEST(CandidatesAlongSpace, OneElementAndNone) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    const std::vector<double> x(count, 0.5);
    Detector detector;
    detector.set_skin(Skin::fixed(0.5));
    for (int call = 0; call < 3; ++call) {
      EXPECT_EQ(detector.find_contact_pairs(spheres(x, x, x, 0.5)).size(), count / 2);
    }
    EXPECT_EQ(detector.skin_statistics().reuses, 2U);
  }
}

}  // namespace
}  // namespace abut::testing
