#pragma once

#include "engine/tile_grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Which neighbouring tiles must see a copy of an element that lies near some faces of its own.
///
/// A native is copied to the neighbours on the *lower* side only (the contact mask of the book,
/// with tiles for cells): of two neighbouring tiles exactly one sees the other's elements, so that
/// a pair across the face is found once. A foreign is found by no tile but those that get a copy,
/// and goes to every neighbour that it lies near.
template <int Dim>
class TileNeighbors {
 public:
  explicit TileNeighbors(const TileGrid<Dim>& grid) noexcept;

  /// Steps from the number of its own tile to those of the others.
  [[nodiscard]] std::span<const std::int32_t> of_native(std::uint32_t near_faces) const noexcept {
    return std::span(steps_[near_faces]).first(lower_count_[near_faces]);
  }
  [[nodiscard]] std::span<const std::int32_t> of_foreign(std::uint32_t near_faces) const noexcept {
    return std::span(steps_[near_faces]).first(count_[near_faces]);
  }

 private:
  static constexpr std::size_t combinations = std::size_t{1} << (2 * Dim);
  static constexpr std::size_t most = Dim == 3 ? 26 : 8;

  std::array<std::array<std::int32_t, most>, combinations> steps_{};  ///< lower side first
  std::array<std::uint8_t, combinations> lower_count_{};
  std::array<std::uint8_t, combinations> count_{};
};

}  // namespace abut::engine
