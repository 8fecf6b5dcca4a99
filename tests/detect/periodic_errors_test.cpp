// What periodic domains refuse: algorithms, dimensions, elements too far out, limits.

#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

TEST(PeriodicErrors, OtherAlgorithmsRefuse) {
  const Scene scene = scene_of(3, {{0, 0, 0, 1}});
  const Domain domain = Domain::periodic({4.0, 4.0, 4.0});
  for (const AlgorithmInfo& row : algorithms()) {
    if (row.periodic) continue;
    expect_error(ErrorCode::wrong_usage, {row.name, "periodic", "direct_check", "auto"}, [&] {
      static_cast<void>(find_contact_pairs(view_of(scene), domain, {.algorithm = row.algorithm}));
    });
  }
  const Statistics statistics = count_contact_pairs(view_of(scene), domain);
  EXPECT_TRUE(info(statistics.algorithm).periodic);
}

TEST(PeriodicErrors, DimensionsMustAgree) {
  const Scene discs = scene_of(2, {{0, 0, 0, 1}});
  const Domain block = Domain::periodic({4.0, 4.0, 4.0});
  expect_error(ErrorCode::wrong_usage, {"3 dimensions", "2 numbers"},
               [&] { static_cast<void>(count_contact_pairs(view_of(discs), block)); });
  expect_error(ErrorCode::wrong_usage, {"3 dimensions"}, [&] {
    static_cast<void>(gap(view_of(discs), block, {0, 0}, {1, 0, 0}));
  });
}

TEST(PeriodicErrors, GapsOfImagesThatAreNotThere) {
  const Scene discs = scene_of(2, {{0, 0, 0, 1}, {3, 0, 0, 1}});
  const Domain strip = Domain::periodic({4.0, unbounded});
  EXPECT_EQ(gap(view_of(discs), strip, {0, 1}, {-1, 0, 0}), -1.0);
  EXPECT_EQ(gap(view_of(discs), strip, {0, 1}, {}), gap(view_of(discs), {0, 1}));
  expect_error(ErrorCode::wrong_usage, {"shift y", "not periodic"}, [&] {
    static_cast<void>(gap(view_of(discs), strip, {0, 1}, {0, 1, 0}));
  });
  expect_error(ErrorCode::wrong_usage, {"shift x", "not periodic"}, [&] {
    static_cast<void>(gap(view_of(discs), Domain::open(), {0, 1}, {1, 0, 0}));
  });
  expect_error(ErrorCode::wrong_usage, {"element 2"}, [&] {
    static_cast<void>(gap(view_of(discs), strip, {0, 2}, {}));
  });
}

/// Each lies few enough cells outside, but not the one from the other; whether shifts are stored or
/// not.
TEST(PeriodicErrors, ShiftsBeyond32BitsBetweenTwoElementsAreAnError) {
  const std::vector<double> x{2e9 + 0.25, -2e9 + 0.25};
  const std::vector<double> y{0.5, 0.5};
  const ElementView elements = discs(x, y, 0.125);
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
      Options options{.shifts = shifts};
      options.algorithm = algorithm;
      expect_error(ErrorCode::invalid_input, {"element", "2147483647"}, [&] {
        static_cast<void>(find_contact_pairs(elements, Domain::periodic({1.0, 1.0}), options));
      });
    }
  }
}

/// Along a vector 2^-92 as long as the other no number tells where an element lies, as soon as it
/// is away from the origin.
TEST(PeriodicErrors, VectorsOfVeryUnequalLengths) {
  constexpr double length = 0x1p-92;
  const std::vector<double> x{0.25, 0.5}, y{-0.25, -0.5}, z{0.0, 0.0};
  const Options rows{.algorithm = Algorithm::rows};
  expect_error(ErrorCode::invalid_input, {"differ so much in length"}, [&] {
    static_cast<void>(
        count_contact_pairs(discs(x, y, length), Domain::lattice({1, -1}, {length, length}), rows));
  });
  expect_error(ErrorCode::invalid_input, {"differ so much in length"}, [&] {
    static_cast<void>(
        count_contact_pairs(spheres(x, y, z, length),
                            Domain::lattice({1, -1, 0}, {length, length, 0}, {0, 0, 1}), rows));
  });
}

