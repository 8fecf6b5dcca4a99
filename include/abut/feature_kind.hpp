#pragma once

#include <abut/export.hpp>

#include <cstdint>

namespace abut {

/// What part of a body a sphere touches.
enum class FeatureKind : std::uint32_t {
  interior,  ///< the inside of a solid, in 2D of an area, without its boundary
  face,      ///< without its edges
  edge,      ///< without its ends
  vertex,
};

}  // namespace abut
