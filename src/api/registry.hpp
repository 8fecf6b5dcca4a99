#pragma once

#include "base/detection_context.hpp"
#include "grid/cell_coordinates.hpp"
#include "reference/contact_test.hpp"

#include <abut/algorithm.hpp>

#include <span>

namespace abut::api {

/// One algorithm: what users read about it, and how it is run on the cells of the elements.
struct RegistryRow {
  AlgorithmInfo info;

  template <int Dim, class Test>
  using Run = void (*)(const grid::CellCoordinates<Dim>&, Test&, base::DetectionContext&);

  Run<2, reference::ContactTest<2>> detect_2d;
  Run<3, reference::ContactTest<3>> detect_3d;
  Run<2, reference::CandidateRecorder> trace_2d;
  Run<3, reference::CandidateRecorder> trace_3d;

  /// Bytes of the arrays that follow the domain rather than the elements; 0 if there are none.
  double (*grid_bytes_2d)(const grid::CellCoordinates<2>&);
  double (*grid_bytes_3d)(const grid::CellCoordinates<3>&);
};

[[nodiscard]] std::span<const RegistryRow> registry();

/// Throws Error{wrong_usage} for `automatic`.
[[nodiscard]] const RegistryRow& row_of(Algorithm algorithm);

template <int Dim>
[[nodiscard]] double grid_bytes(const RegistryRow& row, const grid::CellCoordinates<Dim>& cells) {
  if constexpr (Dim == 2) {
    return row.grid_bytes_2d == nullptr ? 0.0 : row.grid_bytes_2d(cells);
  } else {
    return row.grid_bytes_3d == nullptr ? 0.0 : row.grid_bytes_3d(cells);
  }
}

}  // namespace abut::api
