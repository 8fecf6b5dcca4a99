// Random tiles through the kernels of every level: the pairs of the plain C++ kernels, in their
// order, after as many tests and exact decisions; and those of a loop over all elements.

#include "kernels/tile_search.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace abut::kernels {
namespace {

using scenes::Random;

/// A tile as the engine sorts it, of made-up cells. Behind the last element stand numbers that
/// would give pairs if a kernel counted its excess lanes.
struct MadeTile {
  std::vector<float> center[3];
  std::vector<float> radius;
  std::vector<std::uint32_t> number;
  std::vector<std::uint32_t> cell_begin;
  std::vector<bool> own;
  TileView view{};

  [[nodiscard]] std::size_t size() const { return own.size(); }
};

MadeTile made_tile(int dimensions, Random& random, double per_cell, bool equal_radii) {
  MadeTile tile;
  const std::int32_t k[3] = {1 + static_cast<std::int32_t>(random.below(8)),
                             1 + static_cast<std::int32_t>(random.below(4)),
                             dimensions == 3 ? 1 + static_cast<std::int32_t>(random.below(4)) : 1};
  const auto width = 0.9f / 8.0f;
  const std::int32_t layers = dimensions == 3 ? k[2] + 2 : 1;
  for (std::int32_t z = 0; z < layers; ++z) {
    for (std::int32_t y = 0; y < k[1] + 2; ++y) {
      for (std::int32_t x = 0; x < k[0] + 2; ++x) {
        tile.cell_begin.push_back(static_cast<std::uint32_t>(tile.own.size()));
        const bool own = x >= 1 && x <= k[0] && y >= 1 && y <= k[1] &&
                         (dimensions == 2 || (z >= 1 && z <= k[2]));
        const std::size_t inhabitants = random.below(static_cast<std::size_t>(2.0 * per_cell) + 1);
        for (std::size_t e = 0; e < inhabitants; ++e) {
          const std::int32_t index[3] = {x, y, z};
          for (int axis = 0; axis < 3; ++axis) {
            // On eighths of a cell, so that distances tie.
            const auto within = static_cast<float>(random.below(8)) / 8.0f;
            tile.center[axis].push_back(
                axis < dimensions ? (static_cast<float>(index[axis] - 1) + within) * width : 0.0f);
          }
          tile.radius.push_back(equal_radii ? 0.5f * width
                                            : static_cast<float>(random.below(5)) * 0.125f * width);
          tile.own.push_back(own);
        }
      }
    }
  }
  tile.cell_begin.push_back(static_cast<std::uint32_t>(tile.own.size()));
  for (std::size_t e = 0; e < tile.size(); ++e) {
    tile.number.push_back(static_cast<std::uint32_t>((e * 7919) % 100003));
  }
  for (std::size_t e = 0; e < widest_vector; ++e) {
    for (auto& axis : tile.center) axis.push_back(tile.size() > 0 ? axis[0] : 0.0f);
    tile.radius.push_back(1.0f);
    tile.number.push_back(4000000000u);
  }
  for (int axis = 0; axis < 3; ++axis) {
    tile.view.center[axis] = tile.center[axis].data();
    tile.view.cells[axis] = k[axis];
  }
  tile.view.radius = tile.radius.data();
  tile.view.common_radius = equal_radii ? 0.5f * width : -1.0f;
  tile.view.number = tile.number.data();
  tile.view.cell_begin = tile.cell_begin.data();
  return tile;
}

/// Collects what a kernel finds. Undecided pairs are those of even sum, so that both answers occur.
class Found {
 public:
  explicit Found(const MadeTile& tile, bool few_hits, std::size_t capacity)
      : block_(4 * (tile.size() + 2 * widest_vector), std::numeric_limits<float>::quiet_NaN()),
        block_number_(tile.size() + 2 * widest_vector, 4000000001u),
        room_(capacity) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
      job.block[axis] = block_.data() + axis * (tile.size() + 2 * widest_vector);
    }
    job.block_number = block_number_.data();
    job.margin = 0.01f;
    job.slack = 0x1p-20f;
    job.few_hits = few_hits;
    job.pairs = room_.data();
    job.capacity = room_.size();
    job.owner = this;
    job.flush = [](SearchJob& full) { static_cast<Found*>(full.owner)->take(); };
    job.decide = [](SearchJob& asking, std::uint32_t first, std::uint32_t second) {
      ++static_cast<Found*>(asking.owner)->decisions;
      return (first + second) % 2 == 0;
    };
  }

  void take() {
    pairs.insert(pairs.end(), job.pairs, job.pairs + job.filled);
    job.filled = 0;
  }

  SearchJob job{};
  std::vector<ContactPair> pairs;
  std::uint64_t decisions = 0;

 private:
  std::vector<float> block_;
  std::vector<std::uint32_t> block_number_;
  std::vector<ContactPair> room_;
};

