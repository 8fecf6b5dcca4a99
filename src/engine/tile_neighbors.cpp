#include "engine/tile_neighbors.hpp"

namespace abut::engine {
namespace {

/// Whether an element near these faces may be within reach of the tile at that offset.
template <int Dim>
bool touches(std::uint32_t near_faces, const std::array<int, 3>& offset) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const bool lower = (near_faces >> (2 * axis) & 1) != 0;
    const bool upper = (near_faces >> (2 * axis + 1) & 1) != 0;
    if ((offset[axis] < 0 && !lower) || (offset[axis] > 0 && !upper)) return false;
  }
  return true;
}

}  // namespace

template <int Dim>
TileNeighbors<Dim>::TileNeighbors(const TileGrid<Dim>& grid) noexcept {
  constexpr int deep = Dim == 3 ? 1 : 0;
  for (std::uint32_t near_faces = 1; near_faces < combinations; ++near_faces) {
    for (int z = -deep; z <= deep; ++z) {
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
          const std::array<int, 3> offset{x, y, z};
          if (offset == std::array{0, 0, 0})
            lower_count_[near_faces] = count_[near_faces];
          else if (touches<Dim>(near_faces, offset)) {
            std::int32_t step = 0;
            for (std::size_t axis = 0; axis < Dim; ++axis) step += offset[axis] * grid.stride[axis];
            steps_[near_faces][count_[near_faces]++] = step;
          }
        }
      }
    }
  }
}

template class TileNeighbors<2>;
template class TileNeighbors<3>;

}  // namespace abut::engine
