#pragma once

#include "kernels/walls/wall_kernels.hpp"

#include <abut/triangle_mesh.hpp>

#include <span>

namespace abut::walls {

/// The frame in which a mesh that was moved is looked for: a center is brought back to where the
/// mesh was when its grid was built, and the distances at which parts must be found there are
/// bounded from above. docs/derivations/moving_walls.md proves the bound.
class RestFrame {
 public:
  /// The frame of a mesh whose rest position now differs from that of the grid, `anchor`, by at
  /// most `displacement` at each vertex.
  RestFrame(const TriangleMesh& mesh, double displacement) noexcept;

  /// The frame of parts that lie within `displacement` of where the grid has them, motion or not.
  [[nodiscard]] static RestFrame of_place(double displacement) noexcept {
    RestFrame frame;
    frame.offset_ = displacement;
    return frame;
  }

  /// Brings a point back.
  void bring_back(const double (&point)[3], double (&result)[3]) const noexcept {
    if (!is_moved_) {
      for (int axis = 0; axis < 3; ++axis) result[axis] = point[axis];
      return;
    }
    const double x = point[0] - translation_[0];
    const double y = point[1] - translation_[1];
    const double z = point[2] - translation_[2];
    for (int axis = 0; axis < 3; ++axis) {
      result[axis] = inverse_[axis][0] * x + inverse_[axis][1] * y + inverse_[axis][2] * z;
    }
  }

  /// Says how centers are brought back.
  void describe(kernels::WallJob& job) const noexcept;

  /// Returns the distance from the anchored mesh within which all lies that is within `reach` of
  /// the moved one.
  [[nodiscard]] double reach_at_rest(double reach) const noexcept {
    return (reach * factor_ + offset_) * (1.0 + 0x1p-40);
  }

 private:
  RestFrame() = default;

  double inverse_[3][3] = {};  ///< R^T
  double translation_[3] = {};
  bool is_moved_ = false;
  double factor_ = 1.0;
  double offset_ = 0.0;
};

/// Returns at least the largest distance between vertices of the same number, or infinity if they
/// are not as many.
[[nodiscard]] double largest_displacement(std::span<const TriangleMesh::Point> a,
                                          std::span<const TriangleMesh::Point> b) noexcept;

}  // namespace abut::walls
