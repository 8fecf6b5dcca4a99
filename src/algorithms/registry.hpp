#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "engine/rows.hpp"
#include "exact/lattice.hpp"
#include "grid/bounds.hpp"
#include "grid/cell_coordinates.hpp"
#include "periodic/periodic_workspace.hpp"
#include "reference/contact_test.hpp"

#include <abut/algorithm.hpp>

#include <span>

namespace abut::api {

/// Input of an algorithm that looks at the elements themselves, and its memory.
template <int Dim>
struct AlgorithmInput {
  const base::Elements<Dim>& elements;
  const grid::Bounds<Dim>& bounds;
  const engine::RowsSettings& settings;
  engine::Workspace<Dim>& workspace;
  engine::PeriodicWorkspace<Dim>& periodic_workspace;
};

/// Entry points of an algorithm in one number of dimensions: on the elements, or on their cells.
template <int Dim>
struct Runs {
  void (*on_elements)(const AlgorithmInput<Dim>&, base::PairSink&,
                      base::DetectionContext&) = nullptr;

  /// In a periodic domain; null where that is not supported. The array holds the spheres of the
  /// elements; the search may append ghosts, and takes them away again.
  void (*on_images)(const AlgorithmInput<Dim>&, base::Array<base::Sphere<Dim>>& spheres,
                    const base::Lattice&, base::PairSink&, base::DetectionContext&) = nullptr;

  using Cells = grid::CellCoordinates<Dim>;
  void (*on_cells)(const Cells&, reference::ContactTest<Dim>&, base::DetectionContext&) = nullptr;
  void (*trace)(const Cells&, reference::CandidateRecorder&, base::DetectionContext&) = nullptr;

  /// Bytes of the arrays that follow the domain rather than the elements; none without it.
  double (*grid_bytes)(const Cells&) = nullptr;
};

/// One algorithm: what users read about it, and how it is run.
struct RegistryRow {
  AlgorithmInfo info;
  Runs<2> in_2d;
  Runs<3> in_3d;

  template <int Dim>
  [[nodiscard]] const Runs<Dim>& runs() const noexcept {
    if constexpr (Dim == 2) {
      return in_2d;
    } else {
      return in_3d;
    }
  }
};

[[nodiscard]] std::span<const RegistryRow> registry();

/// Throws Error{wrong_usage} for `automatic`.
[[nodiscard]] const RegistryRow& row_of(Algorithm algorithm);

template <int Dim>
[[nodiscard]] double grid_bytes(const RegistryRow& row, const grid::CellCoordinates<Dim>& cells) {
  const auto bytes = row.runs<Dim>().grid_bytes;
  return bytes == nullptr ? 0.0 : bytes(cells);
}

}  // namespace abut::api