/// The two algorithms refuse by one rule, in one sentence: at the border of what they carry, and
/// where all elements are far out together.
TEST(PeriodicErrors, FarElementsAreRefusedByOneRule) {
  const Domain strip = Domain::lattice({1.0, 0.0}, {0.25, 1.0}, Axes::x);
  const auto outcome = [&](const Scene& scene, Algorithm algorithm) {
    try {
      const Options options{.algorithm = algorithm};
      return std::to_string(find_contact_pairs(view_of(scene), strip, options).size());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_input);
      return std::string(error.what());
    }
  };
  const std::string far =
      "; it lies more than 2147483647 cells outside of the periodic cell: move "
      "it into the cell, or correct the lattice";
  const struct {
    Scene scene;
    std::string expected;
  } cases[] = {
      {scene_of(2, {{2147483647.5, 0, 0, 0.125}, {2147483647.25, 0, 0, 0.125}}), "1"},
      {scene_of(2, {{0, 0, 0, 0.125}, {2147483648.0, 0, 0, 0.125}}),
       "element 1 has x = 2147483648" + far},
      {scene_of(2, {{2147483648.5, 0, 0, 0.125}, {2147483648.25, 0, 0, 0.125}}),
       "element 0 has x = 2147483648.5" + far},
      {scene_of(2, {{-2147483647.0, 0, 0, 0.125}, {-2147483646.75, 0, 0, 0.125}}), "1"},
      {scene_of(2, {{1.0, 0, 0, 0.125}, {-2147483647.5, 0, 0, 0.125}}),
       "element 1 has x = -2147483647.5" + far},
      {scene_of(2, {{-1e300, 0, 0, 0.125}}), "element 0 has x = -1e+300" + far},
      {scene_of(2, {{-2e9, 0, 0, 0.125}, {2e9, 0, 0, 0.125}}),
       "elements 0 and 1 pair across more than 2147483647 lattice vectors; move them into one "
       "cell"},
      {scene_of(2, {{0, 0, 0, 0.5}, {0, 9, 0, 1e10}}),
       "element 1 has radius = 1e+10; it reaches over more than 2147483647 cells: make the "
       "lattice vectors longer, or radii and margin smaller"},
  };
  for (const auto& [scene, expected] : cases) {
    EXPECT_EQ(outcome(scene, Algorithm::direct_check), expected);
    EXPECT_EQ(outcome(scene, Algorithm::rows), expected);
  }
}

/// The cell of boxes leads against the axes of space: on that side one lies a cell farther out.
TEST(PeriodicErrors, FarBoxesAreRefusedByOneRule) {
  const Domain domain = Domain::periodic({1.0, unbounded});
  const auto refusal_of = [&](double x, Algorithm algorithm) -> std::string {
    const std::vector<double> lower{0.0, x};
    const std::vector<double> y{0.0, 0.0};
    try {
      static_cast<void>(find_contact_pairs(rectangles(lower, y, lower, y), domain,
                                           {.algorithm = algorithm, .threads = 1}));
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  for (const Algorithm algorithm : {Algorithm::rows, Algorithm::direct_check}) {
    EXPECT_EQ(refusal_of(2147483646.5, algorithm), "none");
    EXPECT_NE(
        refusal_of(2147483647.5, algorithm).find("element 1 has xmin = 2147483647.5; it lies"),
        std::string::npos);
    EXPECT_EQ(refusal_of(-2147483647.5, algorithm), "none");
    EXPECT_NE(refusal_of(-2147483648.5, algorithm).find("element 1 has xmin = "),
              std::string::npos);
  }
}

TEST(PeriodicErrors, ShiftsBeyond32BitsAreAnError) {
  const Domain strip = Domain::periodic({1.0, unbounded});
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    const Options options{.algorithm = algorithm, .shifts = Shifts::stored};
    const auto count = [&](double x) {
      const Scene scene = scene_of(2, {{0, 0, 0, 0.125}, {x, 0, 0, 0.125}});
      const PairList list = find_contact_pairs(view_of(scene), strip, options);
      return list.shifts().size() == 1 ? list.shifts()[0].x : 0;
    };
    EXPECT_EQ(count(2147483647.0), -2147483647);
    EXPECT_EQ(count(-2147483647.0), 2147483647);
    for (const double x : {2147483648.0, -2147483648.0, 1e15, 1e300, -1.7e308}) {
      expect_error(ErrorCode::invalid_input, {"element", "2147483647"}, [&] { count(x); });
    }
  }
  const Scene huge = scene_of(2, {{0, 0, 0, 1e300}});
  expect_error(ErrorCode::invalid_input, {"element 0", "2147483647"},
               [&] { static_cast<void>(count_contact_pairs(view_of(huge), strip)); });
}

TEST(PeriodicErrors, LimitsHoldForImages) {
  const Scene huge = scene_of(2, {{0, 0, 0, 1e4}});
  const Domain square = Domain::periodic({1.0, 1.0});
  expect_error(ErrorCode::limit_exceeded, {"1000"}, [&] {
    static_cast<void>(find_contact_pairs(view_of(huge), square, {.max_pairs = 1000}));
  });
  expect_error(ErrorCode::limit_exceeded, {"bytes"}, [&] {
    static_cast<void>(find_contact_pairs(view_of(huge), square,
                                         {.shifts = Shifts::stored, .max_bytes = 1 << 20}));
  });
}

}  // namespace
}  // namespace abut::testing
