#pragma once

#include "base/array.hpp"
#include "engine/rows.hpp"
#include "exact/box.hpp"
#include "exact/lattice.hpp"
#include "periodic/periodic_workspace.hpp"

#include <span>

namespace abut::periodic {

/// `rows` in a periodic domain: in open space among the elements, moved into one cell, and those of
/// their images that lie around it (periodic/images.hpp). Image shifts go to the sink's
/// shift_buffer. Ghosts stand behind the spheres for a while; in the end these are as they were.
/// If there are boxes, the spheres stand for them.
template <int Dim>
void periodic_rows(base::Array<exact::Sphere<Dim>>& spheres, std::span<const exact::Box<Dim>> boxes,
                   const grid::Bounds<Dim>& bounds, const exact::Lattice& lattice,
                   const engine::RowsSettings& settings, engine::Workspace<Dim>& workspace,
                   PeriodicWorkspace<Dim>& own, base::PairSink& sink,
                   base::DetectionContext& context);

}  // namespace abut::periodic
