#include "algorithms/choose_algorithm.hpp"

namespace abut::registry {
namespace {

/// Below this, the arrays of `rows` take longer to lay out than all distances to compute.
constexpr std::size_t few_elements = 64;

}  // namespace

Choice choose_algorithm(std::size_t element_count) {
  if (element_count <= few_elements) {
    return {&entry_of(Algorithm::direct_check), "at most 64 elements"};
  }
  return {&entry_of(Algorithm::rows), "more than 64 elements"};
}

}  // namespace abut::registry
