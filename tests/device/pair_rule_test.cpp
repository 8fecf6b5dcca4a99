// Rules of who may pair through the stages of the device engine on the host: the pairs, shifts,
// rows and gaps of `rows`, of one set and of two, in every kind of domain.

#include "device/host/as_rows.hpp"
#include "device/host/host_detection.hpp"
#include "device/scene_in_two.hpp"
#include "support/made_rule.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace abut::testing {
namespace {

using device::ListForm;
using scenes::Scene;

PairList all_pairs(const ElementView& elements, const Domain& domain, double margin) {
  return find_contact_pairs(elements, domain, {.margin = margin});
}

MadeRule rule_for(const ElementView& elements, const Domain& domain, double margin,
                  std::uint64_t seed) {
  return {elements.size(), 0, false, all_pairs(elements, domain, margin).pairs(), seed};
}

/// Lists in rows and their gaps, in any order of items; returns how many neighbors there are.
std::size_t expect_rows(const NeighborList& expected, const ElementView& elements, double margin,
                        const HostRun& with) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  for (HostRun run : in_all_orders(with)) {
    run.quantities = Quantity::gap;
    const HostAnswer found = list_on_host(elements, margin, run);
    EXPECT_TRUE(std::ranges::equal(expected.offsets(), found.offsets));
    EXPECT_TRUE(std::ranges::equal(expected.neighbors(), found.neighbors))
        << found.neighbors.size() << " neighbors for " << expected.neighbors().size();
    EXPECT_TRUE(std::ranges::equal(expected.shifts(), found.shifts));
    EXPECT_TRUE(std::ranges::equal(expected.gaps(), found.gaps, {}, bits, bits));
    EXPECT_EQ(found.count, expected.statistics().contact_pairs);
  }
  return expected.neighbors().size();
}

std::size_t expect_rows(const ElementView& elements, const Domain& domain, double margin,
                        const PairRule& rule) {
  std::size_t neighbors = 0;
  for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
    for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
      const Options options{.algorithm = Algorithm::rows,
                            .shifts = shifts,
                            .quantities = Quantity::gap,
                            .margin = margin,
                            .rule = rule};
      const bool is_full = kind == NeighborListKind::full;
      neighbors +=
          expect_rows(build_neighbor_list(elements, domain, kind, options), elements, margin,
                      {.domain = domain,
                       .shifts = shifts,
                       .form = is_full ? ListForm::full_rows : ListForm::half_rows,
                       .rule = rule});
    }
  }
  return neighbors;
}

class DeviceRules : public ::testing::TestWithParam<scenes::SceneInfo> {};

INSTANTIATE_TEST_SUITE_P(Scenes, DeviceRules,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(DeviceRules, InOpenSpace) {
  const std::size_t most = GetParam().name == "coincident" ? 25 : 80;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, most}) {
    const Scene scene = GetParam().make(count, 3);
    const Float32Scene rounded(scene);
    const double margin = count == 0 ? 0.0 : 0.3 * scene.radius[0];
    const MadeRule made = rule_for(view_of(scene), Domain::open(), margin, count);
    for (int parts = 1; parts < MadeRule::all_parts; ++parts) {
      SCOPED_TRACE(::testing::Message() << count << " elements, parts " << parts);
      const PairRule rule = made.rule(parts);
      expect_as_rows(view_of(scene), Domain::open(), 0.0, rule);
      expect_as_rows(rounded.view(), Domain::open(), margin, rule);
    }
    expect_rows(view_of(scene), Domain::open(), margin, made.rule(MadeRule::all_parts - 1));
  }
}

/// More elements, so that there are levels and cells of many kinds.
TEST_P(DeviceRules, OfManyElements) {
  const std::size_t count = GetParam().name == "coincident" ? 200 : 1500;
  const Scene scene = GetParam().make(count, 5);
  const MadeRule made = rule_for(view_of(scene), Domain::open(), 0.0, 9);
  for (const int parts : {MadeRule::table | MadeRule::exclusions, MadeRule::categories + 0}) {
    SCOPED_TRACE(parts);
    expect_as_rows(view_of(scene), Domain::open(), 0.0, made.rule(parts));
  }
}

TEST(DeviceRulesInCells, OfOneSetAndOfTwo) {
  std::size_t pairs = 0;
  std::size_t all = 0;
  int parts = 0;
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) {
      for (const int dimensions : {2, 3}) {
        parts = parts % (MadeRule::all_parts - 1) + 1;
        SCOPED_TRACE(::testing::Message() << name_of(kind) << ", " << name_of(extreme) << ", "
                                          << dimensions << "D, parts " << parts);
        const std::size_t count = kind == DomainKind::small_cell ? 12 : 60;
        const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, 23);
        const ElementView elements = view_of(system.scene);
        const MadeRule made = rule_for(elements, system.domain, system.margin, 5);
        pairs += expect_as_rows(elements, system.domain, system.margin, made.rule(parts));
        all += all_pairs(elements, system.domain, system.margin).size();
        expect_rows(elements, system.domain, system.margin, made.rule(parts));

        const SceneInTwo sets(system.scene);
        const ElementView first = view_of(sets.first);
        const ElementView second = view_of(sets.second);
        const PairList between =
            find_contact_pairs(first, second, system.domain, {.margin = system.margin});
        const MadeRule of_two(first.size(), second.size(), true, between.pairs(), 6);
        pairs += expect_as_rows(first, second, system.domain, system.margin, of_two.rule(parts));
        all += between.size();
      }
    }
  }
  EXPECT_GT(pairs, 1000U);
  EXPECT_GT(all, 2 * pairs);
}

TEST(DeviceRulesOfTwoSets, WithEveryPart) {
  const SceneInTwo sets(scenes::scene_named("bidisperse").make(200, 3));
  const ElementView first = view_of(sets.first);
  const ElementView second = view_of(sets.second);
  for (const Domain& domain : {Domain::open(), Domain::periodic({12.0, 12.0, 12.0})}) {
    const PairList between = find_contact_pairs(first, second, domain, {.margin = 0.1});
    const MadeRule made(first.size(), second.size(), true, between.pairs(), 8);
    for (int parts = 1; parts < MadeRule::all_parts; ++parts) {
      SCOPED_TRACE(parts);
      const PairRule rule = made.rule(parts);
      expect_as_rows(first, second, domain, 0.1, rule);
      const Options options{
          .shifts = Shifts::stored, .quantities = Quantity::gap, .margin = 0.1, .rule = rule};
      expect_rows(build_neighbor_list(first, second, domain, options), first, 0.1,
                  {.domain = domain,
                   .shifts = Shifts::stored,
                   .form = ListForm::half_rows,
                   .second = &second,
                   .rule = rule});
    }
  }
}

/// All images of a pair, and those of an element with itself.
TEST(DeviceRulesInCells, DenyImages) {
  const Scene scene = scene_of(2, {{0.25, 0.5, 0, 0.5}, {0.75, 0.5, 0, 0.125}});
  const Domain square = Domain::periodic({1.0, 1.0});
  EXPECT_EQ(expect_as_rows(view_of(scene), square), 4U);
  const PairVector pairs[] = {{{0, 0}}, {{1, 0}}, {{0, 0}, {0, 1}}};
  const std::size_t left[] = {2, 2, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const ExclusionList exclusions(pairs[k], 2);
    EXPECT_EQ(expect_as_rows(view_of(scene), square, 0.0, {.exclusions = &exclusions}), left[k]);
  }
}

}  // namespace
}  // namespace abut::testing
