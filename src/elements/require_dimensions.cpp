#include "elements/require_dimensions.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::elements {

void require_dimensions(const ElementView& elements, const Domain& domain) {
  if (domain.dimensions() == 0 || domain.dimensions() == elements.dimensions()) return;
  throw Error(ErrorCode::wrong_usage, "a domain of " + std::to_string(domain.dimensions()) +
                                          " dimensions for elements of " +
                                          std::to_string(elements.dimensions()) +
                                          "; give lengths or vectors of " +
                                          std::to_string(elements.dimensions()) + " numbers");
}

}  // namespace abut::elements
