// Two sets through the stages of the device engine on the host, in open and periodic domains: the
// pairs and shifts of `rows`.

#include "device/host/as_rows.hpp"
#include "device/host/host_detection.hpp"
#include "device/scene_in_two.hpp"
#include "support/error_expectations.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

class DeviceTwoSets : public ::testing::TestWithParam<scenes::SceneInfo> {};

INSTANTIATE_TEST_SUITE_P(Scenes, DeviceTwoSets,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

/// Either set first, each of numbers of its own type.
TEST_P(DeviceTwoSets, InOpenSpace) {
  const std::size_t count = GetParam().name == "coincident" ? 200 : 1500;
  const SceneInTwo sets(GetParam().make(count, 3));
  expect_as_rows(view_of(sets.first), view_of(sets.second), Domain::open());
  const double margin = 0.3 * sets.first.radius[0];
  expect_as_rows(view_of(sets.second), Float32Scene(sets.first).view(), Domain::open(), margin);
}

TEST(DeviceTwoSetsInCells, AreThoseOfRows) {
  std::size_t pairs = 0;
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) {
      for (const int dimensions : {2, 3}) {
        SCOPED_TRACE(::testing::Message()
                     << name_of(kind) << ", " << name_of(extreme) << ", " << dimensions << 'D');
        const std::size_t count = kind == DomainKind::small_cell ? 25 : 100;
        const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, 7);
        const SceneInTwo sets(system.scene);
        pairs +=
            expect_as_rows(view_of(sets.first), view_of(sets.second), system.domain, system.margin);
      }
    }
  }
  EXPECT_GT(pairs, 1000U);
}

/// Each element with itself, too; and sets without elements.
TEST(DeviceTwoSetsInCells, OfOneArrayAndOfNone) {
  const Scene scene = scenes::scene_named("dense").make(300, 1);
  const Domain cube = Domain::periodic({9.0, 9.0, 9.0});
  EXPECT_GT(expect_as_rows(view_of(scene), view_of(scene), Domain::open()), scene.size());
  EXPECT_GT(expect_as_rows(view_of(scene), view_of(scene), cube), scene.size());
  const Scene none = scene_of(3, {});
  for (const Domain& domain : {Domain::open(), cube}) {
    EXPECT_EQ(expect_as_rows(view_of(scene), view_of(none), domain), 0U);
    EXPECT_EQ(expect_as_rows(view_of(none), view_of(scene), domain), 0U);
    EXPECT_EQ(expect_as_rows(view_of(none), view_of(none), domain), 0U);
  }
}

TEST(DeviceTwoSetsInCells, ErrorsNameTheSet) {
  const Scene good = scenes::scene_named("dense").make(20, 1);
  Scene bad = good;
  bad.y[7] = std::numeric_limits<double>::quiet_NaN();
  const auto list = [](const Scene& first, const Scene& second, const Domain& domain) {
    const ElementView others = view_of(second);
    static_cast<void>(list_on_host(view_of(first), 0.0, {.domain = domain, .second = &others}));
  };
  expect_error(ErrorCode::invalid_input, {"in the first set, element 7"},
               [&] { list(bad, bad, Domain::open()); });
  expect_error(ErrorCode::invalid_input, {"in the second set, element 7"}, [&] {
    list(good, bad, Domain::periodic({9.0, 9.0, 9.0}));
  });
  bad.y[7] = 1e12;
  expect_error(ErrorCode::invalid_input,
               {"element 27 has y = 1e+12", "the second set are counted from 20 on"}, [&] {
                 list(good, bad, Domain::periodic({9.0, 9.0, 9.0}));
               });
}

}  // namespace
}  // namespace abut::testing
