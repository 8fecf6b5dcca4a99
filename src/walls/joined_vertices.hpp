#pragma once

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/triangle_mesh.hpp>

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace abut::walls {

/// Where vertex `number` is, moved by n A.
struct VertexPlace {
  ElementIndex number = 0;
  ImageShift shift;

  friend constexpr auto operator<=>(const VertexPlace&, const VertexPlace&) = default;
};

/// Each at its own.
[[nodiscard]] std::vector<VertexPlace> vertices_apart(std::size_t count);

/// Of each vertex, where it is by the smallest number of those at the same place or an image of it;
/// exactly. Throws as find_contact_pairs does.
[[nodiscard]] std::vector<VertexPlace> joined_vertices(
    std::span<const TriangleMesh::Point> vertices, const Domain& domain);

/// Throw Error{invalid_input} for what 32 bits do not hold.
[[nodiscard]] ImageShift sum(const ImageShift& a, const ImageShift& b);
[[nodiscard]] ImageShift difference(const ImageShift& a, const ImageShift& b);

}  // namespace abut::walls
