// What is refused in periodic domains, what looks like it and is not, and limits of pairs and
// bytes: the stages of the device engine say what `rows` says.

#include "device/host/as_rows.hpp"
#include "device/host/host_detection.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/device.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// How many pairs there are, or the code and the sentence of the error.
std::string outcome_of(const std::function<PairCount()>& count) {
  try {
    return std::to_string(count()) + " pairs";
  } catch (const Error& error) {
    return "error " + std::to_string(static_cast<int>(error.code())) + ": " + error.what();
  }
}

/// Expects that counting and listing end as with `rows`, and returns how.
std::string expect_same_outcome(const Scene& scene, const Domain& domain, double margin = 0.0) {
  const std::string expected = outcome_of([&] {
    return count_contact_pairs(view_of(scene), domain,
                               {.algorithm = Algorithm::rows, .margin = margin})
        .contact_pairs;
  });
  for (const auto order : {device::ItemOrder::ascending, device::ItemOrder::shuffled}) {
    const HostRun run{.order = order, .domain = domain, .shifts = Shifts::stored};
    EXPECT_EQ(outcome_of([&] { return list_on_host(view_of(scene), margin, run).count; }),
              expected);
    EXPECT_EQ(outcome_of([&] { return count_on_host(view_of(scene), margin, run).count; }),
              expected);
  }
  return expected;
}

bool tells(const std::string& outcome, const char* words) {
  return outcome.find(words) != std::string::npos;
}

/// Vectors of which one leans over 2^40 times the other: shifts of most images exceed 32 bits.
TEST(DeviceFarShifts, AreRefusedOnlyWherePairsHaveThem) {
  const Domain leaning = Domain::lattice({1.0, 0.0}, {0x1p40 + 0.5, 0.875});
  const auto outcome = [&](double radius) {
    return expect_same_outcome(scene_of(2, {{0.25, 0.5, 0, radius}}), leaning);
  };
  EXPECT_EQ(outcome(0.46875), "0 pairs");
  EXPECT_EQ(outcome(0.5), "1 pairs");
  EXPECT_EQ(outcome(0.50375), "1 pairs");
  EXPECT_TRUE(tells(outcome(0.504), "elements 0 and 0 pair across more than 2147483647"));
  const Domain wide = Domain::lattice({1.0, 0.0}, {0x1p40 + 0.5, 400.0});
  EXPECT_EQ(expect_same_outcome(scene_of(2, {{0.25, 0.5, 0, 199.0}}), wide), "398 pairs");
  EXPECT_TRUE(tells(expect_same_outcome(scene_of(2, {{0.25, 0.5, 0, 200.5}}), wide),
                    "pair across more than 2147483647"));
}

/// Two elements each nearly 2^31 cells out, to opposite sides: their shift is too large, if they
/// pair.
TEST(DeviceFarShifts, OfElementsFarOut) {
  const Domain strip = Domain::periodic({1.0, unbounded});
  const auto outcome = [&](double cells, double y) {
    return expect_same_outcome(scene_of(2, {{cells, 0.0, 0, 0.2}, {-cells, y, 0, 0.2}}), strip);
  };
  EXPECT_EQ(outcome(1073741823.0, 0.1), "1 pairs");
  EXPECT_EQ(outcome(1073741824.0, std::nextafter(0.4, 1.0)), "0 pairs");
  EXPECT_EQ(outcome(1073741824.0, 1.0), "0 pairs");
  EXPECT_TRUE(tells(outcome(1073741824.0, 0.1), "elements 0 and 1 pair across more"));
}

/// A number beyond 2^960 on the open axis says nothing about how many cells away the others lie:
/// these are moved into the cell, instead of images to where they are.
TEST(DevicePeriodicLimits, OfANumberFarOutOnTheOpenAxis) {
  const Domain strip = Domain::periodic({1.0, unbounded});
  for (const double cells : {1e5, 1e9}) {
    const Scene scene =
        scene_of(2, {{0.5, 0.0, 0, 0.25}, {0.5 + cells, 0.25, 0, 0.25}, {0.25, 1e300, 0, 0.125}});
    EXPECT_EQ(expect_same_outcome(scene, strip), "1 pairs");
    EXPECT_LE(count_on_host(view_of(scene), 0.0, {.domain = strip}).searched, 6U);
  }
  const Scene beyond =
      scene_of(2, {{0.5, 0, 0, 0.25}, {1e11, 0, 0, 0.25}, {0.25, 1e300, 0, 0.125}});
  EXPECT_TRUE(tells(expect_same_outcome(beyond, strip), "element 1 has x"));
}

