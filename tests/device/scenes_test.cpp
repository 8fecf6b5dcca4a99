// Every scene through the stages of the device engine on the host: the bytes of `rows`, in any
// order of items.

#include "device/host/host_detection.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

namespace abut::testing {
namespace {

/// Fewer elements where pairs are many.
std::size_t count_for(const scenes::SceneInfo& scene) {
  static const std::map<std::string_view, std::size_t> fewer{{"coincident", 400},
                                                             {"two_far_clusters", 3000}};
  const auto found = fewer.find(scene.name);
  return found == fewer.end() ? 6000 : found->second;
}

PairVector pairs_of_rows(const ElementView& elements, double margin) {
  const PairList list = find_contact_pairs(elements, Domain::open(),
                                           {.algorithm = Algorithm::rows, .margin = margin});
  return {list.begin(), list.end()};
}

void check(const ElementView& elements, double margin) {
  SCOPED_TRACE("margin " + std::to_string(margin));
  const PairVector expected = pairs_of_rows(elements, margin);
  for (const device::ItemOrder order :
       {device::ItemOrder::ascending, device::ItemOrder::descending, device::ItemOrder::shuffled}) {
    const HostAnswer answer = list_on_host(elements, margin, {.order = order});
    EXPECT_TRUE(same_canonical_pairs(expected, answer.pairs));
    EXPECT_EQ(answer.held_bytes, 0U);
  }
  EXPECT_EQ(count_on_host(elements, margin).count, expected.size());
}

class DeviceScenes : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(DeviceScenes, Float64) {
  const scenes::Scene scene = GetParam().make(count_for(GetParam()), 3);
  check(view_of(scene), 0.0);
  check(view_of(scene), 0.3 * scene.radius[0]);
}

TEST_P(DeviceScenes, Float32) {
  // So far apart, float32 leaves every element of a group in one place.
  const std::size_t count = GetParam().name == "two_far_clusters" ? 800 : count_for(GetParam());
  const Float32Scene scene(GetParam().make(count, 4));
  check(scene.view(), 0.0);
}

/// Small spheres around (0, 0, 0) and (2^35, 0, 0), whose cells lie in two stretches with a gap
/// between them, and large ones, which begin or end in the one or the other.
TEST(DeviceScene, LargeSpheresReachSmallOnesOnBothSidesOfAGap) {
  constexpr double apart = 0x1p35;
  const scenes::Scene cluster = scenes::scene_named("dense").make(500, 3);
  scenes::Scene scene = cluster;
  for (std::size_t k = 0; k < cluster.size(); ++k) {
    scene.x.push_back(cluster.x[k] + apart);
    scene.y.push_back(cluster.y[k]);
    scene.z.push_back(cluster.z[k]);
    scene.radius.push_back(cluster.radius[k]);
  }
  for (const double radius : {0.5 * apart, 0.5 * apart + 1.0, 0.25 * apart, 0.25 * apart + 2.0}) {
    for (const double x : {radius, apart + 3.0 + radius, apart + 3.0 - radius}) {
      scene.x.push_back(x);
      scene.y.push_back(1.0);
      scene.z.push_back(0.5);
      scene.radius.push_back(radius);
    }
  }
  EXPECT_GT(pairs_of_rows(view_of(scene), 0.0).size(), 3500U);
  check(view_of(scene), 0.0);
  check(view_of(scene), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DeviceScenes,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
