#include "engine/rows.hpp"

#include "engine/set_search.hpp"
#include "grid/scaling.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

using grid::scale_down;

/// Copies the elements at the smaller scale (grid/scaling.hpp).
template <int Dim>
class ScaledElements {
 public:
  ScaledElements(const exact::Elements<Dim>& elements, base::MemoryMeter& memory)
      : spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, elements.size())),
        boxes_(base::make_array_for_overwrite<exact::Box<Dim>>(memory, elements.boxes.size())) {
    std::transform(elements.spheres.begin(), elements.spheres.end(), spheres_.begin(),
                   [](exact::Sphere<Dim> sphere) {
                     for (double& x : sphere.center) x *= scale_down;
                     sphere.radius *= scale_down;
                     return sphere;
                   });
    std::transform(elements.boxes.begin(), elements.boxes.end(), boxes_.begin(),
                   [](exact::Box<Dim> box) {
                     for (double& x : box.lower) x *= scale_down;
                     for (double& x : box.upper) x *= scale_down;
                     return box;
                   });
  }

  [[nodiscard]] exact::Elements<Dim> elements() const noexcept { return {spheres_, boxes_}; }

 private:
  base::Array<exact::Sphere<Dim>> spheres_;
  base::Array<exact::Box<Dim>> boxes_;
};

template <int Dim>
grid::Bounds<Dim> bounds_of(const exact::Elements<Dim>& elements) {
  grid::Bounds<Dim> bounds;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    bounds.include_center(elements[k]);
    bounds.include_radius(elements[k].radius);
  }
  if (elements.are_boxes()) bounds.count_largest_twice();
  return bounds;
}

template <int Dim>
void search(const SearchInput<Dim>& input, const grid::Bounds<Dim>& bounds, std::size_t workers,
            Workspace<Dim>& workspace, base::DetectionContext& context) {
  SearchSet<Dim> all;
  all.locals = Numbers(input.elements.size());
  all.bounds = bounds;
  SetSearch<Dim>(input, workspace, workers, context).search(all);
}

}  // namespace

template <int Dim>
void rows(const exact::Elements<Dim>& elements, const grid::Bounds<Dim>& bounds,
          const RowsSettings& settings, Workspace<Dim>& workspace, base::PairSink& sink,
          base::DetectionContext& context) {
  sink.expect_workers(settings.workers);
  const kernels::TileKernels kernels = kernels::tile_kernels(settings.simd);
  const kernels::ElementKernels element_kernels = kernels::element_kernels(settings.simd);
  const kernels::LayerKernels layer_kernels = kernels::layer_kernels(settings.simd);
  const OpenDecider<Dim> decider(elements, settings.margin, kernels::tie_kernels(settings.simd));
  const auto input = [&](const exact::Elements<Dim>& as_mapped, double margin) {
    return SearchInput<Dim>{as_mapped, decider,         margin,        0.0,
                            kernels,   element_kernels, layer_kernels, settings.layers,
                            sink,      context.progress};
  };
  if (grid::largest_number(bounds, settings.margin) <= grid::largest_unscaled) {
    return search(input(elements, settings.margin), bounds, settings.workers, workspace, context);
  }
  const ScaledElements<Dim> smaller(elements, context.memory);
  search(input(smaller.elements(), settings.margin * scale_down),
         bounds_of<Dim>(smaller.elements()), settings.workers, workspace, context);
}

template void rows(const exact::Elements<2>&, const grid::Bounds<2>&, const RowsSettings&,
                   Workspace<2>&, base::PairSink&, base::DetectionContext&);
template void rows(const exact::Elements<3>&, const grid::Bounds<3>&, const RowsSettings&,
                   Workspace<3>&, base::PairSink&, base::DetectionContext&);

}  // namespace abut::engine
