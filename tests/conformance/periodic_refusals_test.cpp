// What is refused in periodic domains, and what looks like it and is not: every algorithm alike.

#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr Algorithm periodic_algorithms[] = {Algorithm::direct_check, Algorithm::rows};

PairCount count(const ElementView& elements, const Domain& domain, const Options& options) {
  return count_contact_pairs(elements, domain, options).contact_pairs;
}

/// Vectors of which one leans over 2^40 times the other: shifts of most images exceed 32 bits.
Domain leaning() {
  return Domain::lattice({1.0, 0.0}, {0x1p40 + 0.5, 0.875});
}

/// Heights of the cell are within reach, but not what lies in them, up to a radius of 0.5; from
/// there on images do that can be told; and from sqrt(0.25 + 0.875^2) / 2 on others.
TEST(FarShifts, AreRefusedOnlyWherePairsHaveThem) {
  for (const Algorithm algorithm : periodic_algorithms) {
    const Options options{.algorithm = algorithm};
    const auto pairs_of = [&](double radius) {
      return count(view_of(scene_of(2, {{0.25, 0.5, 0, radius}})), leaning(), options);
    };
    EXPECT_EQ(pairs_of(0.46875), 0U) << name_of(algorithm);
    EXPECT_EQ(pairs_of(0.5), 1U) << name_of(algorithm);
    EXPECT_EQ(pairs_of(0.50375), 1U) << name_of(algorithm);
    expect_error(ErrorCode::invalid_input,
                 {"elements 0 and 0 pair across more than 2147483647 lattice vectors"},
                 [&] { static_cast<void>(pairs_of(0.504)); });
  }
}

/// Where reaches are long images are decided one after another.
TEST(FarShifts, AreRefusedOnlyWherePairsOfLongReachHaveThem) {
  const Domain domain = Domain::lattice({1.0, 0.0}, {0x1p40 + 0.5, 400.0});
  for (const Algorithm algorithm : periodic_algorithms) {
    const Options options{.algorithm = algorithm};
    EXPECT_EQ(count(view_of(scene_of(2, {{0.25, 0.5, 0, 199.0}})), domain, options), 398U);
    expect_error(ErrorCode::invalid_input, {"pair across more than 2147483647"}, [&] {
      static_cast<void>(count(view_of(scene_of(2, {{0.25, 0.5, 0, 200.5}})), domain, options));
    });
  }
}

/// Found by the fuzzer: images of boxes whose shifts cannot be told, within the windows of `rows`.
TEST(FarShifts, OfBoxesAreRefusedOnlyWherePairsHaveThem) {
  const std::vector<double> xmin{-26, 3, 15, -20}, ymin{32, -4.25, -4.5, 14};
  const std::vector<double> xmax{-17, 4, 16, 23}, ymax{68, 1, -1.5, 19};
  const Domain flat = Domain::lattice({6, 11}, {-4.2519355243333286e+17, 14});
  const Domain steep =
      Domain::lattice({9.0, 0.0, 0.0}, {58982400.0, 3.0, 0.0}, {14745600.0, 608256.0, 3.0});
  const std::vector<double> ends[6] = {{9}, {-23}, {1}, {11}, {-12}, {2}};
  std::vector<PairCount> of_flat, of_steep;
  for (const Algorithm algorithm : periodic_algorithms) {
    Options options{.algorithm = algorithm};
    of_flat.push_back(count(rectangles(xmin, ymin, xmax, ymax), flat, options));
    options.margin = 16.0;
    of_steep.push_back(count(boxes(ends[0], ends[1], ends[2], ends[3], ends[4], ends[5]), steep,
                             {.algorithm = algorithm}));
  }
  EXPECT_EQ(of_flat[0], of_flat[1]);
  EXPECT_EQ(of_steep[0], of_steep[1]);
}

