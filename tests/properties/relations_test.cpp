// Relations between two detections that hold exactly, whatever the numbers: no oracle needed.
// RC_PARAMS in the environment overrides the seed below; RapidCheck prints what it uses.

#include "properties/systems.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <utility>
#include <vector>

/// What RapidCheck prints of a counterexample.
namespace abut::scenes {
void showValue(const Scene& scene, std::ostream& out) {
  out << scene.dimensions << "D:";
  for (std::size_t k = 0; k < scene.size(); ++k) {
    out << " {" << scene.x[k] << ", " << scene.y[k] << ", "
        << (scene.dimensions == 3 ? scene.z[k] : 0.0) << ", r " << scene.radius[k] << "}";
  }
}
}  // namespace abut::scenes

namespace abut::testing {
namespace {

[[maybe_unused]] const int fixed_seed = ::setenv("RC_PARAMS", "seed=20040101 max_success=150", 0);

std::vector<std::size_t> identity(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

/// A random order of 0 .. count - 1.
std::vector<std::size_t> any_order(std::size_t count) {
  auto order = identity(count);
  for (std::size_t left = count; left > 1; --left) {
    std::swap(order[left - 1], order[*rc::gen::inRange<std::size_t>(0, left)]);
  }
  return order;
}

/// Pairs of the library before and after a change that must not matter.
void expect_unchanged(const Scene& before, const Scene& after, double margin_before = 0.0,
                      double margin_after = 0.0) {
  for_each_algorithm(before, [&](Algorithm algorithm) {
    RC_ASSERT(pairs_of(before, algorithm, margin_before) ==
              pairs_of(after, algorithm, margin_after));
  });
}

TEST(Relations, SystemsHavePairsAndBorderlineOnes) {
  std::size_t pairs = 0, borderline = 0;
  EXPECT_TRUE(rc::check("systems are not trivial", [&] {
    const Scene scene = *any_system();
    Scene smaller = scene;
    for (double& radius : smaller.radius) radius = std::nextafter(radius, 0.0);
    const std::size_t found = oracle_pairs(scene).size();
    pairs += found;
    borderline += found - oracle_pairs(smaller).size();
  }));
  EXPECT_GT(pairs, 1000U);
  EXPECT_GT(borderline, 30U);
}

TEST(Relations, AgreeWithTheOracle) {
  EXPECT_TRUE(rc::check("pairs are those of the oracle", [] {
    const Scene scene = *any_system();
    const double margin = *rc::gen::element(0.0, 0.1, 0.25, 1.0);
    for_each_algorithm(scene, [&](Algorithm algorithm) {
      RC_ASSERT(pairs_of(scene, algorithm, margin) == oracle_pairs(scene, margin));
    });
  }));
}

TEST(Relations, AxesMayBePermuted) {
  EXPECT_TRUE(rc::check("axis permutation", [] {
    const Scene scene = *any_system();
    Scene permuted = scene;
    std::swap(permuted.x, permuted.y);
    if (scene.dimensions == 3 && *rc::gen::arbitrary<bool>()) std::swap(permuted.y, permuted.z);
    expect_unchanged(scene, permuted);
  }));
}

TEST(Relations, AxesMayBeReflected) {
  EXPECT_TRUE(rc::check("reflection", [] {
    const Scene scene = *any_system();
    Scene reflected = scene;
    for (std::vector<double>* axis : axes_of(reflected)) {
      if (!*rc::gen::arbitrary<bool>()) continue;
      for (double& x : *axis) x = -x;
    }
    expect_unchanged(scene, reflected);
  }));
}

TEST(Relations, ElementsMayBeRenumbered) {
  EXPECT_TRUE(rc::check("renumbering", [] {
    const Scene scene = *any_system();
    const auto order = any_order(scene.size());
    const Scene shuffled = part_of(scene, order);
    for_each_algorithm(scene, [&](Algorithm algorithm) {
      RC_ASSERT(renumbered(pairs_of(shuffled, algorithm), order) == pairs_of(scene, algorithm));
    });
  }));
}

TEST(Relations, PowersOfTwoScale) {
  EXPECT_TRUE(rc::check("scaling by a power of two", [] {
    const Scene scene = *any_system();
    const double factor = std::ldexp(1.0, *rc::gen::inRange(-1000, 1000));
    Scene scaled = scene;
    for (std::vector<double>* axis : axes_of(scaled)) {
      for (double& x : *axis) x *= factor;
    }
    for (double& radius : scaled.radius) radius *= factor;
    expect_unchanged(scene, scaled, 0.5, 0.5 * factor);
  }));
}

TEST(Relations, ExactTranslation) {
  EXPECT_TRUE(rc::check("translation, every addition exact", [] {
    const Scene scene = *system_on(exact_unit);
    Scene moved = scene;
    for (std::vector<double>* axis : axes_of(moved)) {
      // Sums are multiples of 1/4 below 2^50: exact.
      const auto shift = static_cast<double>(
          *rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 50), std::int64_t{1} << 50));
      for (double& x : *axis) x += shift * exact_unit;
    }
    expect_unchanged(scene, moved);
  }));
}

TEST(Relations, MarginIsHalfAMarginOnEveryRadius) {
  EXPECT_TRUE(rc::check("margin as radius", [] {
    const Scene scene = *system_on(exact_unit);
    const double margin = 2.0 * exact_unit * *rc::gen::inRange(0, 5);
    Scene grown = scene;
    for (double& radius : grown.radius) radius += 0.5 * margin;
    expect_unchanged(scene, grown, margin, 0.0);
  }));
}

/// Pairs of a union = pairs of either part + cross pairs, each of which is a system of two.
TEST(Relations, UnionOfParts) {
  EXPECT_TRUE(rc::check("union of parts", [] {
    const Scene scene = *system_on(0.1, 16);
    const auto order = any_order(scene.size());
    const auto cut = *rc::gen::inRange<std::size_t>(0, scene.size() + 1);
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(cut);
    const std::vector<std::size_t> a(order.begin(), middle), b(middle, order.end());
    for_each_algorithm(scene, [&](Algorithm algorithm) {
      PairVector sum = renumbered(pairs_of(part_of(scene, a), algorithm), a);
      const PairVector of_b = renumbered(pairs_of(part_of(scene, b), algorithm), b);
      sum.insert(sum.end(), of_b.begin(), of_b.end());
      for (const std::size_t i : a) {
        for (const std::size_t j : b) {
          const PairVector cross = pairs_of(part_of(scene, {i, j}), algorithm);
          const PairVector renamed = renumbered(cross, {i, j});
          sum.insert(sum.end(), renamed.begin(), renamed.end());
        }
      }
      std::sort(sum.begin(), sum.end());
      RC_ASSERT(sum == pairs_of(scene, algorithm));
    });
  }));
}

TEST(Relations, GrowingRadiiOnlyAddPairs) {
  EXPECT_TRUE(rc::check("growing radii", [] {
    const Scene scene = *any_system();
    Scene grown = scene;
    for (double& radius : grown.radius) radius += 0.07 * *rc::gen::inRange(0, 3);
    for_each_algorithm(scene, [&](Algorithm algorithm) {
      const PairVector few = pairs_of(scene, algorithm);
      const PairVector many = pairs_of(grown, algorithm);
      RC_ASSERT(std::includes(many.begin(), many.end(), few.begin(), few.end()));
    });
  }));
}

TEST(Relations, ADuplicateHasTheSamePartners) {
  EXPECT_TRUE(rc::check("duplicate of one element", [] {
    const Scene scene = *any_system();
    RC_PRE(scene.size() > 0U);
    const auto original = *rc::gen::inRange<std::size_t>(0, scene.size());
    auto numbers = identity(scene.size());
    numbers.push_back(original);
    const Scene doubled = part_of(scene, numbers);
    const auto copy = static_cast<ElementIndex>(scene.size());
    for_each_algorithm(scene, [&](Algorithm algorithm) {
      PairVector expected = pairs_of(scene, algorithm);
      const PairVector before = expected;
      for (const ContactPair& pair : before) {
        if (pair.first == original) expected.push_back({pair.second, copy});
        if (pair.second == original) expected.push_back({pair.first, copy});
      }
      expected.push_back({static_cast<ElementIndex>(original), copy});
      std::sort(expected.begin(), expected.end());
      RC_ASSERT(pairs_of(doubled, algorithm) == expected);
    });
  }));
}

TEST(Relations, RemovingOneRemovesItsPairsAlone) {
  EXPECT_TRUE(rc::check("one element removed", [] {
    const Scene scene = *any_system();
    RC_PRE(scene.size() > 0U);
    const auto removed = *rc::gen::inRange<std::size_t>(0, scene.size());
    auto kept = identity(scene.size());
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(removed));
    for_each_algorithm(scene, [&](Algorithm algorithm) {
      PairVector expected = pairs_of(scene, algorithm);
      std::erase_if(expected, [removed](const ContactPair& pair) {
        return pair.first == removed || pair.second == removed;
      });
      RC_ASSERT(renumbered(pairs_of(part_of(scene, kept), algorithm), kept) == expected);
    });
  }));
}

/// A stray far away changes the extent of every grid, hence the cells, and no pair.
TEST(Relations, AFarStrayChangesNothing) {
  EXPECT_TRUE(rc::check("far stray", [] {
    const Scene scene = *any_system();
    Scene with_stray = scene;
    for (std::vector<double>* axis : axes_of(with_stray)) {
      axis->push_back(*rc::gen::element(-30.0, 10.0, 25.0));
    }
    with_stray.radius.push_back(0.1);
    expect_unchanged(scene, with_stray);
  }));
}

}  // namespace
}  // namespace abut::testing
