// Domains: what they hold and what they refuse.

#include "support/error_expectations.hpp"

#include <abut/domain.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

namespace abut::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using Vector = Domain::Vector;

TEST(Domain, OpenFitsAnyDimensions) {
  EXPECT_FALSE(Domain::open().is_periodic());
  EXPECT_EQ(Domain::open().dimensions(), 0);
  EXPECT_EQ(Domain::open().periodic_axes(), Axes::none);
}

TEST(Domain, PeriodicAlongTheAxes) {
  const Domain block = Domain::periodic({2.0, 3.0, 4.0});
  EXPECT_EQ(block.dimensions(), 3);
  EXPECT_EQ(block.periodic_axes(), Axes::xyz);
  EXPECT_EQ(block.vector(1), (Vector{0.0, 3.0, 0.0}));
  EXPECT_EQ(block, Domain::periodic(std::array{2.0, 3.0, 4.0}));
  EXPECT_EQ(block, Domain::lattice({2, 0, 0}, {0, 3, 0}, {0, 0, 4}));

  const Domain slit = Domain::periodic({2.0, unbounded, 4.0});
  EXPECT_EQ(slit.periodic_axes(), Axes::xz);
  EXPECT_FALSE(slit.is_periodic(1));
  EXPECT_EQ(slit.vector(1), Vector{});

  const Domain plane = Domain::periodic({2, 3});
  EXPECT_EQ(plane.dimensions(), 2);
  EXPECT_EQ(plane.periodic_axes(), Axes::xy);
  EXPECT_FALSE(Domain::periodic({unbounded, unbounded}).is_periodic());
}

TEST(Domain, LatticesIgnoreVectorsOfOpenAxes) {
  const Domain layer = Domain::lattice({1, 0, 0}, {0.5, 1, 0}, {0, 0, nan}, Axes::xy);
  EXPECT_EQ(layer.periodic_axes(), Axes::xy);
  EXPECT_EQ(layer.vector(2), Vector{});
  EXPECT_EQ(Domain::lattice({1, 0}, {0, 0}, Axes::x).periodic_axes(), Axes::x);
  EXPECT_FALSE(Domain::lattice({0, 0}, {0, 0}, Axes::none).is_periodic());
  // Left-handed, and neither along an axis.
  EXPECT_TRUE(Domain::lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0}).is_periodic());
}

TEST(Domain, ShearIsTakenAsGiven) {
  const Domain sheared = Domain::lees_edwards({2.0, 3.0, 4.0}, 7.25);
  EXPECT_EQ(sheared.vector(1), (Vector{7.25, 3.0, 0.0}));
  EXPECT_EQ(Domain::lees_edwards({2.0, 3.0}, -1.0), Domain::lattice({2, 0}, {-1, 3}));
  EXPECT_EQ(Domain::lees_edwards({2.0, 3.0, unbounded}, 0.0),
            Domain::periodic({2.0, 3.0, unbounded}));
}

TEST(Domain, BadLengths) {
  const auto bad = [](double length, std::string_view name, std::string_view value,
                      const std::function<void(double)>& make) {
    expect_error(ErrorCode::invalid_input, {name, value, "must be positive; an infinite one"},
                 [&] { make(length); });
  };
  bad(0.0, "lx", "0", [](double l) { return Domain::periodic({l, 1.0, 1.0}); });
  bad(-0.0, "ly", "-0", [](double l) { return Domain::periodic({1.0, l}); });
  bad(-2.5, "lz", "-2.5", [](double l) { return Domain::periodic({1.0, 1.0, l}); });
  bad(nan, "lx", "nan", [](double l) { return Domain::periodic({l, 1.0}); });
  bad(-unbounded, "lx", "-inf", [](double l) { return Domain::periodic({l, 1.0}); });
  bad(0.0, "ly", "0", [](double l) { return Domain::lees_edwards({1.0, l}, 0.5); });
}

TEST(Domain, BadShear) {
  expect_error(ErrorCode::invalid_input, {"shift", "nan"}, [] {
    return Domain::lees_edwards({1.0, 1.0}, nan);
  });
  expect_error(ErrorCode::invalid_input, {"shift", "inf"}, [] {
    return Domain::lees_edwards({1.0, 1.0, 1.0}, unbounded);
  });
  expect_error(ErrorCode::invalid_input, {"ly", "Lees-Edwards"}, [] {
    return Domain::lees_edwards({1.0, unbounded}, 0.5);
  });
}

TEST(Domain, BadLattices) {
  expect_error(ErrorCode::invalid_input, {"vector b", "y = nan"}, [] {
    return Domain::lattice({1, 0}, {0, nan});
  });
  expect_error(ErrorCode::invalid_input, {"vector c", "z = inf"}, [] {
    return Domain::lattice({1, 0, 0}, {0, 1, 0}, {0, 0, unbounded});
  });
  expect_error(ErrorCode::invalid_input, {"dependent"}, [] {
    return Domain::lattice({1, 2}, {2, 4});
  });
  expect_error(ErrorCode::invalid_input, {"zero"}, [] {
    return Domain::lattice({1, 0}, {0, 0}, Axes::y);
  });
  // Doubles cannot tell this determinant from 0; in real arithmetic it is 0, and then not.
  expect_error(ErrorCode::invalid_input, {"dependent"}, [] {
    return Domain::lattice({0.1, 0.3, 0}, {0.2, 0.6, 0}, {0, 0, 1});
  });
  EXPECT_TRUE(Domain::lattice({0.1, 0.3}, {0.2, std::nextafter(0.6, 1.0)}).is_periodic());
  expect_error(ErrorCode::wrong_usage, {"2 dimensions", "axes"}, [] {
    return Domain::lattice({1, 0}, {0, 1}, Axes::xz);
  });
}

}  // namespace
}  // namespace abut::testing
