// Elements as many cells out as can be counted: what direct_check answers for, rows does, too.

#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace abut::testing {
namespace {

/// Expects the pairs of direct_check, with their shifts, and returns how many there are.
std::size_t expect_same_pairs(const ElementView& elements, const Domain& domain, double margin) {
  const auto pairs_by = [&](Algorithm algorithm) {
    return find_contact_pairs(
        elements, domain,
        {.algorithm = algorithm, .shifts = Shifts::stored, .margin = margin, .threads = 1});
  };
  const PairList expected = pairs_by(Algorithm::direct_check);
  const PairList found = pairs_by(Algorithm::rows);
  EXPECT_TRUE(std::vector<ContactPair>(found.begin(), found.end()) ==
              std::vector<ContactPair>(expected.begin(), expected.end()));
  EXPECT_TRUE(std::vector<ImageShift>(found.shifts().begin(), found.shifts().end()) ==
              std::vector<ImageShift>(expected.shifts().begin(), expected.shifts().end()));
  return expected.size();
}

/// Cells of a turned vector are numbered from the other side, where there is one less.
TEST(FarCells, AreTheLastOfAVector) {
  const std::vector<double> x{2147483647.25};
  const std::vector<double> half{0.5};
  EXPECT_EQ(expect_same_pairs(spheres(x, half, half, half), Domain::periodic({1.0, 1.0, 1.0}), 0.0),
            3U);
  const std::vector<double> two{2147483647.5, 2147483646.6875};
  const std::vector<double> y{0.0, 0.0};
  const Domain along_x = Domain::periodic({1.0, unbounded});
  EXPECT_EQ(expect_same_pairs(discs(two, y, 0.05), along_x, 0.109375), 1U);
}

/// Images of boxes are made downwards.
TEST(FarCells, AreTheLastOfAVectorForBoxes) {
  const Domain along_x = Domain::periodic({1.0, unbounded});
  const std::vector<double> xmin{-2147483647.5, -2147483646.6875};
  const std::vector<double> xmax{xmin[0] + 0.125, xmin[1] + 0.0625};
  const std::vector<double> ymin{0.0, 0.0};
  const std::vector<double> ymax{0.1, 0.1};
  EXPECT_EQ(expect_same_pairs(rectangles(xmin, ymin, xmax, ymax), along_x, 0.109375), 0U);
  EXPECT_EQ(expect_same_pairs(rectangles(xmin, ymin, xmax, ymax), along_x, 0.125), 1U);
}

/// Far along one vector, they are many cells out along another that leans on it, unless they are
/// moved along both.
TEST(FarCells, OfLeaningVectors) {
  const Domain leaning = Domain::lattice({1.0, 0.0}, {0.5, 1.0});
  const std::vector<double> x{2.9e9, 2.9e9 - 5.0, 2.9e9 - 3.0};
  const std::vector<double> y{1.9e9, 1.9e9 + 0.2, 1.9e9};
  EXPECT_EQ(expect_same_pairs(discs(x, y, 0.3), leaning, 0.0), 3U);
  const Domain long_one = Domain::lattice({1.0, 0.0}, {0x1p34, 0x1p60});
  const std::vector<double> far_x{0.5, 0x1p34 + 1.0};
  const std::vector<double> far_y{0.0, 0x1p60};
  EXPECT_EQ(expect_same_pairs(discs(far_x, far_y, 0.1), long_one, 0.0), 0U);
  EXPECT_EQ(expect_same_pairs(discs(far_x, far_y, 0.3), long_one, 0.0), 2U);
}

}  // namespace
}  // namespace abut::testing
