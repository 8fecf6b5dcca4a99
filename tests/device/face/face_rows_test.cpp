// Neighbor lists and gaps through the face of devices: those of the processor, byte for byte, in
// open and periodic domains and of two sets; what a call leaves of the lists before it.

#include "device/face/face_detection.hpp"
#include "device/scene_in_two.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace abut::testing {
namespace {

using scenes::Scene;

/// 0.0 and -0.0 are not the same.
void expect_same_bits(std::span<const double> expected, std::span<const double> found) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  EXPECT_TRUE(std::ranges::equal(expected, found, {}, bits, bits));
}

void expect_same(const PairList& expected, const PairList& found) {
  EXPECT_TRUE(std::ranges::equal(expected.pairs(), found.pairs()));
  EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
  expect_same_bits(expected.gaps(), found.gaps());
}

void expect_same(const NeighborList& expected, const NeighborList& found) {
  EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets()));
  EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors()));
  EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts()));
  expect_same_bits(expected.gaps(), found.gaps());
  EXPECT_EQ(expected.statistics().contact_pairs, found.statistics().contact_pairs);
}

/// Both kinds, twice by the same detector, in open space and in a cell about a part of the scene.
class FaceRows : public ::testing::TestWithParam<scenes::SceneInfo> {};

INSTANTIATE_TEST_SUITE_P(Scenes, FaceRows,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(FaceRows, AreThoseOfTheProcessor) {
  const bool is_crowded = GetParam().name == "coincident" || GetParam().name == "two_far_clusters";
  const std::size_t count = std::min<std::size_t>(elements_of_a_scene(), is_crowded ? 300 : ~0U);
  const Scene scene = GetParam().make(count, 3);
  const device::ElementCopy copy(view_of(scene));
  const double side = *std::max_element(scene.x.begin(), scene.x.end()) + 4.0 * scene.radius[0];
  const Domain cell = scene.dimensions == 2 ? Domain::periodic({side, unbounded})
                                            : Domain::periodic({side, unbounded, unbounded});
  for (const Domain& domain : {Domain::open(), cell}) {
    const Options options{.algorithm = Algorithm::rows,
                          .shifts = Shifts::stored,
                          .quantities = Quantity::gap,
                          .margin = 0.2 * scene.radius[0]};
    device::Detector pair_detector(options);
    expect_same(find_contact_pairs(view_of(scene), domain, options),
                pair_detector.find_contact_pairs(copy.elements(), domain).to_host());
    for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
      const NeighborList expected = build_neighbor_list(view_of(scene), domain, kind, options);
      device::Detector detector(options);
      for (int call = 0; call < 2; ++call) {
        const auto& found = detector.build_neighbor_list(copy.elements(), domain, kind);
        EXPECT_EQ(found.size(), scene.size());
        EXPECT_EQ(found.neighbor_count(), expected.neighbors().size());
        expect_same(expected, found.to_host());
      }
    }
  }
}

TEST(FaceRows, OfBoxes) {
  for (const char* const name : {"log_uniform", "gas_2d"}) {
    const scenes::BoxScene boxes =
        scenes::boxes_in(scenes::scene_named(name).make(elements_of_a_scene(), 3), 4);
    const device::ElementCopy copy(view_of(boxes));
    const double side = *std::max_element(boxes.upper[0].begin(), boxes.upper[0].end());
    const Domain cell = boxes.dimensions == 2 ? Domain::periodic({side, unbounded})
                                              : Domain::periodic({side, unbounded, unbounded});
    for (const Domain& domain : {Domain::open(), cell}) {
      const Options options{
          .shifts = Shifts::stored, .quantities = Quantity::gap, .margin = 0.01 * side};
      device::Detector detector(options);
      const PairList expected = find_contact_pairs(view_of(boxes), domain, options);
      EXPECT_GT(expected.size(), 100U);
      expect_same(expected, detector.find_contact_pairs(copy.elements(), domain).to_host());
      const auto kind = NeighborListKind::full;
      expect_same(build_neighbor_list(view_of(boxes), domain, kind, options),
                  detector.build_neighbor_list(copy.elements(), domain, kind).to_host());
      EXPECT_EQ(detector.count_contact_pairs(copy.elements(), domain).contact_pairs,
                expected.size());
    }
  }
}

TEST(FaceRowsOfTwoSets, HaveARowForEachOfTheFirst) {
  const SceneInTwo sets(scenes::scene_named("dense").make(400, 1));
  const Domain cell = Domain::periodic({8.0, 8.0, 8.0});
  const device::ElementCopy first(view_of(sets.first));
  const device::ElementCopy second(view_of(sets.second));
  const Options options{.quantities = Quantity::gap, .margin = 0.1};
  device::Detector detector(options);
  for (const Domain& domain : {Domain::open(), cell}) {
    const auto& found = detector.build_neighbor_list(first.elements(), second.elements(), domain);
    EXPECT_EQ(found.size(), sets.first.size());
    EXPECT_NE(found.gaps(), nullptr);
    EXPECT_EQ(found.shifts(), nullptr);
    expect_same(build_neighbor_list(view_of(sets.first), view_of(sets.second), domain, options),
                found.to_host());
  }
}

TEST(FaceLists, LastUntilTheNextCall) {
  const Scene scene = scenes::scene_named("dense").make(400, 1);
  const device::ElementCopy copy(view_of(scene));
  device::Detector detector;
  const device::PairList& pairs = detector.find_contact_pairs(copy.elements());
  EXPECT_GT(pairs.size(), 0U);
  const device::NeighborList& rows =
      detector.build_neighbor_list(copy.elements(), Domain::open(), NeighborListKind::full);
  EXPECT_TRUE(pairs.empty());
  EXPECT_EQ(pairs.data(), nullptr);
  EXPECT_EQ(rows.size(), scene.size());
  EXPECT_EQ(detector.count_contact_pairs(copy.elements()).contact_pairs * 2,
            build_neighbor_list(view_of(scene), Domain::open(), NeighborListKind::full)
                .neighbors()
                .size());
  EXPECT_EQ(rows.size(), 0U);
  EXPECT_EQ(rows.offsets(), nullptr);
  EXPECT_EQ(rows.to_host().size(), 0U);
  rows.wait();
}

TEST(FaceLists, AreEmptyAfterAnError) {
  Scene scene = scenes::scene_named("dense").make(100, 1);
  const device::ElementCopy copy(view_of(scene));
  device::Detector detector;
  const device::NeighborList& rows =
      detector.build_neighbor_list(copy.elements(), Domain::open(), NeighborListKind::half);
  EXPECT_GT(rows.neighbor_count(), 0U);
  scene.x[7] = std::numeric_limits<double>::infinity();
  const device::ElementCopy bad(view_of(scene));
  expect_error(ErrorCode::invalid_input, {"element 7"}, [&] {
    detector.build_neighbor_list(bad.elements(), Domain::open(), NeighborListKind::half);
  });
  EXPECT_EQ(rows.neighbor_count(), 0U);
  EXPECT_EQ(rows.to_host().size(), 0U);
}

TEST(FaceLists, OfNoElements) {
  const Scene none = scene_of(3, {});
  const device::ElementCopy copy(view_of(none));
  device::Detector detector;
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    expect_same(build_neighbor_list(view_of(none), Domain::open(), kind),
                detector.build_neighbor_list(copy.elements(), Domain::open(), kind).to_host());
  }
}

}  // namespace
}  // namespace abut::testing
