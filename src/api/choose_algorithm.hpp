#pragma once

#include "api/registry.hpp"

#include <string>

namespace abut::api {

struct Choice {
  const RegistryRow* row;
  std::string reason;
};

/// Few elements: direct check. Otherwise Munjiza-NBS, unless its heads, which follow the extent of
/// the domain, would dwarf its lists: then the sorting array, which needs none.
template <int Dim>
[[nodiscard]] Choice choose_algorithm(const grid::CellCoordinates<Dim>& cells);

}  // namespace abut::api
