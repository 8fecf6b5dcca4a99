#pragma once

#include "base/array.hpp"
#include "base/by_dimension.hpp"
#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "engine/rows.hpp"
#include "exact/lattice.hpp"
#include "grid/bounds.hpp"
#include "grid/cell_coordinates.hpp"
#include "periodic/periodic_workspace.hpp"
#include "reference/pair_decider.hpp"

#include <abut/algorithm.hpp>

#include <span>

namespace abut::registry {

/// Input of an algorithm that looks at the elements themselves, and its memory.
template <int Dim>
struct AlgorithmInput {
  const exact::Elements<Dim>& elements;
  const grid::Bounds<Dim>& bounds;
  const engine::RowsSettings& settings;
  engine::Workspace<Dim>& workspace;
  periodic::PeriodicWorkspace<Dim>& periodic_workspace;
};

/// Entry points of an algorithm in one number of dimensions: on the elements, or on their cells.
template <int Dim>
struct EntryPoints {
  void (*on_elements)(const AlgorithmInput<Dim>&, base::PairSink&,
                      base::DetectionContext&) = nullptr;

  /// The search in a periodic domain; null where that is not supported. The array holds the spheres
  /// of the elements; the search may append ghosts, and takes them away again.
  void (*on_images)(const AlgorithmInput<Dim>&, base::Array<exact::Sphere<Dim>>& spheres,
                    const exact::Lattice&, base::PairSink&, base::DetectionContext&) = nullptr;

  using Cells = grid::CellCoordinates<Dim>;
  void (*on_cells)(const Cells&, reference::PairDecider<Dim>&, base::DetectionContext&) = nullptr;
  void (*trace)(const Cells&, reference::CandidateRecorder&, base::DetectionContext&) = nullptr;

  /// Bytes of the arrays that follow the domain rather than the elements; none without it.
  double (*grid_bytes)(const Cells&) = nullptr;
};

/// One algorithm: what users read about it, and how it is run.
struct AlgorithmEntry {
  AlgorithmInfo info;
  base::ByDimension<EntryPoints> entry_points;
};

[[nodiscard]] std::span<const AlgorithmEntry> registry();

/// Throws Error{wrong_usage} for `automatic`.
[[nodiscard]] const AlgorithmEntry& entry_of(Algorithm algorithm);

template <int Dim>
[[nodiscard]] double grid_bytes(const AlgorithmEntry& row,
                                const grid::CellCoordinates<Dim>& cells) {
  const auto bytes = row.entry_points.in<Dim>().grid_bytes;
  return bytes == nullptr ? 0.0 : bytes(cells);
}

}  // namespace abut::registry
