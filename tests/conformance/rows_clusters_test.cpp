// Clusters that `rows` moves side by side, in open and in periodic domains: what is far away, or
// lies across the faces of a huge cell, changes nothing of the pairs.

#include "engine/layers/layer_scenes.hpp"
#include "support/each_result.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr std::size_t count = 21000;

/// Coordinates are multiples of this: sums with the sides of cells below are exact.
constexpr double step = 0x1p-12;
constexpr double huge = 0x1p20;

/// Spheres at random with some pairs each in a cube of this width.
constexpr double width = 30.0;

struct ImagePair {
  ContactPair pair;
  ImageShift shift;

  friend bool operator==(const ImagePair&, const ImagePair&) = default;
};

class RowsClusters : public ::testing::Test {
 protected:
  Scene cluster(const std::array<double, 3>& lower) {
    Scene scene;
    scene.dimensions = 3;
    for (std::size_t k = 0; k < count; ++k) {
      const auto coordinate = [&](double from) {
        return from + step * std::floor(random_.uniform(0.0, width) / step);
      };
      scene.x.push_back(coordinate(lower[0]));
      scene.y.push_back(coordinate(lower[1]));
      scene.z.push_back(coordinate(lower[2]));
      scene.radius.push_back(half);
    }
    return scene;
  }

  static void add(Scene& scene, const std::array<double, 3>& center) {
    scene.x.push_back(center[0]);
    scene.y.push_back(center[1]);
    scene.z.push_back(center[2]);
    scene.radius.push_back(half);
  }

  static std::vector<ImagePair> pairs_of(const Scene& scene, const Domain& domain, int threads,
                                         double margin = 0.0) {
    Options options{.algorithm = Algorithm::rows, .shifts = Shifts::stored, .threads = threads};
    options.margin = margin;
    const PairList list = find_contact_pairs(view_of(scene), domain, options);
    std::vector<ImagePair> pairs;
    for (std::size_t k = 0; k < list.size(); ++k) {
      pairs.push_back({list.pairs()[k], list.shifts().empty() ? ImageShift{} : list.shifts()[k]});
    }
    return pairs;
  }

  /// Brings coordinates below 0 in by the side of a cell and returns which of each were moved.
  static std::vector<ImageShift> wrap(Scene& scene, double side) {
    const auto wrap_one = [&](double& x) {
      if (x >= 0.0) return 0;
      x += side;
      return 1;
    };
    std::vector<ImageShift> moves;
    for (std::size_t k = 0; k < scene.x.size(); ++k) {
      moves.push_back({wrap_one(scene.x[k]), wrap_one(scene.y[k]), wrap_one(scene.z[k])});
    }
    return moves;
  }

  scenes::Random random_{211};
};

/// The eight parts of a cluster around a corner of a cell lie as far apart as they can, and ghosts
/// stand beside each of them.
TEST_F(RowsClusters, AcrossTheCornerOfAHugeCell) {
  for (const double margin : {0.0, 0.125}) {
    Scene scene = cluster({-0.5 * width, -0.25 * width, -0.75 * width});
    std::vector<ImagePair> expected = pairs_of(scene, Domain::open(), 1, margin);
    ASSERT_GT(expected.size(), count);
    const auto moves = wrap(scene, huge);
    for (auto& [pair, shift] : expected) {
      const ImageShift& first = moves[pair.first];
      const ImageShift& second = moves[pair.second];
      shift = {first.x - second.x, first.y - second.y, first.z - second.z};
    }
    for (const int threads : {1, 3}) {
      const auto found = pairs_of(scene, Domain::periodic({huge, huge, huge}), threads, margin);
      EXPECT_TRUE(found == expected) << found.size() << " and " << expected.size();
    }
  }
}

/// An element lies far out on open axes, beside periodic faces that pairs cross.
TEST_F(RowsClusters, StraysBesidePeriodicFaces) {
  const Domain slab = Domain::periodic({width, unbounded, unbounded});
  const Domain channel = Domain::periodic({width, unbounded, width});
  const Domain oblique = Domain::lattice({width, 0, 0}, {8, width, 0}, {0, 0, 1}, Axes::xy);
  for (const Domain& domain : {slab, channel, oblique}) {
    for (const double far : {1e5, 1e9, 1e15}) {
      Scene scene = cluster({0.0, 0.0, 0.0});
      const std::vector<ImagePair> expected = pairs_of(scene, domain, 1);
      ASSERT_GT(expected.size(), count);
      add(scene, {1.0, domain.is_periodic(1) ? 1.0 : far, domain.is_periodic(2) ? 1.0 : -far});
      scene.radius.back() = 0.5 * half;
      if (domain.is_periodic(1)) scene.z.back() = far;
      for (const int threads : {1, 3}) {
        EXPECT_TRUE(pairs_of(scene, domain, threads) == expected) << "stray at " << far;
      }
    }
  }
}

/// A count, and neighbor lists of both kinds, of a system with a stray.
TEST_F(RowsClusters, EachKindOfResult) {
  Scene scene = cluster({5.0, 6.0, 7.0});
  const std::size_t pairs = pairs_of(scene, Domain::open(), 1).size();
  add(scene, {1e12, -1e12, 0.0});
  expect_in_each_result(scene, pairs);
}

/// Beside 24 bytes for each record, label and share of coarse cells.
TEST_F(RowsClusters, TakeFewBytesForEachElement) {
  for (const char* const name : {"dense_stray", "clusters"}) {
    const Scene scene = scenes::scene_named(name).make(300000, 1);
    const Statistics statistics = count_contact_pairs(view_of(scene), Domain::open(),
                                                      {.algorithm = Algorithm::rows, .threads = 1});
    EXPECT_LE(statistics.working_bytes, 26 * scene.x.size() + 1048576) << name;
    EXPECT_LE(statistics.candidate_tests, 25 * scene.x.size()) << name;
  }
}

}  // namespace
}  // namespace abut::testing
