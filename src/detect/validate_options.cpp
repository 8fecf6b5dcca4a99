#include "detect/validate_options.hpp"

#include "algorithms/registry.hpp"
#include "base/machine_memory.hpp"
#include "base/shortest_text.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace abut::detect {
namespace {

constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;
constexpr std::uint64_t bytes_per_element = 2048;

/// The book's lists hold element numbers and -1 in 32 bits with a sign; rows holds numbers and
/// their count in 32 bits without one.
std::uint64_t most_elements(Algorithm algorithm) {
  return algorithm == Algorithm::rows || algorithm == Algorithm::automatic
             ? std::numeric_limits<std::uint32_t>::max() - 1
             : std::numeric_limits<std::int32_t>::max() - 1;
}

void require_supported(Algorithm algorithm, const Domain& domain) {
  if (!domain.is_periodic() || algorithm == Algorithm::automatic) return;
  if (registry::entry_of(algorithm).info.periodic) return;
  std::string supporting;
  for (const registry::AlgorithmEntry& row : registry::registry()) {
    if (!row.info.periodic) continue;
    supporting += (supporting.empty() ? "" : " or ") + std::string(row.info.name);
  }
  throw Error(ErrorCode::wrong_usage, std::string(name_of(algorithm)) +
                                          " does not support periodic domains; take " + supporting +
                                          ", or auto");
}

void require_in_range(const Options& options) {
  if (!(options.margin >= 0.0) || std::isinf(options.margin)) {
    throw Error(ErrorCode::invalid_input, "margin = " + base::shortest_text(options.margin) +
                                              "; it must be finite and not negative");
  }
  require_threads(options);
}

[[noreturn]] void refuse_count(const std::string& count, Algorithm algorithm) {
  throw Error(ErrorCode::limit_exceeded,
              count + " elements; " + std::string(name_of(algorithm)) + " numbers at most " +
                  std::to_string(most_elements(algorithm)) + ": split the system");
}

}  // namespace

void require_threads(const Options& options) {
  if (options.threads >= 0) return;
  throw Error(ErrorCode::wrong_usage, "threads = " + std::to_string(options.threads) +
                                          "; give a positive number, or 0 for the default");
}

void validate(const Options& options, const ElementView& elements, const Domain& domain) {
  require_in_range(options);
  require_dimensions(elements, domain);
  require_supported(options.algorithm, domain);
  if (elements.size() > most_elements(options.algorithm)) {
    refuse_count(std::to_string(elements.size()), options.algorithm);
  }
}

void validate(const Options& options, const ElementView& first, const ElementView& second,
              const Domain& domain) {
  require_in_range(options);
  require_alike(first, second);
  require_dimensions(first, domain);
  require_supported(options.algorithm, domain);
  const std::uint64_t most = most_elements(options.algorithm);
  if (first.size() > most || second.size() > most - first.size()) {
    refuse_count(
        "two sets of " + std::to_string(first.size()) + " and " + std::to_string(second.size()),
        options.algorithm);
  }
}

void require_points(const ElementView& points, double cutoff) {
  if (!(cutoff >= 0.0) || std::isinf(cutoff)) {
    throw Error(ErrorCode::invalid_input,
                "cutoff = " + base::shortest_text(cutoff) + "; it must be finite and not negative");
  }
  const bool spheres = points.shape() == Shape::sphere;
  if (spheres && points.has_common_radius() && points.common_radius() == 0.0) return;
  throw Error(ErrorCode::wrong_usage,
              "neighbors within a cutoff are those of points, and these elements have sizes; make "
              "them with points(...), or take build_neighbor_list and a margin");
}

std::uint64_t memory_bound(const Options& options) {
  return options.max_bytes != automatic_memory_bound ? options.max_bytes : base::machine_memory();
}

std::uint64_t grid_memory_bound(const Options& options, std::size_t element_count) {
  if (options.max_bytes != automatic_memory_bound) return options.max_bytes;
  return std::min(gibibyte + bytes_per_element * element_count, base::machine_memory());
}

}  // namespace abut::detect
