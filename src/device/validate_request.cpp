#include "device/validate_request.hpp"

#include "base/shortest_text.hpp"
#include "elements/require_dimensions.hpp"
#include "elements/validate_rule.hpp"

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

void require_countable(const SphereSets& spheres) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  const bool two = spheres.second != nullptr;
  const std::uint64_t first = spheres.first.size();
  const std::uint64_t others = two ? spheres.second->size() : 0;
  if (first <= most && others <= most - first) return;
  const std::string count =
      two ? "two sets of " + std::to_string(first) + " and " + std::to_string(others)
          : std::to_string(first);
  throw Error(ErrorCode::limit_exceeded, count + " elements; rows numbers at most " +
                                             std::to_string(most) + ": split the system");
}

}  // namespace

void validate_request(const Options& options, const SphereSets& spheres, const Domain& domain) {
  if (spheres.second != nullptr) elements::require_alike(spheres.first, *spheres.second);
  refuse(!options.quantities.empty() && options.quantities != Quantity::gap,
         "quantities other than gaps");
  if (options.algorithm != Algorithm::automatic && options.algorithm != Algorithm::rows) {
    throw Error(ErrorCode::wrong_usage, std::string(name_of(options.algorithm)) +
                                            " does not run on a device; take rows or auto");
  }
  if (!(options.margin >= 0.0) || std::isinf(options.margin)) {
    throw Error(ErrorCode::invalid_input, "margin = " + base::shortest_text(options.margin) +
                                              "; it must be finite and not negative");
  }
  elements::require_dimensions(spheres.first, domain);
  require_countable(spheres);
  elements::validate_sizes_of_rule(options.rule, spheres.first, spheres.second);
}

}  // namespace abut::device
