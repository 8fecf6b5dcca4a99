#include "api/choose_algorithm.hpp"

namespace abut::api {
namespace {

/// Below this, the arrays of `rows` take longer to lay out than all distances to compute.
constexpr std::size_t few_elements = 64;

}  // namespace

Choice choose_algorithm(std::size_t element_count, const Domain& domain) {
  if (element_count <= few_elements) {
    return {&row_of(Algorithm::direct_check), "at most 64 elements"};
  }
  const RegistryRow& rows = row_of(Algorithm::rows);
  if (domain.is_periodic() && !rows.info.periodic) {
    return {&row_of(Algorithm::direct_check), "carries periodic domains"};
  }
  return {&rows, "more than 64 elements"};
}

}  // namespace abut::api
