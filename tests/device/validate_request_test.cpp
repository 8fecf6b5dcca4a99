// What a device does not do yet is refused by name, and told what to take instead.

#include "device/validate_request.hpp"

#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string_view>

namespace abut::testing {
namespace {

using scenes::Scene;

void validate(const Options& options, const ElementView& elements, const Domain& domain) {
  device::validate_request(options, {elements}, domain);
}

void expect_refused(std::initializer_list<std::string_view> words, const Options& options,
                    const Domain& domain = Domain::open()) {
  const Scene scene = scenes::scene_named("dense").make(10, 1);
  expect_error(ErrorCode::wrong_usage, words, [&] { validate(options, view_of(scene), domain); });
}

TEST(DeviceRequests, WhatWorksIsTaken) {
  const Scene scene = scenes::scene_named("dense").make(10, 1);
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::rows}) {
    for (const Order order : {Order::canonical, Order::as_found}) {
      const Options options{.algorithm = algorithm,
                            .order = order,
                            .quantities = Quantity::gap,
                            .margin = 0.5,
                            .max_pairs = 3,
                            .max_bytes = 1};
      EXPECT_NO_THROW(validate(options, view_of(scene), Domain::open()));
    }
  }
}

TEST(DeviceRequests, WhatWaitsIsRefusedByName) {
  expect_refused({"quantities other than gaps", "abut::Detector"},
                 {.quantities = Quantity::gap | Quantity::normal});
  expect_refused({"sorting_array", "rows"}, {.algorithm = Algorithm::sorting_array});
}

TEST(DeviceRequests, OfBoxes) {
  const scenes::BoxScene boxes = scenes::boxes_in(scenes::scene_named("dense").make(10, 1), 1);
  EXPECT_NO_THROW(validate({.margin = 0.5}, view_of(boxes), Domain::periodic({9.0, 9.0, 9.0})));
}

TEST(DeviceRequests, DomainsAreOfTheElements) {
  const Scene scene = scenes::scene_named("dense").make(10, 1);
  const Options options{.shifts = Shifts::stored};
  EXPECT_NO_THROW(validate(options, view_of(scene), Domain::periodic({9.0, 9.0, 9.0})));
  expect_refused({"a domain of 2 dimensions for elements of 3"}, options,
                 Domain::periodic({9.0, 9.0}));
}

TEST(DeviceRequests, TwoSetsAreAlike) {
  const Scene scene = scenes::scene_named("dense").make(10, 1);
  const Scene flat = scenes::scene_named("gas_2d").make(10, 1);
  const ElementView spheres = view_of(scene);
  const ElementView discs = view_of(flat);
  EXPECT_NO_THROW(device::validate_request({}, {spheres, &spheres}, Domain::open()));
  expect_error(ErrorCode::wrong_usage, {"the same number of dimensions"}, [&] {
    device::validate_request({}, {spheres, &discs}, Domain::open());
  });
}

TEST(DeviceRequests, ElementsAreNumberedIn32Bits) {
  const double zero = 0.0;
  const auto elements = [&](std::size_t count) {
    const Column<double> column{&zero, count, 0};
    return spheres(column, column, column, 1.0);
  };
  const ElementView one = elements(1);
  EXPECT_NO_THROW(validate({}, elements(4294967294), Domain::open()));
  expect_error(ErrorCode::limit_exceeded, {"4294967295 elements", "at most 4294967294"},
               [&] { validate({}, elements(4294967295), Domain::open()); });
  EXPECT_NO_THROW(device::validate_request({}, {elements(4294967293), &one}, Domain::open()));
  expect_error(ErrorCode::limit_exceeded, {"two sets of 4294967294 and 1 elements"}, [&] {
    device::validate_request({}, {elements(4294967294), &one}, Domain::open());
  });
}

TEST(DeviceRequests, MarginsAreThoseOfTheLibrary) {
  const Scene scene = scenes::scene_named("dense").make(10, 1);
  for (const double margin :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    expect_error(ErrorCode::invalid_input, {"margin = ", "finite and not negative"},
                 [&] { validate({.margin = margin}, view_of(scene), Domain::open()); });
  }
}

}  // namespace
}  // namespace abut::testing
