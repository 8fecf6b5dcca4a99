#include "base/lack_of_memory.hpp"

#include <abut/error.hpp>
#include <abut/simplex_contacts.hpp>

#include <string>

namespace abut {

SimplexView::SimplexView(const ElementView& vertices, const Connectivity& cells)
    : vertices_(vertices), cells_(cells) {
  base::reporting_lack_of_memory([&] {
    if (vertices.shape() != Shape::sphere) {
      throw Error(ErrorCode::wrong_usage,
                  "the vertices of simplices are boxes; give points(x, y, z)");
    }
    const std::size_t most = static_cast<std::size_t>(dimensions()) + 1;
    const std::size_t given = cells.vertices_per_cell();
    if (given >= 1 && given <= most) return;
    throw Error(ErrorCode::wrong_usage, "cells of " + std::to_string(given) + " vertices in " +
                                            std::to_string(dimensions()) +
                                            " dimensions; a simplex has 1 to " +
                                            std::to_string(most) + ": divide others into such");
  });
}

}  // namespace abut
