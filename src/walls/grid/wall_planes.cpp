#include "walls/grid/wall_planes.hpp"

#include <algorithm>
#include <limits>

namespace abut::walls {
namespace {

double dot(const double (&a)[3], const TriangleMesh::Point& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length_of(const double (&a)[3]) noexcept {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

}  // namespace

WallPlanes::WallPlanes(base::MemoryMeter& memory)
    : triangles_(base::make_array_for_overwrite<Plane>(memory, 0)),
      cells_(base::make_array_for_overwrite<CellPlanes>(memory, 0)) {}

void WallPlanes::build(Points vertices, Triangles triangles, const WallGrid& grid, double reach,
                       base::WorkCounter& work) {
  lay_triangles(vertices, triangles, reach);
  base::resize_for_overwrite(cells_, grid.places());
  for (std::size_t place = 0; place < cells_.size(); ++place) {
    cells_[place] = planes_around(grid.parts(place), vertices, triangles);
    work.did(4 * grid.parts(place).size());
  }
}

/// The normal of a triangle in which products cancel too much errs too much, and is left out; so is
/// all beyond ordinary numbers. Of the others each component errs by less than 2^-30.
void WallPlanes::lay_triangles(Points vertices, Triangles triangles, double reach) {
  base::resize_for_overwrite(triangles_, triangles.size());
  double farthest = reach;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto& [a, b, c] = triangles[k];
    const auto& p = vertices[a];
    double e[3], f[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e[axis] = vertices[b][axis] - p[axis];
      f[axis] = vertices[c][axis] - p[axis];
      farthest = std::max({farthest, std::fabs(p[axis]), std::fabs(vertices[b][axis]),
                           std::fabs(vertices[c][axis])});
    }
    const double normal[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                              e[0] * f[1] - e[1] * f[0]};
    const double length = length_of(normal);
    const double sizes = std::sqrt((e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) *
                                   (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
    Plane& plane = triangles_[k] = {};
    const bool is_certain = length > 0x1p-16 * sizes && length < 2.0 * sizes;
    if (!(is_certain && length > 0x1p-200 && sizes < 0x1p200)) continue;
    const double inverse = 1.0 / length;
    for (std::size_t axis = 0; axis < 3; ++axis) plane.normal[axis] = normal[axis] * inverse;
    plane.offset = dot(plane.normal, p);
  }
  error_ = farthest < 0x1p1000 ? 0x1p-26 * farthest : std::numeric_limits<double>::infinity();
}

/// The normal is the mean of those of the triangles, whatever way round they are. Any direction is
/// allowed: all corners lie between the planes.
WallPlanes::CellPlanes WallPlanes::planes_around(std::span<const ElementIndex> parts,
                                                 Points vertices,
                                                 Triangles triangles) const noexcept {
  double sum[3] = {};
  for (const ElementIndex part : parts) {
    const double(&normal)[3] = triangles_[part].normal;
    const double side = normal[0] * sum[0] + normal[1] * sum[1] + normal[2] * sum[2];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[axis] += side < 0.0 ? -normal[axis] : normal[axis];
    }
  }
  CellPlanes planes{};
  const double length = length_of(sum);
  if (!(length > 0.5)) return planes;
  double normal[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    planes.normal[axis] = static_cast<float>(sum[axis] / length * (1.0 - 0x1p-20));
    normal[axis] = planes.normal[axis];
  }
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const ElementIndex part : parts) {
    for (const auto corner : triangles[part]) {
      const double height = dot(normal, vertices[corner]);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  }
  const double half_width = (0.5 * highest - 0.5 * lowest) * (1.0 + 0x1p-20);
  if (!(half_width < 0x1p127)) return {};
  planes.offset = 0.5 * lowest + 0.5 * highest;
  planes.half_width = static_cast<float>(half_width);
  return planes;
}

}  // namespace abut::walls
