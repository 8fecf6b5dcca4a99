// Random tiles through the kernels of every level: the pairs of the plain C++ kernels, in their
// order, after as many tests, with as many undecided pairs; and those of a loop over all elements.

#include "kernels/tiles/tile_search.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

enum class Kind { own, copy, padding };

/// A tile as the engine sorts it, of made-up cells. Behind the last element stand numbers that
/// would give pairs if a kernel counted its excess lanes.
struct MadeTile {
  std::vector<float> center[3];
  std::vector<float> size[3];
  std::vector<std::uint32_t> number;
  std::vector<std::uint32_t> cell;
  std::vector<std::uint32_t> cell_begin;
  std::vector<Kind> kind;
  kernels::TileView view{};
  float margin = 0.0f;

  [[nodiscard]] std::size_t places() const { return kind.size(); }

  void add(Kind what, const std::array<float, 3>& position, const std::array<float, 3>& its_size) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      center[axis].push_back(position[axis]);
      size[axis].push_back(its_size[axis]);
    }
    kind.push_back(what);
    cell.push_back(static_cast<std::uint32_t>(cell_begin.size() - 1));
    number.push_back(static_cast<std::uint32_t>((number.size() * 7919) % 100003));
  }
};

MadeTile made_tile(int dimensions, Random& random, double per_cell, kernels::ElementShape shape) {
  MadeTile tile;
  if (random.below(2) == 0) tile.margin = 0.01f;  // else many pairs touch
  const std::int32_t k[3] = {1 + static_cast<std::int32_t>(random.below(8)),
                             1 + static_cast<std::int32_t>(random.below(4)),
                             dimensions == 3 ? 1 + static_cast<std::int32_t>(random.below(4)) : 1};
  const auto width = 0.9f / 8.0f;
  // Cells as wide as the reach asks for, or up to eight times as wide.
  const float largest = 0.5f * width / static_cast<float>(1u << random.below(4));
  const std::int32_t layers = dimensions == 3 ? k[2] + 2 : 1;
  for (std::int32_t z = 0; z < layers; ++z) {
    for (std::int32_t y = 0; y < k[1] + 2; ++y) {
      for (std::int32_t x = 0; x < k[0] + 2; ++x) {
        tile.cell_begin.push_back(static_cast<std::uint32_t>(tile.places()));
        const bool own = x >= 1 && x <= k[0] && y >= 1 && y <= k[1] &&
                         (dimensions == 2 || (z >= 1 && z <= k[2]));
        const std::size_t inhabitants = random.below(static_cast<std::size_t>(2.0 * per_cell) + 1);
        for (std::size_t e = 0; e < inhabitants; ++e) {
          const std::int32_t index[3] = {x, y, z};
          std::array<float, 3> position{};
          for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
            // On eighths of a cell, so that distances tie.
            const auto within = static_cast<float>(random.below(8)) / 8.0f;
            position[axis] = (static_cast<float>(index[axis] - 1) + within) * width;
          }
          std::array<float, 3> size{};
          for (float& length : size) {
            length = shape == kernels::ElementShape::equal_spheres
                         ? largest
                         : static_cast<float>(random.below(5)) * 0.25f * largest;
          }
          tile.add(own ? Kind::own : Kind::copy, position, size);
        }
      }
      tile.cell_begin.push_back(static_cast<std::uint32_t>(tile.places()));
      for (std::uint32_t e = 0; e < kernels::row_padding; ++e) {
        tile.add(Kind::padding, {kernels::far_away, 0.0f, 0.0f}, {});
      }
    }
  }
  tile.cell_begin.push_back(static_cast<std::uint32_t>(tile.places()));
  for (std::size_t e = 0; e < kernels::widest_vector; ++e) {
    for (auto& axis : tile.center) axis.push_back(tile.places() > 0 ? axis[0] : 0.0f);
    for (auto& axis : tile.size) axis.push_back(1.0f);
    tile.number.push_back(4000000000u);
  }
  for (int axis = 0; axis < 3; ++axis) {
    tile.view.center[axis] = tile.center[axis].data();
    tile.view.size[axis] = tile.size[axis].data();
    tile.view.cells[axis] = k[axis];
    tile.view.per_unit[axis] = 1.0f / width;
  }
  tile.view.shape = shape;
  tile.view.common_radius = largest;
  tile.view.number = tile.number.data();
  tile.view.cell = tile.cell.data();
  tile.view.cell_begin = tile.cell_begin.data();
  return tile;
}

