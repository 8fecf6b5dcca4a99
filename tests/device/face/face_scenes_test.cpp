// Every scene through the face of devices: the digest of the processor, twice, with as many exact
// decisions, and the same number from a count.

#include "device/face/face_detection.hpp"
#include "io/write/digest.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace abut::testing {
namespace {

/// Fewer elements where pairs are many.
std::size_t count_for(const scenes::SceneInfo& scene) {
  const bool is_crowded = scene.name == "coincident" || scene.name == "two_far_clusters";
  return std::min<std::size_t>(elements_of_a_scene(), is_crowded ? 800 : ~std::size_t{0});
}

/// Elements of one detector, again and again.
void check(const ElementView& elements, double margin) {
  SCOPED_TRACE("margin " + std::to_string(margin));
  const Options options{.algorithm = Algorithm::rows, .margin = margin};
  const PairList expected = find_contact_pairs(elements, Domain::open(), options);
  const device::ElementCopy copy(elements);
  device::Detector detector(options);
  const PairList first = detector.find_contact_pairs(copy.elements()).to_host();
  const PairList second = detector.find_contact_pairs(copy.elements()).to_host();
  EXPECT_EQ(io::digest(first.pairs()), io::digest(expected.pairs()));
  EXPECT_EQ(io::digest(second.pairs()), io::digest(expected.pairs()));
  EXPECT_EQ(first.statistics().exact_decisions, second.statistics().exact_decisions);
  const Statistics counted = detector.count_contact_pairs(copy.elements());
  EXPECT_EQ(counted.contact_pairs, expected.size());
  EXPECT_EQ(counted.exact_decisions, first.statistics().exact_decisions);
}

class FaceScenes : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(FaceScenes, Float64) {
  const scenes::Scene scene = GetParam().make(count_for(GetParam()), 3);
  check(view_of(scene), 0.0);
  check(view_of(scene), 0.2 * scene.radius[0]);
}

TEST_P(FaceScenes, Float32) {
  const Float32Scene scene(GetParam().make(count_for(GetParam()), 4));
  check(scene.view(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FaceScenes,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
