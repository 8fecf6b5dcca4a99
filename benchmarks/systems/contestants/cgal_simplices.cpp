// CGAL's boxes, and its do_intersect (P. Alliez et al., CGAL Manual, 2D and 3D Linear Geometry
// Kernel).

#include "benchmarks/common/cgal_boxes.hpp"

#include "benchmarks/systems/simplex_contestant.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>
#include <vector>

namespace abut::benchmarks {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

}  // namespace

template <std::size_t Corners>
struct CgalSimplices<Corners>::State {
  using Shape = std::conditional_t<Corners == 3, Kernel::Triangle_3, Kernel::Tetrahedron_3>;

  static Shape shape(const SimplexScene<Corners>& scene, std::size_t number) {
    const auto at = [&](std::size_t k) {
      const auto& [x, y, z] = scene.vertices[scene.cells[number][k]];
      return Kernel::Point_3(x, y, z);
    };
    if constexpr (Corners == 3) {
      return {at(0), at(1), at(2)};
    } else {
      return {at(0), at(1), at(2), at(3)};
    }
  }

  static Bounds<double> side(const SimplexScene<Corners>& scene, std::size_t number,
                             std::size_t axis) {
    Bounds<double> bounds{scene.vertices[scene.cells[number][0]][axis],
                          scene.vertices[scene.cells[number][0]][axis]};
    for (const ElementIndex vertex : scene.cells[number]) {
      bounds.low = std::min(bounds.low, scene.vertices[vertex][axis]);
      bounds.high = std::max(bounds.high, scene.vertices[vertex][axis]);
    }
    return bounds;
  }

  CgalBoxes<3> boxes;
  std::vector<Shape> shapes;
  std::vector<ContactPair> pairs;
};

template <std::size_t Corners>
CgalSimplices<Corners>::CgalSimplices() : state_(std::make_unique<State>()) {}
template <std::size_t Corners>
CgalSimplices<Corners>::~CgalSimplices() = default;

template <std::size_t Corners>
const std::vector<ContactPair>& CgalSimplices<Corners>::run(const SimplexScene<Corners>& scene) {
  State& state = *state_;
  state.shapes.clear();
  state.pairs.clear();
  for (std::size_t k = 0; k < scene.cells.size(); ++k)
    state.shapes.push_back(State::shape(scene, k));
  state.boxes.fill(scene.cells.size(),
                   [&](std::size_t k, std::size_t axis) { return State::side(scene, k, axis); });
  state.boxes.for_each_pair([&](ElementIndex a, ElementIndex b) {
    if (!CGAL::do_intersect(state.shapes[a], state.shapes[b])) return;
    state.pairs.push_back({std::min(a, b), std::max(a, b)});
  });
  return state.pairs;
}

template class CgalSimplices<3>;
template class CgalSimplices<4>;

}  // namespace abut::benchmarks
