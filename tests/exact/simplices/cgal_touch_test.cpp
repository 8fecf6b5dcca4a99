// Whether two simplices touch: the predicate beside CGAL's exact kernel (H. Brönnimann et al., CGAL
// Manual, 2D and 3D Linear Geometry Kernel), which takes no flat ones.

#include "exact/simplices/touch.hpp"

#include "scenes/random.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Segment_2.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Tetrahedron_3.h>
#include <CGAL/Triangle_2.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace abut::testing {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using exact::Simplex;
using scenes::Random;

Kernel::Point_2 of_cgal(const exact::Point<2>& p) {
  return {p[0], p[1]};
}
Kernel::Point_3 of_cgal(const exact::Point<3>& p) {
  return {p[0], p[1], p[2]};
}

template <class Shape, int Dim>
Shape of_cgal(const Simplex<Dim>& simplex) {
  const auto at = [&](std::size_t k) { return of_cgal(simplex.vertices[k]); };
  if constexpr (std::is_same_v<Shape, Kernel::Tetrahedron_3>) {
    return {at(0), at(1), at(2), at(3)};
  } else if constexpr (std::is_same_v<Shape, Kernel::Segment_2> ||
                       std::is_same_v<Shape, Kernel::Segment_3>) {
    return {at(0), at(1)};
  } else {
    return {at(0), at(1), at(2)};
  }
}

/// Half of the cases on a lattice of few points, so that ties abound; half with all their digits.
template <int Dim>
Simplex<Dim> random_simplex(std::size_t size, bool of_lattice, Random& random) {
  Simplex<Dim> simplex{};
  simplex.size = size;
  for (auto& vertex : simplex.vertices) {
    for (double& x : vertex) {
      x = of_lattice ? static_cast<double>(random.below(5)) : random.uniform();
    }
  }
  return simplex;
}

template <int Dim, class First, class Second>
void compare(std::size_t first_size, std::size_t second_size) {
  Random random(61 + first_size * 8 + second_size);
  std::size_t cases = 0, touching = 0;
  for (int k = 0; k < 8000; ++k) {
    const auto a = random_simplex<Dim>(first_size, k % 2 == 0, random);
    const auto b = random_simplex<Dim>(second_size, k % 2 == 0, random);
    const auto first = of_cgal<First>(a);
    const auto second = of_cgal<Second>(b);
    if (first.is_degenerate() || second.is_degenerate()) continue;
    std::uint64_t exact_decisions = 0;
    const bool expected = CGAL::do_intersect(first, second);
    ASSERT_EQ(exact::touch(a, b, exact_decisions), expected) << first << "\n" << second;
    ASSERT_EQ(exact::touch(b, a, exact_decisions), expected) << first << "\n" << second;
    ++cases;
    touching += expected ? 1 : 0;
  }
  EXPECT_GT(cases, 5000U);
  EXPECT_GT(touching, cases / 20);
  EXPECT_LT(touching, cases * 19 / 20);
}

TEST(CgalTouch, SegmentsInThePlane) {
  compare<2, Kernel::Segment_2, Kernel::Segment_2>(2, 2);
}
TEST(CgalTouch, SegmentsAndTrianglesInThePlane) {
  compare<2, Kernel::Segment_2, Kernel::Triangle_2>(2, 3);
}
TEST(CgalTouch, TrianglesInThePlane) {
  compare<2, Kernel::Triangle_2, Kernel::Triangle_2>(3, 3);
}
TEST(CgalTouch, SegmentsAndTriangles) {
  compare<3, Kernel::Segment_3, Kernel::Triangle_3>(2, 3);
}
TEST(CgalTouch, Triangles) {
  compare<3, Kernel::Triangle_3, Kernel::Triangle_3>(3, 3);
}
TEST(CgalTouch, TrianglesAndTetrahedra) {
  compare<3, Kernel::Triangle_3, Kernel::Tetrahedron_3>(3, 4);
}
TEST(CgalTouch, Tetrahedra) {
  compare<3, Kernel::Tetrahedron_3, Kernel::Tetrahedron_3>(4, 4);
}

}  // namespace
}  // namespace abut::testing