/// An element at the largest double beside a lattice nearly as large: moved into the cell it lies
/// beyond all doubles.
TEST(LargestNumbers, MayLeaveTheRangeWhereTheyAreMovedIntoTheCell) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Domain domain = Domain::lattice({-0x1p1017, 0x1p1020}, {0.0, 1.0}, Axes::x);
  const Scene scene = scene_of(2, {{largest, 0x1p1022, 0, 0x1p1010},
                                   {largest, 0x1p1021, 0, 0x1p1019},
                                   {largest - 0x1p1017, 0x1p1022, 0, 0x1p1018}});
  std::vector<PairCount> found;
  for (const Algorithm algorithm : periodic_algorithms) {
    found.push_back(count(view_of(scene), domain, {.algorithm = algorithm}));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_GT(found[0], 2U);
}

/// A vector as long as the largest double, beside short ones oblique to each other.
TEST(LargestNumbers, MayBeLengthsOfVectors) {
  const Domain domain = Domain::lattice({81 * 0x1p990, 0, 0}, {9 * 0x1p990, 16 * 0x1p990, 0},
                                        {0, 0, std::numeric_limits<double>::max()});
  const std::vector<double> zero{0, 40 * 0x1p990}, end{20 * 0x1p990, 42 * 0x1p990};
  std::vector<PairCount> found;
  for (const Algorithm algorithm : periodic_algorithms) {
    found.push_back(
        count(boxes(zero, zero, zero, end, end, end), domain, {.algorithm = algorithm}));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_GT(found[0], 0U);
}

/// Numbers cannot hold both a cell and what lies far out, also on an open axis.
TEST(SmallCells, WithNumbersFarAboveAreRefusedByAllAlike) {
  const auto pairs_of = [](int side, int stray, Algorithm algorithm) {
    const double s = std::ldexp(1.0, side);
    const Scene scene = scene_of(2, {{0.125 * s, 0, 0, 0.125 * s},
                                     {-0.125 * s, 0, 0, 0.125 * s},
                                     {0, std::ldexp(1.0, stray), 0, 0.25 * s}});
    return count(view_of(scene), Domain::periodic({s, unbounded}), {.algorithm = algorithm});
  };
  for (const Algorithm algorithm : periodic_algorithms) {
    for (const auto& [side, stray] : {std::pair(-801, 720), {-1060, 720}, {-800, 1023}}) {
      EXPECT_EQ(pairs_of(side, stray, algorithm), 1U) << name_of(algorithm) << ", 2^" << side;
    }
    expect_error(ErrorCode::invalid_input, {"shorter than 2^-800", "2^720"},
                 [&] { static_cast<void>(pairs_of(-801, 721, algorithm)); });
  }
}

/// The one limit of how lengths may differ, whatever is asked and of whatever elements.
TEST(UnequalVectors, AreRefusedByAllAlike) {
  const auto domain = [](int ratio) {
    return Domain::periodic({0x1p-200, std::ldexp(0.75, ratio - 200)});
  };
  const std::vector<Scene> scenes{
      scene_of(2, {{0x1p-201, 0.0, 0, 0x1p-203}, {-0x1p-203, 0.0, 0, 0x1p-202}}), scene_of(2, {})};
  for (const Scene& scene : scenes) {
    for (const Algorithm algorithm : periodic_algorithms) {
      const Options options{.algorithm = algorithm};
      Detector detector(options);
      detector.set_skin(Skin::fixed(0x1p-204));
      const std::vector<std::function<PairCount(const Domain&)>> faces{
          [&](const Domain& d) { return count(view_of(scene), d, options); },
          [&](const Domain& d) { return find_contact_pairs(view_of(scene), d, options).size(); },
          [&](const Domain& d) { return detector.find_contact_pairs(view_of(scene), d).size(); }};
      for (const auto& face : faces) {
        EXPECT_EQ(face(domain(450)), scene.size() == 0 ? 0U : 1U);
        expect_error(ErrorCode::invalid_input, {"shorter than 2^-450 of the longest"},
                     [&] { static_cast<void>(face(domain(451))); });
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
