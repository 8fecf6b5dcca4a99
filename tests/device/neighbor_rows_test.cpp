// Neighbor lists through the stages of the device engine on the host: offsets, neighbors and shifts
// of the library, byte for byte.

#include "device/host/host_detection.hpp"
#include "device/scene_in_two.hpp"
#include "support/error_expectations.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <abut/device.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace abut::testing {
namespace {

using device::ListForm;
using scenes::Scene;

std::size_t expect_rows(const NeighborList& expected, const ElementView& elements, double margin,
                        const HostRun& with) {
  for (const HostRun& run : in_all_orders(with)) {
    const HostAnswer found = list_on_host(elements, margin, run);
    EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets));
    EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors))
        << found.neighbors.size() << " neighbors for " << expected.neighbors().size();
    EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts));
    EXPECT_EQ(found.count, expected.statistics().contact_pairs);
    EXPECT_TRUE(found.pairs.empty());
    EXPECT_EQ(found.held_bytes, 0U);
  }
  return expected.neighbors().size();
}

/// Half and full lists with and without shifts; returns how many neighbors a full one has.
std::size_t expect_rows(const ElementView& elements, const Domain& domain, double margin = 0.0) {
  std::size_t neighbors = 0;
  for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
    for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
      const bool is_full = kind == NeighborListKind::full;
      SCOPED_TRACE(::testing::Message() << (is_full ? "full" : "half")
                                        << (shifts == Shifts::stored ? ", with shifts" : ""));
      const NeighborList expected =
          build_neighbor_list(elements, domain, kind,
                              {.algorithm = Algorithm::rows, .shifts = shifts, .margin = margin});
      neighbors = expect_rows(expected, elements, margin,
                              {.domain = domain,
                               .shifts = shifts,
                               .form = is_full ? ListForm::full_rows : ListForm::half_rows});
    }
  }
  return neighbors;
}

std::size_t expect_rows(const ElementView& first, const ElementView& second, const Domain& domain,
                        double margin) {
  const NeighborList expected = build_neighbor_list(
      first, second, domain,
      {.algorithm = Algorithm::rows, .shifts = Shifts::stored, .margin = margin});
  return expect_rows(
      expected, first, margin,
      {.domain = domain, .shifts = Shifts::stored, .form = ListForm::half_rows, .second = &second});
}

class DeviceNeighborRows : public ::testing::TestWithParam<scenes::SceneInfo> {};

INSTANTIATE_TEST_SUITE_P(Scenes, DeviceNeighborRows,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(DeviceNeighborRows, InOpenSpace) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{150}}) {
    const Scene scene = GetParam().make(count, 3);
    expect_rows(view_of(scene), Domain::open());
    if (count > 0) expect_rows(view_of(scene), Domain::open(), 0.3 * scene.radius[0]);
  }
}

TEST(DeviceNeighborRowsInCells, OfOneSetAndOfTwo) {
  std::size_t neighbors = 0;
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) {
      for (const int dimensions : {2, 3}) {
        SCOPED_TRACE(::testing::Message()
                     << name_of(kind) << ", " << name_of(extreme) << ", " << dimensions << 'D');
        const std::size_t count = kind == DomainKind::small_cell ? 12 : 60;
        const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, 11);
        neighbors += expect_rows(view_of(system.scene), system.domain, system.margin);
        const SceneInTwo sets(system.scene);
        neighbors +=
            expect_rows(view_of(sets.first), view_of(sets.second), system.domain, system.margin);
      }
    }
  }
  EXPECT_GT(neighbors, 5000U);
}

/// An element that touches its own images is a neighbor of itself, from both sides.
TEST(DeviceNeighborRowsInCells, OfAnElementWithItself) {
  const Scene scene = scene_of(2, {{0.25, 0.5, 0, 0.5}, {0.75, 0.5, 0, 0.125}});
  EXPECT_EQ(expect_rows(view_of(scene), Domain::periodic({1.0, 1.0})), 8U);
}

/// A limit counts pairs, not neighbors.
TEST(DeviceNeighborRowLimits, OfPairs) {
  const Scene scene = scenes::scene_named("dense").make(300, 1);
  HostRun run{.form = ListForm::full_rows};
  const std::uint64_t pairs = list_on_host(view_of(scene), 0.0, run).count;
  run.max_pairs = pairs;
  EXPECT_EQ(list_on_host(view_of(scene), 0.0, run).neighbors.size(), 2 * pairs);
  run.max_pairs = pairs - 1;
  expect_error(ErrorCode::limit_exceeded, {"there are more than"},
               [&] { static_cast<void>(list_on_host(view_of(scene), 0.0, run)); });
}

/// In a full list each pair counts twice; a half list takes no more than a list of pairs.
TEST(DeviceNeighborRowLimits, MemoryIsWithinThePlan) {
  for (const char* name : {"dense", "graded", "touching_fcc", "coincident", "gas_2d"}) {
    const std::size_t count = name == std::string("coincident") ? 300 : 3000;
    const Scene scene = scenes::scene_named(name).make(count, 5);
    const Domain cell = scene.dimensions == 2 ? Domain::periodic({40.0, 40.0})
                                              : Domain::periodic({15.0, 15.0, 15.0});
    for (const Domain& domain : {Domain::open(), cell}) {
      for (const ListForm form : {ListForm::half_rows, ListForm::full_rows}) {
        for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
          const HostAnswer answer = list_on_host(
              view_of(scene), 0.0,
              {.items_at_a_time = 100, .domain = domain, .shifts = shifts, .form = form});
          const std::uint64_t pairs = answer.neighbors.size() + answer.exact_decisions;
          const device::MemoryPlan plan = device::plan(answer.searched, pairs);
          const std::uint64_t bytes = plan.bytes() + plan.image_bytes + plan.shift_bytes;
          EXPECT_LE(answer.peak_bytes, bytes) << name;
          // The part for items that are counted at a time would hide all else.
          EXPECT_LE(answer.peak_bytes,
                    64 * answer.searched + (shifts == Shifts::stored ? 44 : 16) * pairs + 8192)
              << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
