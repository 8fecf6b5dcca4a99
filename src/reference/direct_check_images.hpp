#pragma once

#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "exact/elements.hpp"
#include "exact/lattice.hpp"

namespace abut::reference {

/// direct_check in a periodic domain: every element against every image of itself and of those that
/// follow it which a bound does not exclude. Delivers each (i, j, n) of the contract once. Throws
/// Error{invalid_input} naming the element whose image shift would leave 32 bits.
template <int Dim>
void direct_check_images(const exact::Elements<Dim>& elements, const exact::Lattice& lattice,
                         double margin, base::ImagePairWriter& pairs,
                         base::DetectionContext& context);

}  // namespace abut::reference
