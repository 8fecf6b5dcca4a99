#include "device/validate_request.hpp"

#include "base/shortest_text.hpp"
#include "elements/require_dimensions.hpp"

#include <abut/error.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace abut::device {
namespace {

void refuse(bool is_asked_for, const char* what) {
  if (!is_asked_for) return;
  throw Error(ErrorCode::wrong_usage,
              std::string("a device does not support ") + what +
                  " yet; copy the elements to the host and take abut::Detector");
}

}  // namespace

void validate_request(const Options& options, const ElementView& elements, const Domain& domain) {
  refuse(elements.shape() != Shape::sphere, "boxes");
  refuse(!options.rule.is_empty(), "rules");
  refuse(!options.quantities.empty(), "quantities");
  if (options.algorithm != Algorithm::automatic && options.algorithm != Algorithm::rows) {
    throw Error(ErrorCode::wrong_usage, std::string(name_of(options.algorithm)) +
                                            " does not run on a device; take rows or auto");
  }
  if (!(options.margin >= 0.0) || std::isinf(options.margin)) {
    throw Error(ErrorCode::invalid_input, "margin = " + base::shortest_text(options.margin) +
                                              "; it must be finite and not negative");
  }
  elements::require_dimensions(elements, domain);
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  if (elements.size() > most) {
    throw Error(ErrorCode::limit_exceeded, std::to_string(elements.size()) +
                                               " elements; rows numbers at most " +
                                               std::to_string(most) + ": split the system");
  }
}

}  // namespace abut::device
