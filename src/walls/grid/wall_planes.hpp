#pragma once

#include "base/array.hpp"
#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "kernels/walls/wall_kernels.hpp"
#include "walls/grid/wall_grid.hpp"

#include <abut/pair.hpp>
#include <abut/triangle_mesh.hpp>

#include <cmath>
#include <cstddef>
#include <span>

namespace abut::walls {

/// Planes that tell of most points near a wall that they are out of reach of it: one for each
/// triangle, and for each cell of the grid two parallel ones with all its triangles between them.
/// docs/derivations/moving_walls.md proves that nothing within reach is left out.
class WallPlanes {
 public:
  using Points = std::span<const TriangleMesh::Point>;
  using Triangles = std::span<const TriangleMesh::Corners>;

  explicit WallPlanes(base::MemoryMeter& memory);

  /// Lays the planes of the triangles of a grid, and of its cells. Reaches will not exceed `reach`.
  void build(Points vertices, Triangles triangles, const WallGrid& grid, double reach,
             base::WorkCounter& work);

  /// Returns what is_far_from_* must be asked with for a distance from the triangles.
  [[nodiscard]] double allowing_for_errors(double reach) const noexcept { return reach + error_; }

  /// Says what the planes of cells are.
  void describe(kernels::WallJob& job) const noexcept {
    job.planes = cells_.data();
    job.error_of_planes = error_;
  }

  /// Tells whether a point is out of reach of all triangles of a cell.
  [[nodiscard]] bool is_far_from_cell(const double (&point)[3], std::size_t place,
                                      double reach) const noexcept {
    const CellPlanes& planes = cells_[place];
    const auto& [x, y, z] = planes.normal;
    const double height = double{x} * point[0] + double{y} * point[1] + double{z} * point[2];
    return std::fabs(height - planes.offset) > double{planes.half_width} + reach;
  }

  /// Tells whether a point is out of reach of a triangle.
  [[nodiscard]] bool is_far_from_triangle(const double (&point)[3], ElementIndex triangle,
                                          double reach) const noexcept {
    return std::fabs(triangles_[triangle].height_of(point)) > reach;
  }

 private:
  struct Plane {
    double normal[3];  ///< of length one, or 0 where there is none
    double offset;     ///< normal times a point of the plane

    [[nodiscard]] double height_of(const double (&point)[3]) const noexcept {
      return normal[0] * point[0] + normal[1] * point[1] + normal[2] * point[2] - offset;
    }
  };
  using CellPlanes = kernels::CellPlanes;

  void lay_triangles(Points vertices, Triangles triangles, double reach);
  [[nodiscard]] CellPlanes planes_around(std::span<const ElementIndex> parts, Points vertices,
                                         Triangles triangles) const noexcept;

  base::Array<Plane> triangles_;
  base::Array<CellPlanes> cells_;
  double error_ = 0.0;  ///< of heights
};

}  // namespace abut::walls
