#include "api/choose_algorithm.hpp"

namespace abut::api {
namespace {

constexpr std::size_t few_elements = 64;

/// Bytes of heads per element that Munjiza-NBS may spend: filling them with -1 costs about as much
/// as the detection itself.
constexpr double affordable_bytes_per_element = 64.0;

}  // namespace

template <int Dim>
Choice choose_algorithm(const grid::CellCoordinates<Dim>& cells) {
  if (cells.element_count() <= few_elements) {
    return {&row_of(Algorithm::direct_check), "at most 64 elements"};
  }
  const RegistryRow& nbs = row_of(Algorithm::munjiza_nbs);
  const double affordable =
      affordable_bytes_per_element * static_cast<double>(cells.element_count());
  if (grid_bytes(nbs, cells) <= affordable) {
    return {&nbs, "time and memory follow the elements"};
  }
  return {&row_of(Algorithm::sorting_array),
          "the domain has many more rows than elements; its memory does not follow the domain"};
}

template Choice choose_algorithm(const grid::CellCoordinates<2>&);
template Choice choose_algorithm(const grid::CellCoordinates<3>&);

}  // namespace abut::api