/// Pairs of a loop over all elements, in the same single precision.
std::vector<ContactPair> by_all_pairs(const MadeTile& tile, int dimensions) {
  std::vector<ContactPair> pairs;
  for (std::size_t i = 0; i < tile.size(); ++i) {
    for (std::size_t j = i + 1; j < tile.size(); ++j) {
      if (!tile.own[i] && !tile.own[j]) continue;
      float square = 0.0f;
      for (int axis = 0; axis < dimensions; ++axis) {
        const float difference = tile.center[axis][i] - tile.center[axis][j];
        square += difference * difference;
      }
      const float reach = tile.radius[i] + tile.radius[j] + 0.01f;
      const float outer = reach + 0x1p-20f;
      const float inner = std::max(reach - 0x1p-20f, 0.0f);
      const std::uint32_t a = tile.number[i];
      const std::uint32_t b = tile.number[j];
      if (square > outer * outer) continue;
      if (square >= inner * inner && (a + b) % 2 != 0) continue;
      pairs.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

struct Kind {
  int dimensions;
  bool equal_radii;
};

class TileKernelsTest : public ::testing::TestWithParam<Kind> {};

TEST_P(TileKernelsTest, SearchFindsTheSameInTheSameOrder) {
  const auto [dimensions, equal_radii] = GetParam();
  Random random(31);
  std::size_t found = 0;
  for (int k = 0; k < 60; ++k) {
    const MadeTile tile = made_tile(dimensions, random, k % 5 == 0 ? 12.0 : 1.5, equal_radii);
    const std::size_t capacity = k % 2 == 0 ? 512 : 2 * widest_vector + 1;
    Found plain(tile, false, capacity);
    tile_kernels(Simd::scalar).search(tile.view, plain.job, dimensions);
    plain.take();
    found += plain.pairs.size();
    std::vector<ContactPair> sorted = plain.pairs;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted, by_all_pairs(tile, dimensions)) << "tile " << k;
    for (const Simd level : testing::simd_levels_here()) {
      for (const bool few_hits : {false, true}) {
        Found other(tile, few_hits, capacity);
        tile_kernels(level).search(tile.view, other.job, dimensions);
        other.take();
        ASSERT_EQ(other.pairs, plain.pairs) << name_of(level) << ", tile " << k;
        EXPECT_EQ(other.job.candidate_tests, plain.job.candidate_tests) << name_of(level);
        EXPECT_EQ(other.decisions, plain.decisions) << name_of(level);
      }
    }
  }
  EXPECT_GT(found, 5000U);
}

TEST_P(TileKernelsTest, VisitorsMeetTheSameInTheSameOrder) {
  const auto [dimensions, equal_radii] = GetParam();
  Random random(32);
  std::size_t found = 0;
  for (int k = 0; k < 60; ++k) {
    const MadeTile tile = made_tile(dimensions, random, 3.0, equal_radii);
    std::vector<kernels::Run> runs;
    for (std::uint32_t begin = 0; begin < tile.size();) {
      const auto end = static_cast<std::uint32_t>(
          std::min<std::size_t>(begin + 1 + random.below(20), tile.size()));
      if (random.below(3) != 0) runs.push_back({begin, end});
      begin = end + static_cast<std::uint32_t>(random.below(3));
    }
    Visitor visitor{};
    for (int axis = 0; axis < dimensions; ++axis) {
      visitor.center[axis] = static_cast<float>(random.uniform(-1.0, 1.0));
    }
    visitor.radius = static_cast<float>(random.uniform(0.2, 1.5));
    visitor.slack = 0x1p-12f;
    visitor.number = 200000;
    Found plain(tile, false, 512);
    tile_kernels(Simd::scalar).visit(tile.view, plain.job, dimensions, visitor, runs);
    plain.take();
    found += plain.pairs.size();
    std::uint64_t tests = 0;
    for (const kernels::Run& run : runs) tests += run.end - run.begin;
    EXPECT_EQ(plain.job.candidate_tests, tests);
    for (const Simd level : testing::simd_levels_here()) {
      Found other(tile, k % 2 == 0, 512);
      tile_kernels(level).visit(tile.view, other.job, dimensions, visitor, runs);
      other.take();
      ASSERT_EQ(other.pairs, plain.pairs) << name_of(level) << ", tile " << k;
      EXPECT_EQ(other.job.candidate_tests, tests);
      EXPECT_EQ(other.decisions, plain.decisions);
    }
  }
  EXPECT_GT(found, 500U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, TileKernelsTest,
                         ::testing::Values(Kind{2, true}, Kind{2, false}, Kind{3, true},
                                           Kind{3, false}),
                         [](const auto& parameter) {
                           return std::to_string(parameter.param.dimensions) +
                                  (parameter.param.equal_radii ? "DEqualRadii" : "DAllRadii");
                         });

}  // namespace
}  // namespace abut::kernels
