#pragma once

#include "support/box_oracle.hpp"
#include "support/periodic_oracle.hpp"
#include "support/rows_variants.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

/// Boxes in periodic domains: rows, at every instruction set and several numbers of threads, and
/// direct_check against all images in rational numbers, and against each other.
namespace abut::testing {

using scenes::BoxScene;

[[nodiscard]] constexpr std::size_t axes_of(const BoxScene& scene) {
  return static_cast<std::size_t>(scene.dimensions);
}

inline void add(BoxScene& scene, const double* lower, const double* upper) {
  for (std::size_t axis = 0; axis < axes_of(scene); ++axis) {
    scene.lower[axis].push_back(lower[axis]);
    scene.upper[axis].push_back(upper[axis]);
  }
}

[[nodiscard]] inline std::vector<ImagePair> image_pairs(const PairList& list) {
  std::vector<ImagePair> pairs;
  for (std::size_t k = 0; k < list.size(); ++k) pairs.push_back({list[k], list.shifts()[k]});
  return pairs;
}

/// rows as direct_check: all levels, several numbers of threads. Returns the pairs.
inline std::vector<ImagePair> agreed(const BoxScene& scene, const Domain& domain, double margin) {
  const PairList expected = find_contact_pairs(
      view_of(scene), domain,
      {.algorithm = Algorithm::direct_check, .shifts = Shifts::stored, .margin = margin});
  EXPECT_TRUE(rows_agree(expected, view_of(scene), domain, margin));
  return image_pairs(expected);
}

/// The same, and both as the rational numbers say. Returns how many pairs there are.
inline std::size_t check(const BoxScene& scene, const Domain& domain, double margin,
                         std::int32_t farthest) {
  const auto expected = oracle_image_pairs(scene, domain, margin, farthest);
  EXPECT_TRUE(agreed(scene, domain, margin) == expected) << expected.size() << " pairs expected";
  return expected.size();
}

}  // namespace abut::testing
