// Sets within sets of so many elements that they wait for all workers. The device engine, which
// meets the tests of few such elements, cuts no crowds out of its cells.

#include "scenes/many_scales.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

using scenes::Directions;
using scenes::Radii;

TEST(RowsScales, SetsWaitForAllWorkers) {
  for (const Radii radii : {Radii::equal, Radii::as_root, Radii::as_distance}) {
    SCOPED_TRACE(static_cast<int>(radii));
    const scenes::Scene scene =
        scenes::spheres_of_scales({Directions::all, radii, 2.5}, 40.0, 36000);
    const PairList expected =
        find_contact_pairs(view_of(scene), Domain::open(), {.algorithm = Algorithm::direct_check});
    EXPECT_TRUE(rows_agree(expected.pairs(), view_of(scene), 0.0, {1, 2, 3}));
  }
}

}  // namespace
}  // namespace abut::testing