/// Collects what a kernel finds. Undecided pairs are those of even sum, so that both answers occur.
class Found {
 public:
  explicit Found(const MadeTile& tile)
      : block_(columns * (tile.places() + kernels::widest_vector),
               std::numeric_limits<float>::quiet_NaN()),
        block_number_(tile.places() + kernels::widest_vector, 4000000001u) {
    for (std::size_t axis = 0; axis < columns; ++axis) {
      job.block[axis] = block_.data() + axis * (tile.places() + kernels::widest_vector);
    }
    job.block_number = block_number_.data();
    job.margin = tile.margin;
    job.slack = 0x1p-20f;
    job.hits = &hits_;
    job.owner = this;
    job.take = [](kernels::SearchJob& full) { static_cast<Found*>(full.owner)->take(); };
  }

  void take() {
    ++takes;
    const std::span<const std::uint32_t> undecided(hits_.undecided, hits_.undecided_count);
    EXPECT_TRUE(std::is_sorted(undecided.begin(), undecided.end(), std::less_equal<>{}));
    undecided_count += undecided.size();
    for (std::size_t k = 0; k < hits_.found; ++k) {
      const std::uint32_t a = hits_.element[k];
      const std::uint32_t b = hits_.partner[k];
      const bool left_open = std::binary_search(undecided.begin(), undecided.end(), k);
      if (!left_open || (a + b) % 2 == 0) pairs.push_back({std::min(a, b), std::max(a, b)});
    }
    hits_.found = 0;
    hits_.undecided_count = 0;
  }

  kernels::SearchJob job{};
  std::vector<ContactPair> pairs;
  std::uint64_t undecided_count = 0;
  int takes = 0;

 private:
  static constexpr std::size_t columns = std::extent_v<decltype(kernels::SearchJob::block)>;

  kernels::HitBuffer hits_;
  std::vector<float> block_;
  std::vector<std::uint32_t> block_number_;
};

constexpr float slack = 0x1p-20f;

/// Whether the elements are within a reach that is larger by `extra`.
bool reach(const MadeTile& tile, int dimensions, std::size_t i, std::size_t j, float extra,
           bool or_touch) {
  const float margin = tile.margin;
  if (tile.view.shape == kernels::ElementShape::boxes) {
    bool result = true;
    for (int axis = 0; axis < dimensions; ++axis) {
      const float behind = tile.center[axis][i] - tile.center[axis][j];
      const float most = tile.size[axis][j] + (margin + extra);
      const float least = -(tile.size[axis][i] + (margin + extra));
      result = result &&
               (or_touch ? behind <= most && behind >= least : behind < most && behind > least);
    }
    return result;
  }
  float square = 0.0f;
  for (int axis = 0; axis < dimensions; ++axis) {
    const float difference = tile.center[axis][i] - tile.center[axis][j];
    square += difference * difference;
  }
  const float most = std::max(tile.size[0][i] + tile.size[0][j] + margin + extra, 0.0f);
  return or_touch ? square <= most * most : square < most * most;
}

