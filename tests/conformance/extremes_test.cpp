// Small systems at the edges of numbers and of grids, each against the oracle.

#include "support/algorithm_list.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double normal = std::numeric_limits<double>::min();

struct Extreme {
  const char* name;
  std::vector<HandMade> elements;
  double margin = 0.0;
};

/// For a readable name of the test.
void PrintTo(const Extreme& extreme, std::ostream* out) {
  *out << extreme.name;
}

std::vector<HandMade> repeated(std::size_t count, const HandMade& element) {
  return std::vector<HandMade>(count, element);
}

/// A row of touching elements along (x, y, z).
std::vector<HandMade> chain(std::size_t count, double x, double y, double z) {
  std::vector<HandMade> result;
  for (std::size_t k = 0; k < count; ++k) {
    const auto step = static_cast<double>(k);
    result.push_back({step * x, step * y, step * z, 0.5});
  }
  return result;
}

/// A few elements about each of two places.
std::vector<HandMade> two_groups(double place, double spacing, double radius) {
  std::vector<HandMade> result;
  for (const double origin : {-place, place}) {
    for (int k = 0; k < 4; ++k) {
      result.push_back({origin + k * spacing, origin - k * spacing, origin, radius});
    }
  }
  return result;
}

/// Points, two of three with a zero that has a sign, so close that the sizes are looked at.
std::vector<HandMade> negative_zeros_among(int count) {
  std::vector<HandMade> result;
  for (int k = 0; k < count; ++k) {
    result.push_back(
        {0.05 * (k % 17), 0.05 * (k / 17 % 17), 0.05 * (k / 289), k % 3 == 0 ? 0.5 : -0.0});
  }
  return result;
}

const std::vector<Extreme> extremes{
    {"none", {}},
    {"one", {{1, 2, 3, 4}}},
    {"one_of_radius_zero", {{-0.0, 0.0, -0.0, -0.0}}},
    {"two_touching", {{0, 0, 0, 1}, {2, 0, 0, 1}}},
    {"two_a_hair_apart", {{0, 0, 0, 1}, {2 + 0x1p-51, 0, 0, 1}}},
    {"two_far_apart", {{-1e6, 0, 0, 1}, {1e6, 1e6, 1e6, 1}}},
    {"radii_of_negative_zero_and_many_sizes", negative_zeros_among(300)},
    {"zeros_of_both_signs", {{0.0, -0.0, 0.0, 0.0}, {-0.0, 0.0, -0.0, -0.0}}},
    {"all_in_one_cell", {{0, 0, 0, 5}, {1, 1, 1, 5}, {2, 1, 0, 5}, {1, 2, 2, 5}, {0, 2, 1, 5}}},
    {"one_domain_one_cell", repeated(70, {3, 3, 3, 1})},
    {"one_row", chain(100, 1, 0, 0)},
    {"one_column", chain(100, 0, 1, 0)},
    {"one_layer_column", chain(100, 0, 0, 1)},
    {"diagonal", chain(100, 0.6, 0.8, 0)},
    // The extent is a multiple of the reach: Int((x - x_min) / d) of the last is n itself.
    {"on_upper_bound", {{0, 0, 0, 0.5}, {9, 9, 9, 0.5}, {10, 10, 10, 0.5}, {10, 9, 10, 0.5}}},
    {"on_negative_bound", {{-10, -10, -10, 0.5}, {-9, -10, -10, 0.5}, {0, 0, 0, 0.5}}},
    {"about_zero", {{-0.5, 0, 0, 0.5}, {0.5, 0, 0, 0.5}, {-1.5, 0, 0, 0.5}, {1.5, 0, 0, 0.5}}},
    {"points", {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 1, 0}, {0, 1, 1, 0}}},
    {"points_in_one_place", repeated(70, {0.1, 0.2, 0.3, 0})},
    {"points_a_denormal_apart", {{0, 0, 0, 0}, {smallest, 0, 0, 0}, {smallest, 0, 0, 0}}},
    {"points_spread", {{-largest, 0, 0, 0}, {largest, 0, 0, 0}, {largest, 0, 0, 0}, {1, 1, 1, 0}}},
    {"one_radius_among_points", {{0, 0, 0, 2}, {1, 1, 1, 0}, {2, 0, 0, 0}, {2, 1, 0, 0}}},
    {"coincident_of_all_sizes", {{1, 1, 1, 0}, {1, 1, 1, 1e-300}, {1, 1, 1, 1}, {1, 1, 1, 1e300}}},
    {"denormals",
     {{0, 0, 0, smallest},
      {2 * smallest, 0, 0, smallest},
      {5 * smallest, 0, 0, smallest},
      {2 * smallest, 2 * smallest, 0, smallest}}},
    {"about_the_smallest_normal",
     {{0, 0, 0, normal},
      {2 * normal, 0, 0, normal},
      {2 * normal, 2 * normal + smallest, 0, normal}}},
    {"1e_300", two_groups(1e-300, 2e-301, 1e-301)},
    {"1e300", two_groups(1e300, 2e299, 1e299)},
    {"1e300_with_tiny_radii", two_groups(1e300, 0.0, 1e-300)},
    {"1e300_and_1e_300", {{1e-300, 0, 0, 1e-300}, {3e-300, 0, 0, 1e-300}, {1e300, 0, 0, 1e299}}},
    {"sums_of_radii_overflow",
     {{-largest, 0, 0, largest},
      {largest, 0, 0, largest},
      {largest, largest, largest, largest},
      {-largest, -largest, 0, 0.5 * largest}}},
    {"extents_overflow",
     {{-largest, -largest, -largest, 1},
      {largest, largest, largest, 1},
      {0, 0, 0, 1},
      {1, 0, 0, 1},
      {largest, largest, largest, 0}}},
    {"two_groups_1e18_apart", two_groups(5e17, 128, 100)},
    {"huge_coordinates_tiny_radii", two_groups(1e15, 0.125, 0.0625)},
    {"huge_coordinates_tinier_radii", two_groups(1e15, 0.125, 1e-200)},
    {"margin_alone", {{0, 0, 0, 0}, {1, 0, 0, 0}, {2 + 0x1p-50, 0, 0, 0}}, 1.0},
    {"margin_a_denormal", {{0, 0, 0, 0}, {smallest, 0, 0, 0}, {3 * smallest, 0, 0, 0}}, smallest},
    {"margin_overflows",
     {{-largest, 0, 0, largest}, {largest, 0, 0, 0}, {0, largest, 0, 0}},
     largest},
    {"margin_beside_large_radii",
     {{0, 0, 0, 1e16}, {2e16 + 4, 0, 0, 1e16}, {-2e16, 0, 0, 1e16}},
     1.0},
};

