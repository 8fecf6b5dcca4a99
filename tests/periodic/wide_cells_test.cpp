// Droplets at the faces of cells that are far wider than they are: the pairs of direct_check, and
// no more work than in a cell of ordinary width.

#include "exact/hard_pairs.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

/// Where the droplet lies: around the origin, with coordinates of both signs; the same, each
/// coordinate brought into the cell; around the far corner of the cell; at the faces of a cell
/// around the origin; or in the corner at the origin, with one element in the corner opposite.
enum class Place { around_origin, folded, far_corner, opposite_faces, near_corner };

/// Radii of the elements, and how far the strays lie out that spread over more than a cell.
struct Droplet {
  int dimensions = 3;
  std::size_t count = 0;
  double largest_ratio = 1.0;
  Place place = Place::around_origin;
  double strays = 0.0;  ///< in widths of the cell
};

scenes::Scene make(const Droplet& droplet, double width_of_cell, Random& random) {
  scenes::Scene scene;
  scene.dimensions = droplet.dimensions;
  const double width = 2.5 * std::pow(static_cast<double>(droplet.count), 1.0 / droplet.dimensions);
  const auto coordinate = [&] {
    const double x = random.uniform(-0.5 * width, 0.5 * width);
    if (droplet.place == Place::far_corner) return width_of_cell + x;
    if (droplet.place == Place::near_corner) return x + 0.5 * width;
    if (droplet.place == Place::opposite_faces) return x - std::copysign(0.5 * width_of_cell, x);
    return droplet.place == Place::folded && x < 0.0 ? x + width_of_cell : x;
  };
  const std::array columns{&scene.x, &scene.y, &scene.z};
  const auto dimensions = static_cast<std::size_t>(droplet.dimensions);
  for (std::size_t k = 0; k < droplet.count; ++k) {
    for (std::size_t axis = 0; axis < dimensions; ++axis) columns[axis]->push_back(coordinate());
    scene.radius.push_back(std::pow(droplet.largest_ratio, -random.uniform(0.0, 1.0)));
  }
  if (droplet.place == Place::near_corner) {
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      columns[axis]->back() = std::nextafter(width_of_cell, 0.0);
    }
  }
  for (const double side : {-1.0, 1.0}) {
    if (droplet.strays == 0.0) break;
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      columns[axis]->push_back(side * droplet.strays * width_of_cell);
    }
    scene.radius.push_back(1.0);
  }
  return scene;
}

struct NamedDomain {
  std::string_view name;
  Domain domain;
};

std::vector<NamedDomain> domains_of(int dimensions, double width) {
  if (dimensions == 2) {
    return {{"block", Domain::periodic({width, width})},
            {"slab", Domain::periodic({width, unbounded})},
            {"triclinic", Domain::lattice({width, 0.0}, {0.4 * width, width})},
            {"sheared", Domain::lees_edwards({width, width}, 0.3 * width)}};
  }
  return {{"block", Domain::periodic({width, width, width})},
          {"slab", Domain::periodic({unbounded, width, unbounded})},
          {"triclinic", Domain::lattice({width, 0.0, 0.0}, {0.4 * width, width, 0.0},
                                        {0.3 * width, 0.2 * width, width})},
          {"sheared", Domain::lees_edwards({width, width, width}, 0.3 * width)}};
}

Options with(Algorithm algorithm, double margin, int threads) {
  return {.algorithm = algorithm,
          .order = Order::canonical,
          .shifts = Shifts::stored,
          .margin = margin,
          .threads = threads};
}

/// Returns how many pairs there are across faces.
std::size_t expect_same_pairs(const ElementView& view, const Domain& domain, double margin) {
  const PairList expected =
      find_contact_pairs(view, domain, with(Algorithm::direct_check, margin, 1));
  for (const int threads : {1, 2}) {
    const PairList found = find_contact_pairs(view, domain, with(Algorithm::rows, margin, threads));
    EXPECT_TRUE(std::ranges::equal(found, expected)) << found.size() << " of " << expected.size();
    EXPECT_TRUE(std::ranges::equal(found.shifts(), expected.shifts()));
  }
  std::size_t across = 0;
  for (const ImageShift& shift : expected.shifts()) across += shift == ImageShift{} ? 0 : 1;
  return across;
}

