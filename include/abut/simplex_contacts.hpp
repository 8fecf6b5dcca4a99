#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/fit_boxes.hpp>
#include <abut/image_shift.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <cstddef>

namespace abut {

/// Simplices, seen through the caller's arrays: segments, triangles or, in 3D, tetrahedra, the
/// closed convex hulls of the vertices that each cell names. A cell may also be a single point.
/// Vertices of a cell may coincide, lie on a line or in a plane. A view owns nothing.
///
/// `simplices_3d` and `simplices_2d` make views of arrays of points.
class SimplexView {
 public:
  /// Views cells of vertices that are the centers of a view. Throws Error{wrong_usage} for vertices
  /// that are boxes, and for cells of no vertices or of more than a simplex has.
  ABUT_API SimplexView(const ElementView& vertices, const Connectivity& cells);

  /// Number of simplices.
  [[nodiscard]] std::size_t size() const noexcept { return cells_.size(); }
  /// Number of dimensions, 2 or 3.
  [[nodiscard]] int dimensions() const noexcept { return vertices_.dimensions(); }
  /// Vertices of all cells.
  [[nodiscard]] const ElementView& vertices() const noexcept { return vertices_; }
  /// Numbers of the vertices of each cell.
  [[nodiscard]] const Connectivity& cells() const noexcept { return cells_; }

 private:
  ElementView vertices_;
  Connectivity cells_;
};

/// Views cells of vertices that are points of three numbers.
template <class Points>
requires detail::PointsOf<Points, 3>
[[nodiscard]] SimplexView simplices_3d(Points&& vertices, const Connectivity& cells) {
  return {spheres(static_cast<Points&&>(vertices), 0.0), cells};
}
/// Views cells of vertices that are points of two numbers.
template <class Points>
requires detail::PointsOf<Points, 2>
[[nodiscard]] SimplexView simplices_2d(Points&& vertices, const Connectivity& cells) {
  return {discs(static_cast<Points&&>(vertices), 0.0), cells};
}

/// What counts for simplices that name the same vertex, as neighbors in a mesh do. Vertices of
/// different numbers at one place are not the same vertex, nor are a vertex and its image.
enum class SharedVertices {
  touching,  ///< they touch, as all others with a point in common do
  excluded,  ///< they are no contact, whatever else they have in common
};

/// Finds the contacts of simplices in open space: all pairs of which the closed sets have a point
/// in common, decided in real arithmetic on the given numbers. Flat ones count as what they are;
/// touching counts, and so does one inside the other.
///
/// Of the options, `algorithm`, `order`, `rule`, `max_pairs`, `max_bytes`, `threads`, `simd` and
/// `progress` mean what they mean for boxes, the candidates being the pairs whose boxes touch.
/// `Statistics::candidate_tests` counts these, and `exact_decisions` those that filters left open.
///
/// Throws what find_contact_pairs throws, and
///
/// * Error{invalid_input}: a vertex number that does not exist, a vertex of a cell that is not
///   finite;
/// * Error{wrong_usage}: a margin or quantities, which simplices do not have.
[[nodiscard]] ABUT_API PairList
find_simplex_contacts(const SimplexView& simplices, const Options& options = {},
                      SharedVertices shared = SharedVertices::touching);

/// Finds the contacts of simplices in a domain. In a periodic one a contact is (i, j, n): simplex i
/// and simplex j with vertices x + n A, in real arithmetic, have a point in common. Each image
/// counts once, as in the contract of boxes, also images of a simplex itself. `Options::shifts`
/// stores n. The algorithm must support periodic domains.
[[nodiscard]] ABUT_API PairList find_simplex_contacts(
    const SimplexView& simplices, const Domain& domain, const Options& options = {},
    SharedVertices shared = SharedVertices::touching);

/// Finds the contacts of simplices of one set with those of another, of any number of vertices:
/// (i of the first, j of the second). `SharedVertices::excluded` asks for two sets of the same
/// vertices; otherwise it throws Error{wrong_usage}.
[[nodiscard]] ABUT_API PairList find_simplex_contacts(
    const SimplexView& first, const SimplexView& second, const Options& options = {},
    SharedVertices shared = SharedVertices::touching);

/// Finds the contacts of two sets in a domain.
[[nodiscard]] ABUT_API PairList find_simplex_contacts(
    const SimplexView& first, const SimplexView& second, const Domain& domain,
    const Options& options = {}, SharedVertices shared = SharedVertices::touching);

/// Decides for a pair whether both simplices have a point in common: `pair.first` of the first set
/// and `pair.second` of the second, which may be the same view. Throws Error{wrong_usage} for a
/// simplex that is not there and for sets of unequal dimensions, and Error{invalid_input} as
/// find_simplex_contacts does.
[[nodiscard]] ABUT_API bool touching(const SimplexView& first, const SimplexView& second,
                                     ContactPair pair);

/// Decides it for the first simplex and the image of the second that `shift` names, in a domain.
/// The shift is 0 on axes that are not periodic; another throws Error{wrong_usage}.
[[nodiscard]] ABUT_API bool touching(const SimplexView& first, const SimplexView& second,
                                     const Domain& domain, ContactPair pair,
                                     const ImageShift& shift);

}  // namespace abut