/// Heads for every cell of an enormous grid may be refused, with advice.
bool refused_with_advice(const Error& error) {
  return error.code() == ErrorCode::limit_exceeded &&
         std::string(error.what()).find("use rows") != std::string::npos;
}

class Extremes : public ::testing::TestWithParam<Extreme> {
 protected:
  void check(int dimensions) {
    const scenes::Scene scene = scene_of(dimensions, GetParam().elements);
    const PairVector expected = oracle_pairs(scene, GetParam().margin);
    for (const Algorithm algorithm : algorithms_for(dimensions)) {
      SCOPED_TRACE(std::string(name_of(algorithm)));
      const bool by_heads =
          algorithm == Algorithm::screening_array || algorithm == Algorithm::munjiza_nbs;
      try {
        const auto found = find_contact_pairs(
            view_of(scene), Domain::open(), {.algorithm = algorithm, .margin = GetParam().margin});
        EXPECT_TRUE(same_canonical_pairs(expected, found.pairs()));
      } catch (const Error& error) {
        EXPECT_TRUE(by_heads && refused_with_advice(error)) << error.what();
      }
    }
    EXPECT_TRUE(rows_agree(expected, view_of(scene), GetParam().margin, {1, 2, 3, 7, 16}));
    if (!fits_float(scene)) return;
    const Float32Scene narrow(scene);
    EXPECT_TRUE(rows_agree(expected, narrow.view(), GetParam().margin, {1, 2, 3, 7, 16}));
  }
};

TEST_P(Extremes, In2D) {
  check(2);
}
TEST_P(Extremes, In3D) {
  check(3);
}

INSTANTIATE_TEST_SUITE_P(Systems, Extremes, ::testing::ValuesIn(extremes),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

/// Every number of elements about the sizes where loops, buffers and the choice change.
TEST(ElementCounts, AllSmallNumbers) {
  for (const char* name : {"pack_1", "dense", "coincident"}) {
    for (std::size_t count = 0; count <= 70; ++count) {
      SCOPED_TRACE(std::string(name) + " of " + std::to_string(count));
      const scenes::Scene scene = scenes::scene_named(name).make(count, 11);
      const PairVector expected = oracle_pairs(scene);
      for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
        const auto found =
            find_contact_pairs(view_of(scene), Domain::open(), {.algorithm = algorithm});
        EXPECT_TRUE(same_canonical_pairs(expected, found.pairs())) << name_of(algorithm);
      }
    }
  }
}

/// Pairs are handed on in batches; lists that end just before, at and after the end of one.
TEST(PairCounts, AroundFullBuffers) {
  for (const std::size_t pairs : {1022U, 1023U, 1024U, 1025U, 2047U, 2048U, 2049U}) {
    const scenes::Scene beads = scene_of(3, chain(pairs + 1, 1, 0, 0));
    for (const Algorithm algorithm : algorithms_for(3)) {
      const auto found =
          find_contact_pairs(view_of(beads), Domain::open(), {.algorithm = algorithm});
      EXPECT_EQ(found.size(), pairs) << name_of(algorithm);
    }
  }
}

}  // namespace
}  // namespace abut::testing
