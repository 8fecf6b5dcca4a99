#include "engine/layers/layer_run.hpp"

#include "support/rows_variants.hpp"
#include "support/sort_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {

template <int Dim>
LayerRun layer_run(const KeptPairs& sink, bool in_layers, const engine::Workspace<Dim>& workspace,
                   const base::DetectionContext& context) {
  return {sink.pairs(),
          in_layers,
          workspace.last.in_plane > 0,
          workspace.last.clusters_moved > 0,
          workspace.last.beside_layers,
          context.candidate_tests,
          context.exact_decisions,
          workspace.last.levels_of_sizes};
}

template <int Dim>
LayerRun run_rows(const Spheres<Dim>& spheres, const engine::RowsSettings& settings) {
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  engine::rows<Dim>({spheres, {}}, bounds_of<Dim>(spheres), settings, workspace, sink, context);
  // What was never sorted has no largest layer.
  return layer_run<Dim>(sink, workspace.layer_records.largest_layer() > 0, workspace, context);
}

template <int Dim>
LayerRun run_in_place(const Spheres<Dim>& spheres, Layout layout,
                      const engine::RowsSettings& settings) {
  const LaidOut<Dim> laid_out(spheres, layout);
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  const bool in_layers = engine::rows_in_place<Dim>(laid_out.columns(), bounds_of<Dim>(spheres),
                                                    settings, workspace, sink, context);
  return layer_run<Dim>(sink, in_layers, workspace, context);
}

void expect_same(const LayerRun& first, const LayerRun& other) {
  EXPECT_TRUE(std::ranges::equal(first.pairs, other.pairs));
  EXPECT_EQ(first.coarse, other.coarse);
  EXPECT_EQ(first.candidate_tests, other.candidate_tests);
  EXPECT_EQ(first.exact_decisions, other.exact_decisions);
}

void expect_same_everywhere(
    const LayerRun& first, engine::RowsSettings settings,
    const std::function<LayerRun(const engine::RowsSettings&)>& run,
    const std::function<LayerRun(std::size_t, const engine::RowsSettings&)>& in_place) {
  std::size_t turn = 0;
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) +
                   " workers, turn " + std::to_string(++turn));
      settings.simd = level;
      settings.workers = workers;
      settings.wide_vectors =
          turn % 2 == 0 ? kernels::WideVectors::whole : kernels::WideVectors::in_halves;
      expect_same(first, run(settings));
      const LayerRun where_they_lie = in_place(turn, settings);
      if (where_they_lie.in_layers) {
        expect_same(first, where_they_lie);
      } else {
        EXPECT_TRUE(where_they_lie.pairs.empty());
      }
    }
  }
}

template <int Dim>
PairVector directly_checked(const Spheres<Dim>& spheres, double margin) {
  const grid::Bounds<Dim> bounds = bounds_of<Dim>(spheres);
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < Dim; ++axis) {
    if (bounds.upper[axis] - bounds.lower[axis] > bounds.upper[longest] - bounds.lower[longest]) {
      longest = axis;
    }
  }
  const auto along = [&](std::uint32_t k) { return spheres[k].center[longest]; };
  std::vector<std::uint32_t> order(spheres.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return along(a) < along(b); });
  const double generous = 1.0001 * (2.0 * bounds.largest_radius + margin);
  std::uint64_t exact_decisions = 0;
  PairVector pairs;
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::size_t n = k + 1; n < order.size(); ++n) {
      if (along(order[n]) - along(order[k]) > generous) break;
      if (!exact::within_reach(spheres[order[k]], spheres[order[n]], margin, exact_decisions)) {
        continue;
      }
      pairs.push_back({std::min(order[k], order[n]), std::max(order[k], order[n])});
    }
  }
  sort_pairs(pairs);
  return pairs;
}

template <int Dim>
void expect_right_in_layers(const Spheres<Dim>& spheres, double margin, Way way,
                            const engine::LayerLimits& limits) {
  engine::RowsSettings settings{margin, 1, Simd::scalar, limits};
  const LayerRun first = run_rows<Dim>(spheres, settings);
  EXPECT_EQ(first.in_layers, way == Way::layers || way == Way::moved);
  EXPECT_EQ(first.in_plane, way == Way::plane);
  EXPECT_EQ(first.are_moved, way == Way::moved);
  EXPECT_TRUE(same_pairs(directly_checked<Dim>(spheres, margin), first.pairs));
  expect_same_everywhere(
      first, settings, [&](const auto& its) { return run_rows<Dim>(spheres, its); },
      [&](std::size_t turn, const auto& its) {
        const Layout layout = all_layouts[(spheres.size() + turn) % all_layouts.size()];
        return run_in_place<Dim>(spheres, layout, its);
      });
}

template LayerRun layer_run<2>(const KeptPairs&, bool, const engine::Workspace<2>&,
                               const base::DetectionContext&);
template LayerRun layer_run<3>(const KeptPairs&, bool, const engine::Workspace<3>&,
                               const base::DetectionContext&);
template LayerRun run_rows<2>(const Spheres<2>&, const engine::RowsSettings&);
template LayerRun run_rows<3>(const Spheres<3>&, const engine::RowsSettings&);
template LayerRun run_in_place<2>(const Spheres<2>&, Layout, const engine::RowsSettings&);
template LayerRun run_in_place<3>(const Spheres<3>&, Layout, const engine::RowsSettings&);
template PairVector directly_checked<2>(const Spheres<2>&, double);
template PairVector directly_checked<3>(const Spheres<3>&, double);
template void expect_right_in_layers<2>(const Spheres<2>&, double, Way, const engine::LayerLimits&);
template void expect_right_in_layers<3>(const Spheres<3>&, double, Way, const engine::LayerLimits&);

}  // namespace abut::testing
