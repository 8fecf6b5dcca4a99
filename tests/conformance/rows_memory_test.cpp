// The law of memory of `rows` that the registry states, on every scene: without the pairs, and
// without the elements themselves, which every algorithm reads from one packed array.

#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

constexpr std::uint64_t integer_bytes = 4;

/// Each worker has the arrays of one tile; which tiles it takes is chance.
std::uint64_t allowed_bytes(const scenes::Scene& scene, int threads) {
  const auto count = static_cast<std::uint64_t>(scene.size());
  const auto numbers = static_cast<std::uint64_t>(scene.dimensions + 1);
  const auto further_threads = static_cast<std::uint64_t>(threads - 1);
  const std::uint64_t integers = 32 * count + 32768 + 131072 * further_threads;
  return count * numbers * sizeof(double) + integer_bytes * integers;
}

TEST(RowsMemory, TheRegistryStatesTheLaw) {
  EXPECT_EQ(info(Algorithm::rows).memory, "at most 32 N + 32768, and 131072 a further thread");
}

class RowsMemory : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(RowsMemory, KeepsTheLaw) {
  for (const std::size_t count : {1U, 65U, 1000U, 3000U, 10000U, 30000U, 100000U}) {
    // (N^2 - N) / 2 pairs
    if (GetParam().name == "coincident" && count > 10000U) continue;
    const scenes::Scene scene = GetParam().make(count, 1);
    for (const int threads : {1, 2, 16}) {
      const Statistics statistics = count_contact_pairs(
          view_of(scene), Domain::open(), {.algorithm = Algorithm::rows, .threads = threads});
      EXPECT_LE(statistics.working_bytes, allowed_bytes(scene, threads))
          << count << " elements, " << threads << " threads";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RowsMemory,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
