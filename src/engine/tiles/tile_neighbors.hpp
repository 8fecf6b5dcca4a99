#pragma once

#include "engine/tiles/tile_grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Offsets to all neighbours of a tile, ascending: the first half is its lower side.
template <int Dim>
[[gnu::visibility("hidden")]] inline constexpr auto neighbor_offsets = [] {
  std::array<std::array<int, 3>, Dim == 3 ? 26 : 8> result{};
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

/// Numbers of the neighbours that an element near some faces lies near, ascending.
template <int Dim>
struct NearNeighbors {
  std::array<std::uint8_t, neighbor_offsets<Dim>.size()> numbers{};
  std::uint8_t lower_count = 0;
  std::uint8_t count = 0;
};

/// Neighbours that need a copy of an element, for each set of faces that it lies near
/// (TileGrid::TilePlace).
template <int Dim>
[[gnu::visibility("hidden")]] inline constexpr auto near_neighbors = [] {
  std::array<NearNeighbors<Dim>, std::size_t{1} << (2 * Dim)> result{};
  constexpr std::size_t neighbors = neighbor_offsets<Dim>.size();
  for (std::uint32_t faces = 0; faces < result.size(); ++faces) {
    NearNeighbors<Dim>& near = result[faces];
    for (std::size_t k = 0; k < neighbors; ++k) {
      if (k == neighbors / 2) near.lower_count = near.count;
      bool touches = true;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        const int offset = neighbor_offsets<Dim>[k][axis];
        if (offset < 0) touches = touches && (faces >> (2 * axis) & 1) != 0;
        if (offset > 0) touches = touches && (faces >> (2 * axis + 1) & 1) != 0;
      }
      if (touches) near.numbers[near.count++] = static_cast<std::uint8_t>(k);
    }
  }
  return result;
}();

/// The neighbouring tiles that must see a copy of an element that lies near some faces of its own.
///
/// A local element is copied to the neighbours on the *lower* side only (the contact mask of the
/// book, with tiles for cells): of two neighbouring tiles exactly one sees the other's elements, so
/// that a pair across the face is found once. A halo element is found by no tile but those that get
/// a copy, and goes to every neighbour that it lies near.
template <int Dim>
class TileNeighbors {
 public:
  explicit TileNeighbors(const TileGrid<Dim>& grid) noexcept {
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        steps_[k] += neighbor_offsets<Dim>[k][axis] * grid.stride[axis];
      }
    }
  }

  [[nodiscard]] static std::span<const std::uint8_t> of_local(std::uint32_t near_faces) noexcept {
    const NearNeighbors<Dim>& near = near_neighbors<Dim>[near_faces];
    return std::span(near.numbers).first(near.lower_count);
  }
  [[nodiscard]] static std::span<const std::uint8_t> of_halo(std::uint32_t near_faces) noexcept {
    const NearNeighbors<Dim>& near = near_neighbors<Dim>[near_faces];
    return std::span(near.numbers).first(near.count);
  }

  /// The tile that is neighbour number k of this one.
  [[nodiscard]] std::size_t from(std::size_t tile, std::uint8_t k) const noexcept {
    return tile + static_cast<std::size_t>(std::int64_t{steps_[k]});
  }

 private:
  std::array<std::int32_t, neighbor_offsets<Dim>.size()> steps_{};
};

}  // namespace abut::engine
