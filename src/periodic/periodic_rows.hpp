#pragma once

#include "base/array.hpp"
#include "engine/rows.hpp"
#include "exact/box.hpp"
#include "exact/lattice.hpp"
#include "kernels/strided_spheres.hpp"
#include "periodic/periodic_workspace.hpp"

#include <span>

namespace abut::periodic {

/// The rest of what a periodic search is asked for. If there are boxes, the spheres stand for them.
template <int Dim>
struct PeriodicInput {
  std::span<const exact::Box<Dim>> boxes;
  const grid::Bounds<Dim>& bounds;  ///< of the spheres
  const exact::Lattice& lattice;
  const engine::RowsSettings& settings;
};

/// Searches a periodic domain by `rows`: in open space among the elements, moved into one cell, and
/// those of their images that lie around it (periodic/images.hpp). Image shifts go to the sink's
/// shift_buffer. Ghosts stand behind the spheres for a while; in the end these are as they were.
///
/// Delivers nothing and returns false where the reach is about as long as the cell or longer: an
/// element would have so many ghosts that no grid helps, and all images must be checked.
template <int Dim>
[[nodiscard]] bool periodic_rows(base::Array<exact::Sphere<Dim>>& spheres,
                                 const PeriodicInput<Dim>& asked, engine::Workspace<Dim>& workspace,
                                 PeriodicWorkspace<Dim>& own, base::PairSink& sink,
                                 base::DetectionContext& context);

/// The same of valid spheres wherever their numbers lie, without a packed copy of them. Delivers
/// nothing and returns false where they must be packed, too: where they lie in one cell but cannot
/// be searched in layers, and where lattice vectors are so short that elements or shifts need care.
template <int Dim>
[[nodiscard]] bool periodic_rows_in_place(const kernels::StridedSpheres& spheres,
                                          const PeriodicInput<Dim>& asked,
                                          engine::Workspace<Dim>& workspace,
                                          PeriodicWorkspace<Dim>& own, base::PairSink& sink,
                                          base::DetectionContext& context);

}  // namespace abut::periodic
