#pragma once

#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>

#include <vector>

namespace abut {

/// Returns the numbers of the elements in an order in which neighbors in space are neighbors in
/// memory: along the Hilbert curve through a cube around their centers, whose cells are 2^-21 of
/// its width (2D: 2^-31). Boxes lie where their lower corners are. Elements in one cell keep the
/// order of their numbers.
///
/// A loop over contacts reads elements all over memory if numbers do not follow space. Programs
/// therefore bring their arrays into this order before the first step and now and then afterwards.
/// In periodic domains wrap the positions first.
///
/// The order is the same everywhere, whatever the number of threads. Of the options threads, simd,
/// max_bytes and progress count. Throws Error as a detection does: for invalid elements, too little
/// memory, a cancel.
///
/// D. Hilbert, Ueber die stetige Abbildung einer Linie auf ein Flaechenstueck, Mathematische
/// Annalen 38, 1891; by tables, as C. Hamilton, Compact Hilbert indices, Dalhousie University
/// CS-2006-07, 2006, derives them.
[[nodiscard]] ABUT_API std::vector<ElementIndex> spatial_order(const ElementView& elements,
                                                               const Options& options = {});

}  // namespace abut
