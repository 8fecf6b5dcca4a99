// Every algorithm x scene (hence dimension) x float / double x seed x margin, against the oracle.
// The list of algorithms and that of scenes are those of the registries.

#include "support/algorithm_list.hpp"
#include "support/oracle.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace abut::testing {
namespace {

constexpr std::array<std::uint64_t, 2> seeds{1, 20040101};

/// Scenes whose grid has far more cells than elements: heads for all of them may be refused.
constexpr std::array<std::string_view, 8> wide_scenes{"crowds",   "sparse",          "dense_stray",
                                                      "clusters", "clusters_100",    "clusters_30",
                                                      "shell",    "two_far_clusters"};

/// Scenes made to be undecidable in floating point.
constexpr std::array<std::string_view, 9> borderline_scenes{"pack_1",
                                                            "pack_4",
                                                            "at_reach_2d",
                                                            "at_reach",
                                                            "sph_lattice",
                                                            "touching_cubic",
                                                            "touching_fcc",
                                                            "touching_cubic_shuffled",
                                                            "touching_fcc_shuffled"};

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::size_t count_for(const scenes::SceneInfo& scene) {
  return scene.name == "coincident" ? 150 : 1200;
}

/// The list, or nothing where the algorithm may refuse the grid and says what would do.
std::optional<PairList> find_unless_refused(const ElementView& elements, const Options& options,
                                            bool may_refuse) {
  try {
    return find_contact_pairs(elements, Domain::open(), options);
  } catch (const Error& error) {
    const bool advised = std::string_view(error.what()).find("use rows") != std::string::npos;
    const bool grid_free = options.algorithm == Algorithm::automatic ||
                           options.algorithm == Algorithm::sorting_array ||
                           options.algorithm == Algorithm::direct_check;
    EXPECT_TRUE(may_refuse && !grid_free && advised && error.code() == ErrorCode::limit_exceeded)
        << error.what();
    return std::nullopt;
  }
}

void expect_sound(const Statistics& statistics, const PairList& list, const ElementView& elements,
                  Algorithm asked) {
  EXPECT_EQ(statistics.contact_pairs, list.size());
  EXPECT_EQ(statistics.elements, elements.size());
  EXPECT_EQ(statistics.dimensions, elements.dimensions());
  EXPECT_GE(statistics.candidate_tests, list.size());
  EXPECT_LE(statistics.exact_decisions, statistics.candidate_tests);
  if (asked != Algorithm::automatic) {
    EXPECT_EQ(statistics.algorithm, asked);
  }
  if (statistics.algorithm == Algorithm::munjiza_nbs) {
    // Work follows the elements, not the cells: row + 2 cells in 2D, layer + 2 rows + 5 cells.
    const std::uint64_t most = elements.dimensions() == 2 ? 3 : 8;
    EXPECT_LE(statistics.list_insertions, most * elements.size());
  }
}

class Matrix : public ::testing::TestWithParam<scenes::SceneInfo> {
 protected:
  /// Returns how many decisions needed the exact path, over all algorithms.
  std::uint64_t check(const ElementView& elements, const scenes::Scene& scene, double margin) {
    const PairVector expected = oracle_pairs(scene, margin);
    std::uint64_t exact_decisions = 0;
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      SCOPED_TRACE(std::string(name_of(algorithm)) + ", margin " + std::to_string(margin));
      const auto found = find_unless_refused(elements, {.algorithm = algorithm, .margin = margin},
                                             contains(wide_scenes, GetParam().name));
      if (!found) continue;
      EXPECT_TRUE(same_canonical_pairs(expected, found->pairs()));
      expect_sound(found->statistics(), *found, elements, algorithm);
      exact_decisions += found->statistics().exact_decisions;
    }
    return exact_decisions;
  }
};

TEST_P(Matrix, Float64) {
  for (const std::uint64_t seed : seeds) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const scenes::Scene scene = GetParam().make(count_for(GetParam()), seed);
    const std::uint64_t exact_decisions = check(view_of(scene), scene, 0.0);
    if (contains(borderline_scenes, GetParam().name)) {
      EXPECT_GT(exact_decisions, 0U);
    }
    check(view_of(scene), scene, 0.3 * scene.radius[0]);
    check(view_of(scene), scene, 0x1p-1074);
  }
}

TEST_P(Matrix, Float32) {
  for (const std::uint64_t seed : seeds) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Float32Scene scene(GetParam().make(count_for(GetParam()), seed));
    check(scene.view(), scene.widened, 0.0);
    check(scene.view(), scene.widened, 0.3 * scene.widened.radius[0]);
  }
}

TEST_P(Matrix, AllFormsAgree) {
  const scenes::Scene scene = GetParam().make(count_for(GetParam()), 7);
  const ElementView elements = view_of(scene);
  for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    Options options{.algorithm = algorithm};
    const bool may_refuse = contains(wide_scenes, GetParam().name);
    const auto canonical = find_unless_refused(elements, options, may_refuse);
    if (!canonical) continue;

    options.order = Order::as_found;
    const PairList as_found = find_contact_pairs(elements, Domain::open(), options);
    EXPECT_TRUE(same_pairs(canonical->pairs(), as_found.pairs()));
    const PairList again = find_contact_pairs(elements, Domain::open(), options);
    EXPECT_TRUE(std::ranges::equal(as_found.pairs(), again.pairs()));

    PairVector visited;
    const Statistics visit = for_each_contact_pair(
        elements, Domain::open(), options, [&visited](ContactPair p) { visited.push_back(p); });
    EXPECT_TRUE(std::ranges::equal(as_found.pairs(), visited));
    const Statistics count = count_contact_pairs(elements, Domain::open(), options);
    for (const Statistics& statistics : {visit, count}) {
      expect_sound(statistics, as_found, elements, algorithm);
      EXPECT_EQ(statistics.candidate_tests, as_found.statistics().candidate_tests);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Matrix,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