TEST(DevicePeriodicLimits, OfCells) {
  const Domain square = Domain::periodic({1.0, 1.0});
  const auto at = [](double x, double radius) {
    return scene_of(2, {{0.5, 0.5, 0, 0.1}, {0.25, x, 0, radius}, {0.5, 0.75, 0, 0.1}});
  };
  EXPECT_TRUE(tells(expect_same_outcome(at(2147483646.5, 0.1), square), " pairs"));
  EXPECT_TRUE(tells(expect_same_outcome(at(2147483649.0, 0.1), square),
                    "element 1 has y = 2147483649; it lies more than 2147483647 cells"));
  EXPECT_TRUE(tells(expect_same_outcome(at(0.0, 2e9), square),
                    "element 1 has radius = 2e+09; it reaches over more than"));
  EXPECT_TRUE(tells(expect_same_outcome(at(0.0, 0.1), square, 3e9), "it reaches over more than"));
}

/// Along a vector 2^-92 as long as the other no number tells where an element lies.
TEST(DevicePeriodicLimits, OfVectorsOfVeryUnequalLengths) {
  const Scene scene = scene_of(2, {{0.25, -0.25, 0, 0x1p-92}, {0.5, -0.5, 0, 0x1p-92}});
  const Domain domain = Domain::lattice({1.0, -1.0}, {0x1p-92, 0x1p-92});
  EXPECT_TRUE(tells(expect_same_outcome(scene, domain), "differ so much in length"));
}

std::uint64_t tests_of_rows(const Scene& scene, const Domain& domain) {
  return count_contact_pairs(view_of(scene), domain, {.algorithm = Algorithm::rows})
      .candidate_tests;
}

/// Where one vector is so short that there are far more images than elements, these are checked
/// pair by pair, as `rows` checks them.
TEST(DevicePeriodicLimits, ImagesAreNotComparedWithEachOther) {
  for (const int ratio : {-56, -60, -62}) {
    const double s = std::ldexp(1.0, ratio);
    const Domain domain = Domain::lattice({1.0, -1.0}, {s, s});
    const Scene scene = scene_of(2, {{0.25, -0.25, 0, s}, {0.5, -0.5, 0, s}});
    EXPECT_EQ(expect_same_outcome(scene, domain), "2 pairs");
    const HostAnswer answer = count_on_host(view_of(scene), 0.0, {.domain = domain});
    EXPECT_LE(answer.candidate_tests, tests_of_rows(scene, domain));
  }
  const Domain thin = Domain::lattice({1.0, -1.0, 0.0}, {0x1p-12, 0x1p-12, 0.0}, {0.0, 0.0, 1.0});
  const Scene scene = scene_of(3, {{0.25, -0.25, 0, 0.125}, {0.375, -0.375, 0, 0.125}});
  EXPECT_TRUE(tells(expect_same_outcome(scene, thin), " pairs"));
  const HostAnswer answer = count_on_host(view_of(scene), 0.0, {.domain = thin});
  EXPECT_GT(answer.count, 1000U);
  EXPECT_LE(answer.candidate_tests, tests_of_rows(scene, thin));
}

TEST(DevicePeriodicLimits, OfNumbers) {
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_TRUE(
      tells(expect_same_outcome(scene_of(2, {{largest, 0x1p1022, 0, 0x1p1010},
                                             {largest, 0x1p1021, 0, 0x1p1019},
                                             {largest - 0x1p1017, 0x1p1022, 0, 0x1p1018}}),
                                Domain::lattice({-0x1p1017, 0x1p1020}, {0.0, 1.0}, Axes::x)),
            " pairs"));
  const auto stray = [](int side, int exponent) {
    const double s = std::ldexp(1.0, side);
    return expect_same_outcome(scene_of(2, {{0.125 * s, 0, 0, 0.125 * s},
                                            {-0.125 * s, 0, 0, 0.125 * s},
                                            {0, std::ldexp(1.0, exponent), 0, 0.25 * s}}),
                               Domain::periodic({s, unbounded}));
  };
  EXPECT_EQ(stray(-801, 720), "1 pairs");
  EXPECT_EQ(stray(-1060, 720), "1 pairs");
  EXPECT_EQ(stray(-800, 1023), "1 pairs");
  EXPECT_TRUE(tells(stray(-801, 721), "shorter than 2^-800"));
}

