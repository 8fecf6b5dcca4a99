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

/// The place of vertex `number`, moved by a lattice shift.
struct VertexPlace {
  ElementIndex number = 0;
  ImageShift shift;

  friend constexpr auto operator<=>(const VertexPlace&, const VertexPlace&) = default;
};

/// Returns vertices of which none is joined: each at its own place.
[[nodiscard]] std::vector<VertexPlace> vertices_apart(std::size_t count);

/// Joins vertices that lie, exactly, at the same place or at an image of it: returns for each the
/// smallest number among them and the shift to it. Throws as find_contact_pairs does.
[[nodiscard]] std::vector<VertexPlace> joined_vertices(
    std::span<const TriangleMesh::Point> vertices, const Domain& domain);

/// Throw Error{invalid_input} for what 32 bits do not hold.
[[nodiscard]] ImageShift sum(const ImageShift& a, const ImageShift& b);
[[nodiscard]] ImageShift difference(const ImageShift& a, const ImageShift& b);

}  // namespace abut::walls
