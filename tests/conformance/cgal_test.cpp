// A second oracle, by other people: CGAL finds the intersecting bounding boxes of 20,000 spheres
// (P. Alliez et al., CGAL Manual, dD Iso-oriented Box Intersection), rational numbers the contacts
// among them.

#include "support/algorithm_list.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <CGAL/Box_intersection_d/Box_with_handle_d.h>
#include <CGAL/box_intersection_d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::size_t count = 20000;

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::size_t*>;

/// Boxes of the spheres, a hair larger so that no rounding cuts a contact off.
std::vector<Box> boxes_of(const scenes::Scene& scene, const std::vector<std::size_t>& numbers) {
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const double half = scene.radius[k] * (1.0 + 0x1p-40);
    double lower[3] = {scene.x[k] - half, scene.y[k] - half, scene.z[k] - half};
    double upper[3] = {scene.x[k] + half, scene.y[k] + half, scene.z[k] + half};
    for (double& bound : lower) bound -= std::fabs(bound) * 0x1p-50;
    for (double& bound : upper) bound += std::fabs(bound) * 0x1p-50;
    boxes.emplace_back(lower, upper, &numbers[k]);
  }
  return boxes;
}

PairVector pairs_by_cgal(const scenes::Scene& scene) {
  std::vector<std::size_t> numbers(scene.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = k;
  std::vector<Box> boxes = boxes_of(scene, numbers);
  PairVector pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto [i, j] = std::minmax(*a.handle(), *b.handle());
    if (!rational_contact(scene, i, j, 0.0)) return;
    pairs.push_back({static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

class Cgal : public ::testing::TestWithParam<const char*> {};

TEST_P(Cgal, SamePairsOfTwentyThousandSpheres) {
  const scenes::Scene scene = scenes::scene_named(GetParam()).make(count, 99);
  const PairVector expected = pairs_by_cgal(scene);
  ASSERT_GT(expected.size(), count / 10);
  for (const Algorithm algorithm : algorithms_for(3)) {
    const auto found = find_contact_pairs(view_of(scene), Domain::open(), {.algorithm = algorithm});
    EXPECT_TRUE(same_canonical_pairs(expected, found.pairs())) << name_of(algorithm);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Cgal,
                         ::testing::Values("dense", "bidisperse", "touching_fcc", "near_faces"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace abut::testing