constexpr std::array places{Place::around_origin, Place::folded, Place::far_corner,
                            Place::opposite_faces, Place::near_corner};

scenes::Scene mirrored(scenes::Scene scene) {
  for (auto* const coordinates : {&scene.x, &scene.y, &scene.z}) {
    for (double& x : *coordinates) x = -x;
  }
  return scene;
}

void expect_few_tests(const ElementView& view, const Domain& domain) {
  const Statistics statistics =
      count_contact_pairs(view, domain, {.algorithm = Algorithm::rows, .threads = 1});
  EXPECT_LE(statistics.candidate_tests, 100 * view.size()) << view.size() << " elements";
}

class WideCells : public ::testing::TestWithParam<int> {};

/// From cells that are covered by the reach to those in which nothing near the far corner can be
/// told apart.
TEST_P(WideCells, HaveThePairsOfADirectCheck) {
  Random random(114);
  std::size_t across = 0;
  for (const int exponent : {20, 25, 26, 33, 44, 51, 54, 60, 300}) {
    const double width = std::ldexp(0.9, exponent);
    for (const Place place : places) {
      for (const double largest_ratio : {1.0, 100.0}) {
        for (const double strays : {0.0, 0.9}) {
          const Droplet droplet{GetParam(), 120, largest_ratio, place, strays};
          const scenes::Scene made = make(droplet, width, random);
          const scenes::Scene scene = random.below(2) == 0 ? made : mirrored(made);
          const scenes::BoxScene boxes = scenes::boxes_in(scene, 7);
          for (const auto& [name, domain] : domains_of(GetParam(), width)) {
            SCOPED_TRACE(std::string(name) + ", 0.9 * 2^" + std::to_string(exponent));
            const double margin = random.below(2) == 0 ? 0.0 : 0.25;
            across += expect_same_pairs(view_of(scene), domain, margin);
            across += expect_same_pairs(view_of(boxes), domain, margin);
          }
        }
      }
    }
  }
  EXPECT_GT(across, 5000U);
}

/// Enough elements for layers, whose filter takes for certain what lies within reach as grown: at
/// opposite faces by an eighth of a radius to all of it.
TEST_P(WideCells, HavePairsThatAreOnesAsGiven) {
  Random random(116);
  std::size_t across = 0;
  for (const int exponent : {51, 54}) {
    const double width = std::ldexp(0.9, exponent);
    for (const double largest_ratio : {1.0, 3.0}) {
      const Droplet droplet{GetParam(), 2000, largest_ratio, Place::opposite_faces, 0.0};
      const scenes::Scene scene = make(droplet, width, random);
      const scenes::BoxScene boxes = scenes::boxes_in(scene, 7);
      const Domain domain = domains_of(GetParam(), width)[0].domain;
      across += expect_same_pairs(view_of(scene), domain, 0.0);
      across += expect_same_pairs(view_of(boxes), domain, 0.0);
    }
  }
  EXPECT_GT(across, 50U);
}

/// Candidate tests for each element do not grow with the number of elements, nor much with the
/// width of the cell.
TEST_P(WideCells, TakeNoMoreTestsThanOthers) {
  Random random(115);
  for (const int exponent : {20, 26, 33, 44, 60}) {
    const double width = std::ldexp(0.9, exponent);
    for (const Place place : places) {
      // Far from the origin many elements lie in the same point then.
      const bool is_known = place == Place::around_origin || place == Place::near_corner;
      if (exponent > 44 && !is_known) continue;
      for (const double strays : {0.0, 0.9}) {
        for (const std::size_t count : {1500U, 6000U}) {
          const scenes::Scene scene = make({GetParam(), count, 1.0, place, strays}, width, random);
          for (const auto& [name, domain] : domains_of(GetParam(), width)) {
            SCOPED_TRACE(std::string(name) + ", 0.9 * 2^" + std::to_string(exponent) + ", place " +
                         std::to_string(static_cast<int>(place)) +
                         (strays > 0.0 ? ", strays" : ""));
            for (const scenes::Scene& either : {scene, mirrored(scene)}) {
              expect_few_tests(view_of(either), domain);
              expect_few_tests(view_of(scenes::boxes_in(either, 7)), domain);
            }
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, WideCells, ::testing::Values(2, 3));

}  // namespace
}  // namespace abut::testing
