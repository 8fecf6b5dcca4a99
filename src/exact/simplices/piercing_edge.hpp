#pragma once

#include "exact/simplices/two_point_sets.hpp"

namespace abut::exact {

/// Tells whether an edge of one simplex passes through the inside of a face of the other: a common
/// point, found with a few signs where most planes would have to be tried. Only filters are asked,
/// so that false means nothing.
template <class P>
[[nodiscard]] bool has_piercing_edge(const TwoPointSets<P>& sets) noexcept;

}  // namespace abut::exact
