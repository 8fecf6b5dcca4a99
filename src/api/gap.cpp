#include "api/gathered_elements.hpp"
#include "base/float_environment.hpp"
#include "base/sphere_gap.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut {

double gap(const ElementView& elements, ContactPair pair) {
  const std::size_t larger = std::max(pair.first, pair.second);
  if (larger >= elements.size()) {
    throw Error(ErrorCode::wrong_usage,
                "element " + std::to_string(larger) + " of a pair; there are " +
                    std::to_string(elements.size()) + " elements, numbered from 0");
  }
  const base::FloatEnvironment environment;
  if (elements.dimensions() == 2) {
    return base::gap(api::element_at<2>(elements, pair.first),
                     api::element_at<2>(elements, pair.second));
  }
  return base::gap(api::element_at<3>(elements, pair.first),
                   api::element_at<3>(elements, pair.second));
}

}  // namespace abut
