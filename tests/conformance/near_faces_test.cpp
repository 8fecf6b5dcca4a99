// The scenes aimed at cell faces have teeth: a grid without the margin misses pairs of them, in the
// very numbers of the scene, while on random scenes it misses none.

#include "support/oracle.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace abut::testing {
namespace {

/// Munjiza's eq. 3.59 as printed: cells exactly as wide as the largest reach.
template <class Real>
class PrintedGrid {
 public:
  PrintedGrid(const scenes::Scene& scene, bool by_division)
      : scene_(scene),
        reach_(
            static_cast<Real>(2.0 * *std::max_element(scene.radius.begin(), scene.radius.end()))),
        by_division_(by_division) {}

  [[nodiscard]] bool sees(ContactPair pair) const {
    return adjacent(scene_.x, pair) && adjacent(scene_.y, pair) &&
           (scene_.dimensions == 2 || adjacent(scene_.z, pair));
  }

 private:
  [[nodiscard]] bool adjacent(const std::vector<double>& axis, ContactPair pair) const {
    const auto lower = static_cast<Real>(*std::min_element(axis.begin(), axis.end()));
    const auto cell = [&](ElementIndex k) {
      const Real offset = static_cast<Real>(axis[k]) - lower;
      return static_cast<long>(std::floor(by_division_ ? offset / reach_ : offset * (1 / reach_)));
    };
    return std::labs(cell(pair.first) - cell(pair.second)) <= 1;
  }

  const scenes::Scene& scene_;
  Real reach_;
  bool by_division_;
};

template <class Real>
std::size_t missed_by_printed_grid(const char* name, bool by_division) {
  const scenes::Scene scene = scenes::scene_named(name).make(1200, 1);
  const PrintedGrid<Real> grid(scene, by_division);
  const PairVector pairs = oracle_pairs(scene);
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [&grid](ContactPair pair) { return !grid.sees(pair); }));
}

TEST(NearFaces, PrintedGridMissesPairs) {
  for (const bool by_division : {true, false}) {
    EXPECT_GT(missed_by_printed_grid<double>("near_faces_2d", by_division), 100U);
    EXPECT_GT(missed_by_printed_grid<double>("near_faces", by_division), 100U);
    EXPECT_GT(missed_by_printed_grid<float>("near_faces_float32_2d", by_division), 100U);
    EXPECT_GT(missed_by_printed_grid<float>("near_faces_float32", by_division), 100U);
  }
}

TEST(NearFaces, RandomScenesDoNotFindTheFault) {
  for (const bool by_division : {true, false}) {
    EXPECT_EQ(missed_by_printed_grid<double>("gas_2d", by_division), 0U);
    EXPECT_EQ(missed_by_printed_grid<double>("dense", by_division), 0U);
  }
}

/// Both sides of touching are there: some partners are found, some are not.
TEST(NearFaces, BothSidesOfTouching) {
  for (const char* name :
       {"near_faces_2d", "near_faces", "near_faces_float32_2d", "near_faces_float32"}) {
    const scenes::Scene scene = scenes::scene_named(name).make(1201, 1);
    std::size_t touching = 0;
    for (std::size_t k = 1; k < scene.size(); k += 2) {
      if (rational_contact(scene, k, k + 1, 0.0)) ++touching;
    }
    EXPECT_GT(touching, 400U) << name;
    EXPECT_LT(touching, 550U) << name;
  }
}

}  // namespace
}  // namespace abut::testing
