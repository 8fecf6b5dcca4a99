#pragma once

#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace abut::benchmarks {

/// Triangles or tetrahedra of Corners vertices each, none of them shared.
template <std::size_t Corners>
struct SimplexScene {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<ElementIndex, Corners>> cells;
};

/// CGAL: `box_self_intersection_d` for the candidates, and `do_intersect` of the kernel with exact
/// predicates. A run ends with all pairs in memory.
template <std::size_t Corners>
class CgalSimplices {
 public:
  CgalSimplices();
  ~CgalSimplices();
  CgalSimplices(const CgalSimplices&) = delete;
  CgalSimplices& operator=(const CgalSimplices&) = delete;

  const std::vector<ContactPair>& run(const SimplexScene<Corners>& scene);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut::benchmarks
