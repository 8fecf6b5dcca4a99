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

  /// Calls body(step) for each tile that must see a copy; step: from its own tile's number.
  template <class Body>
  void for_each_of_native(std::uint32_t near_faces, Body&& body) const {
    for (const std::uint8_t k : offsets_near(near_faces).lower()) body(steps_[k]);
  }
  template <class Body>
  void for_each_of_foreign(std::uint32_t near_faces, Body&& body) const {
    for (const std::uint8_t k : offsets_near(near_faces).all()) body(steps_[k]);
  }

 private:
  static constexpr std::size_t neighbors = Dim == 3 ? 26 : 8;

  /// Numbers of the neighbours that an element near some faces lies near: those on the lower side
  /// first.
  struct Offsets {
    std::array<std::uint8_t, neighbors> numbers{};
    std::uint8_t lower_count = 0;
    std::uint8_t count = 0;

    [[nodiscard]] std::span<const std::uint8_t> lower() const noexcept {
      return std::span(numbers).first(lower_count);
    }
    [[nodiscard]] std::span<const std::uint8_t> all() const noexcept {
      return std::span(numbers).first(count);
    }
  };

  [[nodiscard]] static const Offsets& offsets_near(std::uint32_t near_faces) noexcept;

  std::array<std::int32_t, neighbors> steps_{};  ///< from the number of a tile to its neighbours'
};

}  // namespace abut::engine
