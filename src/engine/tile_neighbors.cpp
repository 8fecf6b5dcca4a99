#include "engine/tile_neighbors.hpp"

namespace abut::engine {
namespace {

using Offset = std::array<int, 3>;

/// All neighbours but the tile itself, ascending: those before it are its lower side.
template <int Dim>
constexpr auto neighbor_offsets = [] {
  std::array<Offset, Dim == 3 ? 26 : 8> result{};
  constexpr int deep = Dim == 3 ? 1 : 0;
  std::size_t k = 0;
  for (int z = -deep; z <= deep; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (x != 0 || y != 0 || z != 0) result[k++] = {x, y, z};
      }
    }
  }
  return result;
}();

/// Whether an element near these faces may be within reach of the tile at that offset.
template <int Dim>
constexpr bool touches(std::uint32_t near_faces, const Offset& offset) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const bool lower = (near_faces >> (2 * axis) & 1) != 0;
    const bool upper = (near_faces >> (2 * axis + 1) & 1) != 0;
    if ((offset[axis] < 0 && !lower) || (offset[axis] > 0 && !upper)) return false;
  }
  return true;
}

}  // namespace

template <int Dim>
auto TileNeighbors<Dim>::offsets_near(std::uint32_t near_faces) noexcept -> const Offsets& {
  static constexpr auto table = [] {
    std::array<Offsets, std::size_t{1} << (2 * Dim)> result{};
    for (std::uint32_t faces = 0; faces < result.size(); ++faces) {
      Offsets& offsets = result[faces];
      for (std::uint8_t k = 0; k < neighbors; ++k) {
        if (k == neighbors / 2) offsets.lower_count = offsets.count;
        if (touches<Dim>(faces, neighbor_offsets<Dim>[k])) offsets.numbers[offsets.count++] = k;
      }
    }
    return result;
  }();
  return table[near_faces];
}

template <int Dim>
TileNeighbors<Dim>::TileNeighbors(const TileGrid<Dim>& grid) noexcept {
  for (std::size_t k = 0; k < neighbors; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      steps_[k] += neighbor_offsets<Dim>[k][axis] * grid.stride[axis];
    }
  }
}

template class TileNeighbors<2>;
template class TileNeighbors<3>;

}  // namespace abut::engine
