#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>

namespace abut::elements {

/// Throws Error{wrong_usage} for a periodic domain of other dimensions than the elements.
void require_dimensions(const ElementView& elements, const Domain& domain);

/// Throws Error{wrong_usage} for two sets of unequal dimensions or shapes.
void require_alike(const ElementView& first, const ElementView& second);

}  // namespace abut::elements
