#include "walls/joined_vertices.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <cstdint>
#include <limits>

namespace abut::walls {
namespace {

std::int32_t checked(std::int64_t number) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (number >= -most && number <= most) return static_cast<std::int32_t>(number);
  throw Error(ErrorCode::invalid_input,
              "a triangle mesh reaches over more than 2147483647 cells from where its joined "
              "vertices are; move vertices and spheres into one cell");
}

/// a + sign * b
ImageShift added(const ImageShift& a, const ImageShift& b, std::int64_t sign) {
  return {checked(a.x + sign * b.x), checked(a.y + sign * b.y), checked(a.z + sign * b.z)};
}

}  // namespace

ImageShift sum(const ImageShift& a, const ImageShift& b) {
  return added(a, b, 1);
}

ImageShift difference(const ImageShift& a, const ImageShift& b) {
  return added(a, b, -1);
}

std::vector<VertexPlace> vertices_apart(std::size_t count) {
  std::vector<VertexPlace> places(count);
  for (std::size_t k = 0; k < count; ++k) places[k].number = static_cast<ElementIndex>(k);
  return places;
}

/// Points touch where they are the same. Being the same is transitive, so that the smallest number
/// at a place has a pair with each other one there; it comes first.
std::vector<VertexPlace> joined_vertices(std::span<const TriangleMesh::Point> vertices,
                                         const Domain& domain) {
  std::vector<VertexPlace> places = vertices_apart(vertices.size());
  const PairList pairs =
      find_contact_pairs(spheres(vertices, 0.0), domain, {.shifts = Shifts::stored});
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [first, second] = pairs[k];
    if (places[second].number == second) {
      places[second] = {first, difference({}, pairs.shifts()[k])};
    }
  }
  return places;
}

}  // namespace abut::walls
