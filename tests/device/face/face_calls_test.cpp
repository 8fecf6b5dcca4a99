// The calls of the face that scenes do not make: two sets, shifts, and detectors that move.

#include "device/face/face_detection.hpp"
#include "scenes/scene.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::testing {
namespace {

using scenes::Scene;

Scene dense(std::size_t count, std::uint64_t seed) {
  return scenes::scene_named("dense").make(count, seed);
}

void expect_same(const PairList& expected, const PairList& found) {
  EXPECT_TRUE(std::ranges::equal(expected, found));
  EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
}

TEST(FaceCalls, TwoSetsAndShifts) {
  const Scene first = dense(300, 1);
  const Scene second = dense(200, 2);
  const device::ElementCopy copy(view_of(first));
  const device::ElementCopy others(view_of(second));
  const Options options{.algorithm = Algorithm::rows, .shifts = Shifts::stored};
  device::Detector detector(options);
  for (const Domain& domain : {Domain::open(), Domain::periodic({9.0, 9.0, 9.0})}) {
    const PairList expected = find_contact_pairs(view_of(first), view_of(second), domain, options);
    ASSERT_GT(expected.size(), 100U);
    expect_same(expected,
                detector.find_contact_pairs(copy.elements(), others.elements(), domain).to_host());
    EXPECT_EQ(
        detector.count_contact_pairs(copy.elements(), others.elements(), domain).contact_pairs,
        expected.size());
    expect_same(find_contact_pairs(view_of(first), domain, options),
                detector.find_contact_pairs(copy.elements(), domain).to_host());
  }
}

/// A column of the device whose stride is 0 has one number for all elements.
TEST(FaceCalls, StrideZeroRepeatsOneNumber) {
  const Scene scene = scenes::scene_named("gas_2d").make(300, 5);
  const device::ElementCopy copy(view_of(scene));
  const auto on_device = [&](int axis, std::size_t k, std::ptrdiff_t stride) {
    const auto* const numbers = reinterpret_cast<const double*>(copy.elements().center(axis).first);
    return Column<double>{numbers + k, scene.size(), stride};
  };
  const auto* const radii = reinterpret_cast<const double*>(copy.elements().radii().first);
  Scene repeated = scene;
  repeated.y.assign(scene.size(), scene.y[7]);
  repeated.radius.assign(scene.size(), scene.radius[3]);
  const ElementView elements = discs(on_device(0, 0, sizeof(double)), on_device(1, 7, 0),
                                     Column<double>{radii + 3, scene.size(), 0});
  device::Detector detector({.shifts = Shifts::stored});
  for (const Domain& domain : {Domain::open(), Domain::periodic({9.0, 9.0})}) {
    const PairList expected =
        find_contact_pairs(view_of(repeated), domain, {.shifts = Shifts::stored});
    EXPECT_GT(expected.size(), 100U);
    expect_same(expected, detector.find_contact_pairs(elements, domain).to_host());
    EXPECT_EQ(detector.count_contact_pairs(elements, domain).contact_pairs, expected.size());
  }
}

/// A list is that of its detector, wherever that is moved to; so are elements that were copied.
TEST(FaceCalls, MovedDetectorsKeepTheirLists) {
  const Scene scene = dense(300, 3);
  const PairList expected = find_contact_pairs(view_of(scene), Domain::open());
  device::ElementCopy copy(view_of(scene));
  device::Detector detector;
  const device::PairList& list = detector.find_contact_pairs(copy.elements());
  device::Detector moved(std::move(detector));
  expect_same(expected, list.to_host());
  device::Detector assigned;
  assigned = std::move(moved);
  expect_same(expected, list.to_host());

  device::ElementCopy moved_copy(std::move(copy));
  device::ElementCopy assigned_copy(view_of(dense(5, 4)));
  assigned_copy = std::move(moved_copy);
  expect_same(expected, assigned.find_contact_pairs(assigned_copy.elements()).to_host());
}

}  // namespace
}  // namespace abut::testing
