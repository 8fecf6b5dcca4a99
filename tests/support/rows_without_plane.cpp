#include "support/rows_without_plane.hpp"

#include "base/float_environment.hpp"
#include "elements/gathered_elements.hpp"
#include "engine/rows.hpp"
#include "support/kept_pairs.hpp"

namespace abut::testing {
namespace {

template <int Dim>
RowsWithoutPlane rows_in(const ElementView& elements, const engine::RowsSettings& settings) {
  base::DetectionContext context;
  elements::GatheredElements<Dim> gathered(context.memory);
  elements::gather<Dim>(elements, {}, gathered, context);
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  engine::rows<Dim>(gathered.elements(), gathered.bounds, settings, workspace, sink, context);
  return {sink.pairs(), context.candidate_tests};
}

}  // namespace

std::size_t most_in_plane() {
  return engine::PlaneLimits{}.most_spheres;
}

RowsWithoutPlane rows_without_plane(const ElementView& elements, double margin, Simd simd,
                                    std::size_t workers) {
  const base::FloatEnvironment environment;
  engine::RowsSettings settings{margin, workers, simd};
  settings.layers.plane = engine::no_plane;
  return elements.dimensions() == 2 ? rows_in<2>(elements, settings)
                                    : rows_in<3>(elements, settings);
}

}  // namespace abut::testing
