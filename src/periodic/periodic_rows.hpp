#pragma once

#include "base/array.hpp"
#include "engine/rows.hpp"
#include "exact/box.hpp"
#include "exact/lattice.hpp"
#include "periodic/periodic_workspace.hpp"

#include <span>

namespace abut::engine {

/// `rows` in a periodic domain: in open space among the elements, moved into one cell, and those of
/// their images that lie around it (periodic/images.hpp). Image shifts go to the sink's shift_room.
/// Ghosts stand behind the spheres for a while; in the end these are as they were. Where there are
/// boxes the spheres stand for them.
template <int Dim>
void periodic_rows(base::Array<base::Sphere<Dim>>& spheres, std::span<const base::Box<Dim>> boxes,
                   const grid::Bounds<Dim>& bounds, const base::Lattice& lattice,
                   const RowsSettings& settings, Workspace<Dim>& workspace,
                   PeriodicWorkspace<Dim>& own, base::PairSink& sink,
                   base::DetectionContext& context);

}  // namespace abut::engine
