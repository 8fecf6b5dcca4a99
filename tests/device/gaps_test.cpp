// Gaps through the stages of the device engine on the host: the bits that the library measures, of
// pairs and of neighbors, of one set and of two.

#include "device/host/host_detection.hpp"
#include "device/scene_in_two.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/device.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace abut::testing {
namespace {

using device::ItemOrder;
using device::ListForm;
using scenes::Scene;

::testing::AssertionResult same_bits(std::span<const double> expected,
                                     std::span<const double> found) {
  if (expected.size() != found.size()) {
    return ::testing::AssertionFailure() << found.size() << " gaps for " << expected.size();
  }
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (std::bit_cast<std::uint64_t>(expected[k]) == std::bit_cast<std::uint64_t>(found[k])) {
      continue;
    }
    return ::testing::AssertionFailure()
           << "gap " << k << " is " << found[k] << " for " << expected[k];
  }
  return ::testing::AssertionSuccess();
}

Options options_of(double margin, Shifts shifts) {
  return {.algorithm = Algorithm::rows,
          .shifts = shifts,
          .quantities = Quantity::gap,
          .margin = margin};
}

/// The same in any order of items; without shifts in a periodic domain none are left.
void expect_gaps(std::span<const double> expected, const ElementView& elements, double margin,
                 const HostRun& with) {
  for (HostRun run : {HostRun{}, HostRun{.order = ItemOrder::shuffled, .workers = 3}}) {
    run.domain = with.domain;
    run.shifts = with.shifts;
    run.form = with.form;
    run.quantities = Quantity::gap;
    run.second = with.second;
    const HostAnswer found = list_on_host(elements, margin, run);
    EXPECT_TRUE(same_bits(expected, found.gaps));
    EXPECT_EQ(found.shifts.empty(), with.shifts == Shifts::none || expected.empty());
  }
}

/// Of pairs and of half and full lists; returns how many there are that touch, and how many not.
struct Signs {
  std::size_t touch = 0;
  std::size_t apart = 0;
};

void expect_gaps(const ElementView& elements, const Domain& domain, double margin, Signs& signs) {
  for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
    SCOPED_TRACE(shifts == Shifts::none ? "without shifts" : "with shifts");
    const Options options = options_of(margin, shifts);
    const PairList pairs = find_contact_pairs(elements, domain, options);
    HostRun run{.domain = domain, .shifts = shifts};
    expect_gaps(pairs.gaps(), elements, margin, run);
    for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
      run.form = kind == NeighborListKind::half ? ListForm::half_rows : ListForm::full_rows;
      const NeighborList rows = build_neighbor_list(elements, domain, kind, options);
      expect_gaps(rows.gaps(), elements, margin, run);
    }
    for (const double gap : pairs.gaps()) ++(gap <= 0.0 ? signs.touch : signs.apart);
  }
}

class DeviceGaps : public ::testing::TestWithParam<scenes::SceneInfo> {};

INSTANTIATE_TEST_SUITE_P(Scenes, DeviceGaps,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(DeviceGaps, InOpenSpace) {
  Signs signs;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{120}}) {
    const Scene scene = GetParam().make(count, 3);
    expect_gaps(view_of(scene), Domain::open(), 0.0, signs);
    EXPECT_EQ(signs.apart, 0U);
    if (count == 0) continue;
    Signs with_margin;
    const Float32Scene rounded(scene);
    expect_gaps(rounded.view(), Domain::open(), scene.radius[0], with_margin);
  }
}

TEST(DeviceGapsInCells, OfOneSetAndOfTwo) {
  Signs signs;
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) {
      for (const int dimensions : {2, 3}) {
        SCOPED_TRACE(::testing::Message()
                     << name_of(kind) << ", " << name_of(extreme) << ", " << dimensions << 'D');
        const std::size_t count = kind == DomainKind::small_cell ? 12 : 40;
        const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, 17);
        expect_gaps(view_of(system.scene), system.domain, system.margin, signs);
        const double largest = *std::ranges::max_element(system.scene.radius);
        if (kind != DomainKind::small_cell && largest < 0x1p900) {
          expect_gaps(view_of(system.scene), system.domain, 0.75 * largest, signs);
        }
        const SceneInTwo sets(system.scene);
        const ElementView second = view_of(sets.second);
        const PairList pairs = find_contact_pairs(view_of(sets.first), second, system.domain,
                                                  options_of(system.margin, Shifts::stored));
        expect_gaps(pairs.gaps(), view_of(sets.first), system.margin,
                    {.domain = system.domain, .shifts = Shifts::stored, .second = &second});
      }
    }
  }
  EXPECT_GT(signs.touch, 5000U);
  EXPECT_GT(signs.apart, 5000U);
}

/// Ties that only the last stages decide, in open space and through faces: numbers of many bits
/// whose gap is 0, or next to it.
TEST(DeviceGapsInCells, OfCrystalsThatTouch) {
  Signs signs;
  for (const double offset : {0.0, 1e6, 0x1p-30}) {
    for (const double radius : {0.5, std::nextafter(0.5, 0.0), std::nextafter(0.5, 1.0)}) {
      Scene scene;
      for (int k = 0; k < 64; ++k) {
        scene.x.push_back(k % 4 + offset);
        scene.y.push_back(k / 4 % 4 - offset);
        scene.z.push_back(k / 16 + 3 * offset);
        scene.radius.push_back(radius);
      }
      expect_gaps(view_of(scene), Domain::periodic({4.0, 4.0, 4.0}), 0.25, signs);
      expect_gaps(view_of(scene), Domain::open(), 0.25, signs);
    }
  }
  EXPECT_GT(signs.touch, 1000U);
  EXPECT_GT(signs.apart, 500U);
}

TEST(DeviceGapsMemory, IsWithinThePlan) {
  const Scene scene = scenes::scene_named("dense").make(3000, 5);
  for (const Domain& domain : {Domain::open(), Domain::periodic({15.0, 15.0, 15.0})}) {
    for (const ListForm form : {ListForm::pairs, ListForm::half_rows, ListForm::full_rows}) {
      for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
        const HostAnswer answer = list_on_host(view_of(scene), 0.0,
                                               {.items_at_a_time = 100,
                                                .domain = domain,
                                                .shifts = shifts,
                                                .form = form,
                                                .quantities = Quantity::gap});
        const std::uint64_t entries = answer.gaps.size() + answer.exact_decisions;
        const device::MemoryPlan plan = device::plan(answer.searched, entries);
        EXPECT_EQ(plan.quantity_bytes, 8 * entries);
        const bool with_shifts = shifts == Shifts::stored || domain.is_periodic();
        EXPECT_LE(answer.peak_bytes, 76 * answer.searched + (with_shifts ? 44 : 16) * entries +
                                         plan.quantity_bytes + 8192);
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
