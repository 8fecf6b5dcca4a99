#include "algorithms/choose_algorithm.hpp"

namespace abut::registry {
namespace {

/// Below this, the arrays of `rows` take longer to lay out than all distances to compute.
constexpr std::size_t few_elements = 20;

}  // namespace

Choice choose_algorithm(std::size_t element_count) {
  if (element_count <= few_elements) {
    return {&entry_of(Algorithm::direct_check), "at most 20 elements"};
  }
  return {&entry_of(Algorithm::rows), "more than 20 elements"};
}

Choice choose_for_images() {
  return {&entry_of(Algorithm::rows), "a periodic domain"};
}

}  // namespace abut::registry
