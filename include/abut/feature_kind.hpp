#pragma once

#include <abut/export.hpp>

#include <cstdint>

namespace abut {

/// Kind of the part of a body that a sphere touches.
enum class FeatureKind : std::uint32_t {
  interior,  ///< inside of a solid, in 2D of an area, without its boundary
  face,      ///< face without its edges
  edge,      ///< edge without its ends
  vertex,    ///< point where edges end
};

}  // namespace abut
