#pragma once

#include "base/lattice.hpp"
#include "engine/rows.hpp"

namespace abut::engine {

/// `rows` in a periodic domain: in open space among the elements, moved into one cell, and those of
/// their images that lie around it (grid/images.hpp). Image shifts go to the sink's shift_room.
template <int Dim>
void periodic_rows(std::span<const base::Sphere<Dim>> spheres, const grid::Bounds<Dim>& bounds,
                   const base::Lattice& lattice, const RowsSettings& settings,
                   Workspace<Dim>& workspace, base::PairSink& sink,
                   base::DetectionContext& context);

}  // namespace abut::engine