/// Also where there is no element.
TEST(DevicePeriodicLimits, OfUnequalVectors) {
  for (const Scene& scene : {scene_of(2, {{0x1p-201, 0.0, 0, 0x1p-203}}), scene_of(2, {})}) {
    const auto outcome = [&](int ratio) {
      return expect_same_outcome(scene,
                                 Domain::periodic({0x1p-200, std::ldexp(0.75, ratio - 200)}));
    };
    EXPECT_EQ(outcome(450), "0 pairs");
    EXPECT_TRUE(tells(outcome(451), "shorter than 2^-450 of the longest"));
  }
}

/// What is rounded along a vector that is by 2^62 to 2^92 longer covers 2^31 and more images of the
/// short one in the windows that hold for all elements. Those of two elements hold few.
TEST(DevicePeriodicLimits, OfWindowsThatRoundingMakesWide) {
  for (int ratio = -62; ratio >= -92; --ratio) {
    SCOPED_TRACE(ratio);
    const double s = std::ldexp(1.0, ratio);
    const Domain domain = Domain::lattice({1.0, -1.0}, {s, s});
    const Scene scene = scene_of(2, {{0.25, -0.25, 0, s}, {0.5, -0.5, 0, s}});
    const std::string outcome = expect_same_outcome(scene, domain);
    if (ratio < -83) {
      EXPECT_TRUE(tells(outcome, "differ so much in length")) << outcome;
      continue;
    }
    EXPECT_EQ(outcome, "2 pairs");
    EXPECT_LE(count_on_host(view_of(scene), 0.0, {.domain = domain}).candidate_tests,
              tests_of_rows(scene, domain));
  }
}

/// More images than numbers of 32 bits: said before any is stored.
TEST(DevicePeriodicLimits, OfImages) {
  const Scene scene = scene_of(2, {{0.0, 0.0, 0, 40000.0}});
  for (const std::uint64_t bytes : {std::uint64_t{1} << 20, base::MemoryMeter::unbounded}) {
    expect_error(ErrorCode::limit_exceeded, {"4294967294 periodic images"}, [&] {
      static_cast<void>(list_on_host(view_of(scene), 0.0,
                                     {.max_bytes = bytes, .domain = Domain::periodic({1.0, 1.0})}));
    });
  }
}

TEST(DevicePeriodicLimits, TheFirstBadElementIsNamed) {
  Scene scene = scenes::scene_named("dense").make(100, 1);
  scene.z[37] = std::numeric_limits<double>::quiet_NaN();
  scene.x[80] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(tells(expect_same_outcome(scene, Domain::periodic({9.0, 9.0, 9.0})), "element 37"));
}

/// Some elements of a scene in a cell that they fill, and a few cells out.
struct FilledCell {
  Scene scene = scenes::scene_named("graded").make(1500, 1);
  Domain domain = Domain::open();

  FilledCell() {
    double side = 0.0;
    for (const double x : scene.x) side = std::max(side, x);
    domain = Domain::lattice({side, 0, 0}, {0.25 * side, side, 0}, {0, 0, side});
    for (std::size_t k = 0; k < scene.size(); k += 3) scene.y[k] += 2.0 * side;
  }
};

TEST(DevicePeriodicLimits, OfPairsAndMemory) {
  const FilledCell cell;
  const HostRun run{.domain = cell.domain, .shifts = Shifts::stored};
  const HostAnswer free = list_on_host(view_of(cell.scene), 0.0, run);
  ASSERT_GT(free.count, 1000U);
  HostRun bounded = run;
  bounded.max_pairs = free.count;
  EXPECT_EQ(list_on_host(view_of(cell.scene), 0.0, bounded).pairs, free.pairs);
  bounded.max_pairs = free.count - 1;
  expect_error(ErrorCode::limit_exceeded, {"there are more than"},
               [&] { static_cast<void>(list_on_host(view_of(cell.scene), 0.0, bounded)); });
  bounded = run;
  bounded.max_bytes = free.peak_bytes;
  EXPECT_EQ(list_on_host(view_of(cell.scene), 0.0, bounded).shifts, free.shifts);
  for (std::uint64_t bound = 0; bound < free.peak_bytes; bound += free.peak_bytes / 20) {
    bounded.max_bytes = bound;
    expect_error(ErrorCode::limit_exceeded, {"bytes are needed"},
                 [&] { static_cast<void>(list_on_host(view_of(cell.scene), 0.0, bounded)); });
  }
}

}  // namespace
}  // namespace abut::testing
