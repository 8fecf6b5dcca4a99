#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>

namespace abut::elements {

/// Throws Error{wrong_usage} for a periodic domain of other dimensions than the elements.
void require_dimensions(const ElementView& elements, const Domain& domain);

}  // namespace abut::elements
