#include "walls/grid/rest_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace abut::walls {
namespace {

/// Largest magnitude of a coordinate.
double farthest(std::span<const TriangleMesh::Point> points) noexcept {
  double result = 0.0;
  for (const auto& point : points) {
    for (const double x : point) result = std::max(result, std::fabs(x));
  }
  return result;
}

/// Frobenius norm of R^T R - 1, rounded up.
double deviation_from_rotation(const Motion& motion) noexcept {
  const auto& r = motion.rotation;
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      const double product = r[0][a] * r[0][b] + r[1][a] * r[1][b] + r[2][a] * r[2][b];
      const double off = product - (a == b ? 1.0 : 0.0);
      sum += off * off;
    }
  }
  return std::sqrt(sum) * (1.0 + 0x1p-40) + 0x1p-48;
}

}  // namespace

RestFrame::RestFrame(const TriangleMesh& mesh, double displacement) noexcept
    : is_moved_(mesh.motion() != Motion{}), offset_(displacement) {
  if (!is_moved_) return;
  const Motion& motion = mesh.motion();
  for (std::size_t a = 0; a < 3; ++a) {
    translation_[a] = motion.translation[a];
    for (std::size_t b = 0; b < 3; ++b) inverse_[a][b] = motion.rotation[b][a];
  }
  const double deviation = deviation_from_rotation(motion);
  factor_ = 1.0 + deviation;
  const double far = farthest(mesh.rest_vertices()) + displacement;
  const double sizes = far + farthest(mesh.vertices()) +
                       std::max({std::fabs(translation_[0]), std::fabs(translation_[1]),
                                 std::fabs(translation_[2])});
  // The last term is what is lost among the smallest numbers. Where products might overflow,
  // nothing is promised.
  const double rounding = 0x1p-44 * sizes * factor_ * factor_ + 0x1p-1066;
  offset_ = factor_ * (factor_ * displacement + rounding) + 2.0 * deviation * far + rounding;
  if (sizes > 0x1p1000) offset_ = std::numeric_limits<double>::infinity();
}

void RestFrame::describe(kernels::WallJob& job) const noexcept {
  job.is_moved = is_moved_;
  job.factor_of_reach = factor_;
  job.offset_of_reach = offset_;
  for (int row = 0; row < 3; ++row) {
    job.translation[row] = translation_[row];
    for (int axis = 0; axis < 3; ++axis) job.inverse[row][axis] = inverse_[row][axis];
  }
}

double largest_displacement(std::span<const TriangleMesh::Point> a,
                            std::span<const TriangleMesh::Point> b) noexcept {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      largest = std::max(largest, std::fabs(a[k][axis] - b[k][axis]));
    }
  }
  return 1.75 * largest;  // more than the root of 3
}

}  // namespace abut::walls