/// Pairs of a loop over all elements, in the same single precision.
std::vector<ContactPair> by_all_pairs(const MadeTile& tile, int dimensions) {
  std::vector<ContactPair> pairs;
  for (std::size_t i = 0; i < tile.places(); ++i) {
    for (std::size_t j = i + 1; j < tile.places(); ++j) {
      if (tile.kind[i] != Kind::own && tile.kind[j] != Kind::own) continue;
      if (tile.kind[i] == Kind::padding || tile.kind[j] == Kind::padding) continue;
      const std::uint32_t a = tile.number[i];
      const std::uint32_t b = tile.number[j];
      if (!reach(tile, dimensions, i, j, slack, true)) continue;
      if (!reach(tile, dimensions, i, j, -slack, false) && (a + b) % 2 != 0) continue;
      pairs.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

struct Case {
  int dimensions;
  kernels::ElementShape shape;
};

class TileKernelsTest : public ::testing::TestWithParam<Case> {};

TEST_P(TileKernelsTest, SearchFindsTheSameInTheSameOrder) {
  const auto [dimensions, shape] = GetParam();
  Random random(31);
  std::size_t found = 0;
  std::size_t undecided_count = 0;
  int takes = 0;
  for (int k = 0; k < 150; ++k) {
    // Empty rows, runs of about a vector, crowds.
    constexpr std::array<double, 5> densities{0.3, 1.0, 1.5, 3.0, 12.0};
    const MadeTile tile =
        made_tile(dimensions, random, densities[static_cast<std::size_t>(k % 5)], shape);
    Found plain(tile);
    const kernels::Layers all = kernels::all_layers(tile.view, dimensions);
    kernels::tile_kernels(Simd::scalar).search(tile.view, all, plain.job, dimensions);
    plain.take();
    found += plain.pairs.size();
    undecided_count += plain.undecided_count;
    takes += plain.takes;
    std::vector<ContactPair> sorted = plain.pairs;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted, by_all_pairs(tile, dimensions)) << "tile " << k;
    for (const Simd level : testing::simd_levels_here()) {
      Found other(tile);
      kernels::tile_kernels(level).search(tile.view, all, other.job, dimensions);
      other.take();
      Found by_layers(tile);
      for (std::int32_t layer = all.begin; layer < all.end; ++layer) {
        kernels::tile_kernels(level).search(tile.view, {layer, layer + 1}, by_layers.job,
                                            dimensions);
      }
      by_layers.take();
      for (const Found* one : {&other, &by_layers}) {
        ASSERT_EQ(one->pairs, plain.pairs) << name_of(level) << ", tile " << k;
        EXPECT_EQ(one->job.candidate_tests, plain.job.candidate_tests) << name_of(level);
        EXPECT_EQ(one->undecided_count, plain.undecided_count) << name_of(level);
      }
    }
  }
  EXPECT_GT(takes, 150) << "the room is full at times";
  EXPECT_GT(found, 4000U);
  EXPECT_GT(undecided_count, 200U);
}

TEST_P(TileKernelsTest, CoarseElementsMeetTheSameInTheSameOrder) {
  const auto [dimensions, shape] = GetParam();
  Random random(32);
  std::size_t found = 0;
  for (int k = 0; k < 60; ++k) {
    const MadeTile tile = made_tile(dimensions, random, 3.0, shape);
    std::vector<kernels::Run> runs;
    for (std::uint32_t begin = 0; begin < tile.places();) {
      const auto end = static_cast<std::uint32_t>(
          std::min<std::size_t>(begin + 1 + random.below(20), tile.places()));
      if (random.below(3) != 0) runs.push_back({begin, end});
      begin = end + static_cast<std::uint32_t>(random.below(3));
    }
    kernels::CoarseElement coarse{};
    for (int axis = 0; axis < dimensions; ++axis) {
      coarse.center[axis] = static_cast<float>(random.uniform(-1.0, 1.0));
    }
    for (float& length : coarse.size) length = static_cast<float>(random.uniform(0.2, 1.5));
    coarse.slack = 0x1p-12f;
    coarse.number = 200000;
    Found plain(tile);
    kernels::tile_kernels(Simd::scalar).test_coarse(tile.view, plain.job, dimensions, coarse, runs);
    plain.take();
    found += plain.pairs.size();
    std::uint64_t tests = 0;
    for (const kernels::Run& run : runs) tests += run.end - run.begin;
    EXPECT_EQ(plain.job.candidate_tests, tests);
    for (const Simd level : testing::simd_levels_here()) {
      Found other(tile);
      kernels::tile_kernels(level).test_coarse(tile.view, other.job, dimensions, coarse, runs);
      other.take();
      ASSERT_EQ(other.pairs, plain.pairs) << name_of(level) << ", tile " << k;
      EXPECT_EQ(other.job.candidate_tests, tests);
      EXPECT_EQ(other.undecided_count, plain.undecided_count);
    }
  }
  EXPECT_GT(found, 300U);
}

TEST(PairUp, PutsTheSmallerNumberFirst) {
  scenes::Random random(33);
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 100U}) {
    std::vector<std::uint32_t> element(count);
    std::vector<std::uint32_t> partner(count);
    std::vector<ContactPair> expected(count);
    for (std::size_t k = 0; k < count; ++k) {
      element[k] = static_cast<std::uint32_t>(random.below(1ull << 32));
      partner[k] = static_cast<std::uint32_t>(random.below(1ull << 32));
      expected[k] = {std::min(element[k], partner[k]), std::max(element[k], partner[k])};
    }
    expected.push_back({1, 2});
    for (const Simd level : testing::simd_levels_here()) {
      std::vector<ContactPair> pairs(count + 1, ContactPair{1, 2});
      kernels::tile_kernels(level).pair_up(element.data(), partner.data(), count, pairs.data());
      EXPECT_EQ(pairs, expected) << name_of(level) << ", nothing behind the last is touched";
    }
  }
}

std::string name_of_case(const ::testing::TestParamInfo<Case>& parameter) {
  static constexpr const char* names[] = {"EqualSpheres", "Spheres", "Boxes"};
  return std::to_string(parameter.param.dimensions) + "D" +
         names[static_cast<std::size_t>(parameter.param.shape)];
}

INSTANTIATE_TEST_SUITE_P(Kinds, TileKernelsTest,
                         ::testing::Values(Case{2, kernels::ElementShape::equal_spheres},
                                           Case{2, kernels::ElementShape::spheres},
                                           Case{2, kernels::ElementShape::boxes},
                                           Case{3, kernels::ElementShape::equal_spheres},
                                           Case{3, kernels::ElementShape::spheres},
                                           Case{3, kernels::ElementShape::boxes}),
                         name_of_case);

}  // namespace
}  // namespace abut::testing
