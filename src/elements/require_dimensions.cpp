#include "elements/require_dimensions.hpp"

#include "exact/lattice.hpp"

#include <abut/error.hpp>

#include <cstddef>
#include <cstdint>
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

void require_alike(const ElementView& first, const ElementView& second) {
  if (first.shape() != second.shape()) {
    throw Error(ErrorCode::wrong_usage,
                "one set holds spheres and the other boxes; give two sets of the same shape");
  }
  if (first.dimensions() == second.dimensions()) return;
  throw Error(ErrorCode::wrong_usage, "the first set has " + std::to_string(first.dimensions()) +
                                          " dimensions and the second " +
                                          std::to_string(second.dimensions()) +
                                          "; give two sets of the same number of dimensions");
}

void require_there(const Domain& domain, const ImageShift& shift) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t number = exact::numbers(shift)[static_cast<std::size_t>(axis)];
    if (number == 0 || domain.is_periodic(axis)) continue;
    throw Error(ErrorCode::wrong_usage, std::string("image shift ") + "xyz"[axis] + " = " +
                                            std::to_string(number) +
                                            ", but the domain is not periodic there; give 0");
  }
}

}  // namespace abut::elements
