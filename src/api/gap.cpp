#include "api/gathered_elements.hpp"
#include "api/lattice_of.hpp"
#include "api/validate_options.hpp"
#include "base/float_environment.hpp"
#include "base/periodic_gap.hpp"
#include "base/sphere_gap.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut {
namespace {

void require_there(const ElementView& elements, ContactPair pair) {
  const std::size_t larger = std::max(pair.first, pair.second);
  if (larger < elements.size()) return;
  throw Error(ErrorCode::wrong_usage,
              "element " + std::to_string(larger) + " of a pair; there are " +
                  std::to_string(elements.size()) + " elements, numbered from 0");
}

/// The shift is 0 on axes that are not periodic.
void require_there(const Domain& domain, const ImageShift& shift) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t number = base::numbers(shift)[static_cast<std::size_t>(axis)];
    if (number == 0 || domain.is_periodic(axis)) continue;
    throw Error(ErrorCode::wrong_usage, std::string("image shift ") + "xyz"[axis] + " = " +
                                            std::to_string(number) +
                                            ", but the domain is not periodic there; give 0");
  }
}

template <int Dim>
double gap_to_image(const ElementView& elements, const Domain& domain, ContactPair pair,
                    const ImageShift& shift) {
  return base::gap<Dim>(api::element_at<Dim>(elements, pair.first),
                        api::element_at<Dim>(elements, pair.second), shift,
                        api::lattice_of(domain));
}

}  // namespace

double gap(const ElementView& elements, ContactPair pair) {
  require_there(elements, pair);
  const base::FloatEnvironment environment;
  if (elements.dimensions() == 2) {
    return base::gap(api::element_at<2>(elements, pair.first),
                     api::element_at<2>(elements, pair.second));
  }
  return base::gap(api::element_at<3>(elements, pair.first),
                   api::element_at<3>(elements, pair.second));
}

double gap(const ElementView& elements, const Domain& domain, ContactPair pair,
           const ImageShift& shift) {
  require_there(elements, pair);
  api::require_dimensions(elements, domain);
  require_there(domain, shift);
  const base::FloatEnvironment environment;
  return elements.dimensions() == 2 ? gap_to_image<2>(elements, domain, pair, shift)
                                    : gap_to_image<3>(elements, domain, pair, shift);
}

}  // namespace abut
