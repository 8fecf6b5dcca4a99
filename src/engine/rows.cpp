#include "engine/rows.hpp"

#include "engine/group_search.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

/// Differences and sums of larger numbers might overflow; such systems are mapped at a smaller
/// scale. What the scaling rounds away is far below the smallest cell.
constexpr double largest_unscaled = 0x1p960;
constexpr double scale_down = 0x1p-128;

template <int Dim>
double largest_number(const grid::Bounds<Dim>& bounds, double margin) {
  double largest = std::max(bounds.largest_radius, margin);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis])});
  }
  return largest;
}

template <int Dim>
base::Array<base::Sphere<Dim>> scaled(std::span<const base::Sphere<Dim>> spheres,
                                      base::MemoryMeter& memory) {
  auto result = base::make_array_for_overwrite<base::Sphere<Dim>>(memory, spheres.size());
  std::transform(spheres.begin(), spheres.end(), result.begin(), [](base::Sphere<Dim> sphere) {
    for (double& x : sphere.center) x *= scale_down;
    sphere.radius *= scale_down;
    return sphere;
  });
  return result;
}

template <int Dim>
grid::Bounds<Dim> bounds_of(std::span<const base::Sphere<Dim>> spheres) {
  grid::Bounds<Dim> bounds;
  for (const base::Sphere<Dim>& sphere : spheres) {
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
  }
  return bounds;
}

template <int Dim>
void search(const Task<Dim>& task, const grid::Bounds<Dim>& bounds, std::size_t workers,
            Workspace<Dim>& workspace, base::DetectionContext& context) {
  Group<Dim> all;
  all.natives = Numbers(task.spheres.size());
  all.bounds = bounds;
  GroupSearch<Dim>(task, workspace, workers, context).search(all);
}

}  // namespace

template <int Dim>
void rows(std::span<const base::Sphere<Dim>> spheres, const grid::Bounds<Dim>& bounds,
          const RowsSettings& settings, Workspace<Dim>& workspace, base::PairSink& sink,
          base::DetectionContext& context) {
  sink.expect_workers(settings.workers);
  const kernels::TileKernels kernels = kernels::tile_kernels(settings.simd);
  const kernels::ElementKernels element_kernels = kernels::element_kernels(settings.simd);
  const OpenArbiter<Dim> arbiter(spheres, settings.margin);
  if (largest_number(bounds, settings.margin) <= largest_unscaled) {
    const Task<Dim> task{spheres,         arbiter, settings.margin, 0.0, kernels,
                         element_kernels, sink,    context.progress};
    return search(task, bounds, settings.workers, workspace, context);
  }
  const auto smaller = scaled(spheres, context.memory);
  const Task<Dim> task{smaller, arbiter,         settings.margin * scale_down,
                       0.0,     kernels,         element_kernels,
                       sink,    context.progress};
  search(task, bounds_of<Dim>(smaller), settings.workers, workspace, context);
}

template void rows(std::span<const base::Sphere<2>>, const grid::Bounds<2>&, const RowsSettings&,
                   Workspace<2>&, base::PairSink&, base::DetectionContext&);
template void rows(std::span<const base::Sphere<3>>, const grid::Bounds<3>&, const RowsSettings&,
                   Workspace<3>&, base::PairSink&, base::DetectionContext&);

}  // namespace abut::engine
