#pragma once

#include "walls/mesh_features.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <compare>
#include <cstdint>

namespace abut::history {

/// A contact of a sphere and a wall; keys ascend as the lists of contacts do. A box is the interior
/// of its number, since it has one contact with a sphere.
struct WallKey {
  ElementIndex sphere = 0;
  walls::MovedFeature wall;

  friend constexpr auto operator<=>(const WallKey&, const WallKey&) = default;
};

/// Returns a + b. Beyond 32 bits there are no shifts: such a contact is found nowhere.
[[nodiscard]] inline ImageShift sum_of(const ImageShift& a, const ImageShift& b) noexcept {
  const auto sum = [](std::int32_t x, std::int32_t y) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(x) + static_cast<std::uint32_t>(y));
  };
  return {sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)};
}

}  // namespace abut::history
