#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>

namespace abut::elements {

/// Throws Error{wrong_usage} for a periodic domain of other dimensions than the elements.
void require_dimensions(const ElementView& elements, const Domain& domain);

/// Throws Error{wrong_usage} for two sets of unequal dimensions or shapes.
void require_alike(const ElementView& first, const ElementView& second);

/// Throws Error{wrong_usage} for an image shift that is not 0 on an axis that is not periodic.
void require_there(const Domain& domain, const ImageShift& shift);

}  // namespace abut::elements
