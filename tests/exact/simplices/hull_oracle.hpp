#pragma once

#include "exact/lattice.hpp"
#include "exact/simplices/simplex.hpp"

#include <abut/image_shift.hpp>

namespace abut::testing {

/// True if two convex hulls have a point in common, in rational numbers and without a single sign
/// of orientation: whether weights of the vertices exist, none negative, whose means agree. The
/// simplex method finds them (G. B. Dantzig), by R. G. Bland's rule, which never circles (New
/// finite pivoting rules for the simplex method, Math. Oper. Res. 2, 1977, 103-107).
template <int Dim>
[[nodiscard]] bool hulls_meet_by_rationals(const exact::Simplex<Dim>& a,
                                           const exact::Simplex<Dim>& b);

/// The same for a and the image of b that `shift` names.
template <int Dim>
[[nodiscard]] bool hulls_meet_by_rationals(const exact::Simplex<Dim>& a,
                                           const exact::Simplex<Dim>& b, const ImageShift& shift,
                                           const exact::Lattice& lattice);

}  // namespace abut::testing
