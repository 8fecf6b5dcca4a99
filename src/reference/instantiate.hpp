#pragma once

/// The candidate tests that every algorithm is compiled for: one list, at the end of each file.
// NOLINTBEGIN(bugprone-macro-parentheses): a name in a declaration stands without parentheses
#define ABUT_INSTANTIATE_2D_AND_3D(function)                                     \
  template void function<2>(const grid::CellCoordinates<2>&, PairDecider<2>&,    \
                            base::DetectionContext&);                            \
  template void function<3>(const grid::CellCoordinates<3>&, PairDecider<3>&,    \
                            base::DetectionContext&);                            \
  template void function<2>(const grid::CellCoordinates<2>&, CandidateRecorder&, \
                            base::DetectionContext&);                            \
  template void function<3>(const grid::CellCoordinates<3>&, CandidateRecorder&, \
                            base::DetectionContext&)
// NOLINTEND(bugprone-macro-parentheses)
