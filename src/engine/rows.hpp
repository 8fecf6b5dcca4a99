#pragma once

#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "engine/layers/layer_limits.hpp"
#include "engine/workspace.hpp"
#include "exact/elements.hpp"
#include "grid/bounds.hpp"
#include "kernels/strided_boxes.hpp"
#include "kernels/strided_spheres.hpp"
#include "kernels/wide_vectors.hpp"

#include <abut/simd.hpp>

#include <cstddef>

namespace abut::engine {

/// The settings of `rows`.
struct RowsSettings {
  double margin = 0.0;
  std::size_t workers = 1;
  Simd simd = Simd::scalar;  ///< an available level
  LayerLimits layers = {};
  kernels::WideVectors wide_vectors = kernels::wide_vectors_here();
};

/// The production algorithm: Munjiza's rows, contiguous and in tiles (docs/algorithms/rows.md).
/// Delivers every contact pair once to `sink`.
template <int Dim>
void rows(const exact::Elements<Dim>& elements, const grid::Bounds<Dim>& bounds,
          const RowsSettings& settings, Workspace<Dim>& workspace, base::PairSink& sink,
          base::DetectionContext& context);

/// The same of valid spheres wherever their numbers lie, without a packed copy of them, if they can
/// be searched in layers. Otherwise it delivers nothing and returns false.
template <int Dim>
[[nodiscard]] bool rows_in_place(const kernels::StridedSpheres& spheres,
                                 const grid::Bounds<Dim>& bounds, const RowsSettings& settings,
                                 Workspace<Dim>& workspace, base::PairSink& sink,
                                 base::DetectionContext& context);

/// The same of valid boxes; `bounds` are those of the spheres that stand for them.
template <int Dim>
[[nodiscard]] bool rows_in_place(const kernels::StridedBoxes& boxes,
                                 const grid::Bounds<Dim>& bounds, const RowsSettings& settings,
                                 Workspace<Dim>& workspace, base::PairSink& sink,
                                 base::DetectionContext& context);

}  // namespace abut::engine
