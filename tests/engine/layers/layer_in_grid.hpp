#pragma once

#include "engine/deciders/box_decider.hpp"
#include "engine/deciders/sphere_decider.hpp"
#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_search.hpp"
#include "kernels/tie_kernels.hpp"

#include <cstddef>
#include <span>

namespace abut::testing {

/// What a search takes, for a set that is searched in layers whatever suits it.
template <int Dim>
engine::SearchInput<Dim> search_input(const exact::Elements<Dim>& elements,
                                      const engine::ExactDecider& decider,
                                      const engine::RowsSettings& settings, KeptPairs& sink,
                                      base::DetectionContext& context) {
  const kernels::SphereParts spheres(kernels::strided_spheres(elements.spheres));
  return {elements,
          engine::LayerSpheres<Dim>(spheres).standing_for(kernels::strided_boxes(elements.boxes)),
          {},
          decider,
          settings.margin,
          0.0,
          kernels::tile_kernels(settings.simd),
          kernels::element_kernels(settings.simd),
          kernels::layer_kernels(settings.simd),
          kernels::plane_kernels(settings.simd),
          settings.wide_vectors,
          settings.layers,
          sink,
          context.progress};
}

template <int Dim>
LayerRun run_in_grid(const engine::SearchInput<Dim>& input, const engine::LayerGrid<Dim>& grid,
                     std::size_t workers, const KeptPairs& sink, base::DetectionContext& context) {
  engine::Workspace<Dim> workspace(context.memory);
  workspace.expect_workers(workers);
  for (const auto& worker : workspace.workers) worker->start(input);
  input.sink.expect_workers(workers);
  engine::SearchSet<Dim> set;
  set.locals = engine::Numbers(input.elements.size());
  EXPECT_GT(engine::LayerSearch<Dim>(input, workspace, workers, context).search(set, grid, 0), 0U);
  for (const auto& worker : workspace.workers) {
    worker->hand_over();
    context.candidate_tests += worker->candidate_tests();
    context.exact_decisions += worker->exact_decisions();
  }
  return layer_run<Dim>(sink, true, workspace, context);
}

/// The pairs of spheres in the layers of a grid.
template <int Dim>
LayerRun run_in_grid(const Spheres<Dim>& spheres, const engine::LayerGrid<Dim>& grid,
                     const engine::RowsSettings& settings) {
  base::DetectionContext context;
  KeptPairs sink;
  const engine::SphereDecider<Dim> decider(kernels::strided_spheres(std::span(spheres)),
                                           settings.margin, kernels::tie_kernels(settings.simd));
  const auto input = search_input<Dim>({spheres, {}}, decider, settings, sink, context);
  return run_in_grid<Dim>(input, grid, settings.workers, sink, context);
}

/// The same of boxes.
template <int Dim>
LayerRun run_in_grid(const Boxes<Dim>& boxes, engine::LayerGrid<Dim> grid,
                     const engine::RowsSettings& settings) {
  base::DetectionContext context;
  KeptPairs sink;
  const Spheres<Dim> spheres = stand_ins<Dim>(boxes);
  const engine::BoxDecider<Dim> decider(kernels::strided_boxes(std::span(boxes)), settings.margin);
  grid.hold_boxes();
  const auto input = search_input<Dim>({spheres, boxes}, decider, settings, sink, context);
  return run_in_grid<Dim>(input, grid, settings.workers, sink, context);
}

}  // namespace abut::testing
