#pragma once

#include <cstdint>

namespace abut::kernels {

/// The place of an element in 32 bits: its tile, and in the lowest bits the faces of the tile that
/// it lies near, two bits an axis (lower, upper). Search sets have fewer than 2^26 tiles.
inline constexpr int place_face_bits = 6;

[[nodiscard]] constexpr std::uint32_t packed_place(std::uint32_t tile,
                                                   std::uint32_t near_faces) noexcept {
  return tile << place_face_bits | near_faces;
}
[[nodiscard]] constexpr std::uint32_t tile_of_place(std::uint32_t place) noexcept {
  return place >> place_face_bits;
}
[[nodiscard]] constexpr std::uint32_t faces_of_place(std::uint32_t place) noexcept {
  return place & ((1u << place_face_bits) - 1);
}

}  // namespace abut::kernels
