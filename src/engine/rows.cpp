#include "engine/rows.hpp"

#include "engine/deciders/box_decider.hpp"
#include "engine/deciders/sphere_decider.hpp"
#include "engine/set_search.hpp"
#include "grid/scaling.hpp"
#include "kernels/tie_kernels.hpp"

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

/// What a search of all elements is made of, but for the elements themselves.
struct RowsCall {
  const RowsSettings& settings;
  base::PairSink& sink;
  base::DetectionContext& context;
};

template <int Dim>
SearchInput<Dim> input_of(const exact::Elements<Dim>& elements, const LayerSpheres<Dim>& spheres,
                          double margin, const GivenSteps& steps, const ExactDecider& decider,
                          const RowsCall& call) {
  const Simd simd = call.settings.simd;
  return {elements,
          spheres,
          steps,
          decider,
          margin,
          0.0,
          kernels::tile_kernels(simd),
          kernels::element_kernels(simd),
          kernels::layer_kernels(simd),
          kernels::plane_kernels(simd),
          call.settings.wide_vectors,
          call.settings.layers,
          call.sink,
          call.context.progress};
}

template <int Dim>
LayerSpheres<Dim> layer_spheres(const exact::Elements<Dim>& elements) {
  const kernels::SphereParts spheres(kernels::strided_spheres(elements.spheres));
  return LayerSpheres<Dim>(spheres).standing_for(kernels::strided_boxes(elements.boxes));
}

template <int Dim>
SearchSet<Dim> set_of(std::size_t elements, const grid::Bounds<Dim>& bounds) {
  SearchSet<Dim> all;
  all.locals = Numbers(elements);
  all.bounds = bounds;
  return all;
}

/// What is searched as it is given: multiples of any step.
GivenSteps steps_of(const kernels::StridedSpheres& spheres) {
  constexpr double largest_power_of_two = 0x1p1023;
  return {spheres, 0.0, largest_power_of_two};
}

template <int Dim>
GivenSteps steps_of(const exact::Elements<Dim>& elements) {
  return elements.are_boxes() ? GivenSteps{} : steps_of(kernels::strided_spheres(elements.spheres));
}

bool needs_scaling(double largest_number) {
  return !(largest_number <= grid::largest_unscaled);
}

template <int Dim>
void search(const exact::Elements<Dim>& elements, const grid::Bounds<Dim>& bounds,
            const ExactDecider& decider, const RowsCall& call, Workspace<Dim>& workspace) {
  const RowsSettings& settings = call.settings;
  const auto search_as_mapped = [&](const exact::Elements<Dim>& mapped, double margin,
                                    const GivenSteps& steps,
                                    const grid::Bounds<Dim>& their_bounds) {
    const auto input = input_of(mapped, layer_spheres(mapped), margin, steps, decider, call);
    SetSearch<Dim>(input, workspace, settings.workers, call.context)
        .search(set_of(mapped.size(), their_bounds));
  };
  if (!needs_scaling(grid::largest_number(bounds, settings.margin))) {
    return search_as_mapped(elements, settings.margin, steps_of(elements), bounds);
  }
  const ScaledElements<Dim> smaller(elements, call.context.memory);
  search_as_mapped(smaller.elements(), settings.margin * scale_down, {},
                   bounds_of<Dim>(smaller.elements()));
}

}  // namespace

template <int Dim>
void rows(const exact::Elements<Dim>& elements, const grid::Bounds<Dim>& bounds,
          const RowsSettings& settings, Workspace<Dim>& workspace, base::PairSink& sink,
          base::DetectionContext& context) {
  sink.expect_workers(settings.workers);
  const RowsCall call{settings, sink, context};
  if (elements.are_boxes()) {
    const BoxDecider<Dim> decider(kernels::strided_boxes(elements.boxes), settings.margin);
    return search(elements, bounds, decider, call, workspace);
  }
  const SphereDecider<Dim> decider(kernels::strided_spheres(elements.spheres), settings.margin,
                                   kernels::tie_kernels(settings.simd));
  search(elements, bounds, decider, call, workspace);
}

template <int Dim>
bool rows_in_place(const kernels::StridedSpheres& spheres, const grid::Bounds<Dim>& bounds,
                   const RowsSettings& settings, Workspace<Dim>& workspace, base::PairSink& sink,
                   base::DetectionContext& context) {
  if (needs_scaling(grid::largest_number(bounds, settings.margin))) return false;
  sink.expect_workers(settings.workers);
  const SphereDecider<Dim> decider(spheres, settings.margin, kernels::tie_kernels(settings.simd));
  const LayerSpheres<Dim> layer_spheres{kernels::SphereParts(spheres)};
  const SearchInput<Dim> input = input_of<Dim>(
      {}, layer_spheres, settings.margin, steps_of(spheres), decider, {settings, sink, context});
  return SetSearch<Dim>(input, workspace, settings.workers, context)
      .search_in_layers(set_of(spheres.size, bounds));
}

template <int Dim>
bool rows_in_place(const kernels::StridedBoxes& boxes, const grid::Bounds<Dim>& bounds,
                   const RowsSettings& settings, Workspace<Dim>& workspace, base::PairSink& sink,
                   base::DetectionContext& context) {
  if (needs_scaling(grid::largest_number(bounds, settings.margin))) return false;
  sink.expect_workers(settings.workers);
  const BoxDecider<Dim> decider(boxes, settings.margin);
  const kernels::SphereParts corners(kernels::lower_corners(boxes, &bounds.largest_radius));
  const SearchInput<Dim> input =
      input_of<Dim>({}, LayerSpheres<Dim>(corners).standing_for(boxes), settings.margin, {},
                    decider, {settings, sink, context});
  return SetSearch<Dim>(input, workspace, settings.workers, context)
      .search_in_layers(set_of(boxes.size, bounds));
}

template void rows(const exact::Elements<2>&, const grid::Bounds<2>&, const RowsSettings&,
                   Workspace<2>&, base::PairSink&, base::DetectionContext&);
template void rows(const exact::Elements<3>&, const grid::Bounds<3>&, const RowsSettings&,
                   Workspace<3>&, base::PairSink&, base::DetectionContext&);
template bool rows_in_place(const kernels::StridedSpheres&, const grid::Bounds<2>&,
                            const RowsSettings&, Workspace<2>&, base::PairSink&,
                            base::DetectionContext&);
template bool rows_in_place(const kernels::StridedSpheres&, const grid::Bounds<3>&,
                            const RowsSettings&, Workspace<3>&, base::PairSink&,
                            base::DetectionContext&);
template bool rows_in_place(const kernels::StridedBoxes&, const grid::Bounds<2>&,
                            const RowsSettings&, Workspace<2>&, base::PairSink&,
                            base::DetectionContext&);
template bool rows_in_place(const kernels::StridedBoxes&, const grid::Bounds<3>&,
                            const RowsSettings&, Workspace<3>&, base::PairSink&,
                            base::DetectionContext&);

}  // namespace abut::engine
