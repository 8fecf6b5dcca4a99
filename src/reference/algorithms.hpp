#pragma once

#include "base/detection_context.hpp"
#include "grid/cell_coordinates.hpp"

#include <cstddef>

/// The contact detection of A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004,
/// chapter 3. One file an algorithm; each delivers every pair of elements in equal or adjacent
/// cells to `test` exactly once (direct_check: every pair), and leaves its lists empty.
///
/// `Test` is callable with two element numbers: a PairDecider<Dim> or a CandidateRecorder.
namespace abut::reference {

template <class Test>
void direct_check(std::size_t element_count, Test& test, base::DetectionContext& context);

template <int Dim, class Test>
void binary_tree(const grid::CellCoordinates<Dim>& cells, Test& test,
                 base::DetectionContext& context);

template <int Dim, class Test>
void screening_array(const grid::CellCoordinates<Dim>& cells, Test& test,
                     base::DetectionContext& context);

template <int Dim, class Test>
void sorting_array(const grid::CellCoordinates<Dim>& cells, Test& test,
                   base::DetectionContext& context);

template <class Test>
void munjiza_nbs_2d(const grid::CellCoordinates<2>& cells, Test& test,
                    base::DetectionContext& context);

template <class Test>
void munjiza_nbs_3d(const grid::CellCoordinates<3>& cells, Test& test,
                    base::DetectionContext& context);

/// Bytes of the heads and lists of the two methods whose memory follows the domain.
template <int Dim>
[[nodiscard]] double screening_array_bytes(const grid::CellCoordinates<Dim>& cells);
template <int Dim>
[[nodiscard]] double munjiza_nbs_bytes(const grid::CellCoordinates<Dim>& cells);

}  // namespace abut::reference
