// What a device finds does not depend on the rounding mode or flush-to-zero setting of the thread
// that calls, and both are as before when the call returns or throws.

#include "device/face/face_detection.hpp"
#include "device/scene_in_two.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/caller_mode.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/neighbor_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

void expect_mode(const CallerMode& mode, const SeenMode& seen) {
  EXPECT_EQ(seen.rounding, mode.rounding);
  if (can_flush) {
    EXPECT_EQ(seen.flush, mode.flush);
  }
}

bool same_bits(std::span<const double> a, std::span<const double> b) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  return std::ranges::equal(a, b, {}, bits, bits);
}

/// What the calls of the face give of one set or of two.
struct Answers {
  PairList pairs;
  NeighborList rows;
  PairCount count = 0;
  std::uint64_t exact_decisions = 0;
};

Answers answers_for(const ElementView& elements, const ElementView* others, const Domain& domain,
                    double margin) {
  const Options options{.shifts = Shifts::stored, .quantities = Quantity::gap, .margin = margin};
  const device::ElementCopy copy(elements);
  device::Detector detector(options);
  Answers answers;
  if (others == nullptr) {
    answers.pairs = detector.find_contact_pairs(copy.elements(), domain).to_host();
    answers.rows =
        detector.build_neighbor_list(copy.elements(), domain, NeighborListKind::full).to_host();
    answers.count = detector.count_contact_pairs(copy.elements(), domain).contact_pairs;
  } else {
    const device::ElementCopy second(*others);
    answers.pairs =
        detector.find_contact_pairs(copy.elements(), second.elements(), domain).to_host();
    answers.rows =
        detector.build_neighbor_list(copy.elements(), second.elements(), domain).to_host();
    answers.count =
        detector.count_contact_pairs(copy.elements(), second.elements(), domain).contact_pairs;
  }
  answers.exact_decisions = answers.pairs.statistics().exact_decisions;
  return answers;
}

class FaceFloatEnvironment : public ::testing::TestWithParam<CallerMode> {
 protected:
  /// The same bytes in the mode as in the usual one, and the mode after all calls.
  static void check(const ElementView& elements, const Domain& domain, double margin = 0.0,
                    const ElementView* others = nullptr) {
    const Answers expected = answers_for(elements, others, domain, margin);
    EXPECT_FALSE(expected.pairs.empty());
    Answers found;
    SeenMode seen;
    {
      const Caller caller(GetParam());
      found = answers_for(elements, others, domain, margin);
      seen = seen_mode();
    }
    expect_mode(GetParam(), seen);
    EXPECT_TRUE(std::ranges::equal(found.pairs.pairs(), expected.pairs.pairs()));
    EXPECT_TRUE(std::ranges::equal(found.pairs.shifts(), expected.pairs.shifts()));
    EXPECT_TRUE(same_bits(found.pairs.gaps(), expected.pairs.gaps()));
    EXPECT_TRUE(std::ranges::equal(found.rows.offsets(), expected.rows.offsets()));
    EXPECT_TRUE(std::ranges::equal(found.rows.neighbors(), expected.rows.neighbors()));
    EXPECT_TRUE(std::ranges::equal(found.rows.shifts(), expected.rows.shifts()));
    EXPECT_TRUE(same_bits(found.rows.gaps(), expected.rows.gaps()));
    EXPECT_EQ(found.count, expected.pairs.size());
    EXPECT_EQ(found.exact_decisions, expected.exact_decisions);
  }

  /// Expects an error of the call in the mode, and the mode after it.
  static void check_error(ErrorCode code, const std::function<void()>& call) {
    SeenMode seen;
    bool refused = false;
    {
      const Caller caller(GetParam());
      try {
        call();
      } catch (const Error& error) {
        refused = error.code() == code;
      }
      seen = seen_mode();
    }
    EXPECT_TRUE(refused);
    expect_mode(GetParam(), seen);
  }
};

TEST_P(FaceFloatEnvironment, InOpenSpace) {
  for (const char* const name :
       {"at_reach_2d", "at_reach", "near_faces", "touching_fcc", "log_uniform"}) {
    SCOPED_TRACE(name);
    const Scene scene = scenes::scene_named(name).make(500, 17);
    check(view_of(scene), Domain::open());
    check(view_of(scene), Domain::open(), 0.3 * scene.radius[0]);
    const Float32Scene rounded(scene);
    check(rounded.view(), Domain::open(), 0.1 * scene.radius[0]);
  }
}

/// Distances of denormal numbers.
TEST_P(FaceFloatEnvironment, DenormalsAreSeen) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<HandMade> elements;
  for (int k = 0; k < 100; ++k) {
    elements.push_back({k * (k % 3 == 0 ? 3 : 2) * tiny, 0, 0, (k % 4) * tiny});
  }
  const Scene scene = scene_of(3, elements);
  check(view_of(scene), Domain::open());
  check(view_of(scene), Domain::open(), tiny);
}

TEST_P(FaceFloatEnvironment, InCells) {
  const Scene scene = scenes::scene_named("dense").make(300, 17);
  for (const Domain& domain : {Domain::periodic({9.0, unbounded, 9.1}),
                               Domain::lattice({9.1, 0.3, 0.1}, {0.7, 8.9, 0.2}, {-0.3, 0.1, 9.3}),
                               Domain::lees_edwards({9.0, 9.0, 9.0}, 17.3)}) {
    check(view_of(scene), domain, 0.1);
  }
  const Scene lattice = scenes::scene_named("touching_cubic").make(216, 17);
  const double side = 12.0 * lattice.radius[0];
  check(view_of(lattice), Domain::periodic({side, side, side}));
  // A reach beyond the cell, where elements are checked pair by pair.
  check(view_of(scene_of(2, {{0.3, 0.1, 0, 3.0}, {0.7, 5.9, 0, 2.9}})),
        Domain::lattice({1.0, 0.1}, {0.3, 1.1}));
}

TEST_P(FaceFloatEnvironment, OfBoxesAndTwoSets) {
  const Scene scene = scenes::scene_named("log_uniform").make(400, 17);
  const scenes::BoxScene boxes = scenes::boxes_in(scene, 17);
  const SceneInTwo sets(scenes::scene_named("at_reach").make(400, 17));
  const ElementView second = view_of(sets.second);
  const double side = *std::max_element(boxes.upper[0].begin(), boxes.upper[0].end());
  for (const Domain& domain : {Domain::open(), Domain::periodic({side, unbounded, unbounded})}) {
    check(view_of(boxes), domain, 0.1 * scene.radius[0]);
    check(view_of(sets.first), domain, 0.0, &second);
  }
}

/// -denormal is a negative margin also where the caller's denormals count as zero.
TEST_P(FaceFloatEnvironment, ErrorsAreTheSame) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  Scene scene = scenes::scene_named("dense").make(50, 17);
  const device::ElementCopy good(view_of(scene));
  check_error(ErrorCode::invalid_input,
              [&] { device::Detector({.margin = -tiny}).count_contact_pairs(good.elements()); });
  check_error(ErrorCode::limit_exceeded,
              [&] { device::Detector({.max_pairs = 1}).find_contact_pairs(good.elements()); });
  scene.radius[7] = -tiny;
  const device::ElementCopy bad(view_of(scene));
  check_error(ErrorCode::invalid_input, [&] {
    device::Detector().build_neighbor_list(bad.elements(), Domain::open(), NeighborListKind::half);
  });
}

INSTANTIATE_TEST_SUITE_P(Modes, FaceFloatEnvironment, ::testing::ValuesIn(caller_modes),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
