#include "engine/clusters/shelf_layout.hpp"

#include "base/asking_sort.hpp"
#include "exact/numbers/cube_root.hpp"

#include <algorithm>
#include <numeric>

namespace abut::engine {
namespace {

/// Where the next box goes, and how far the row and the shelf are filled.
template <int Dim>
class Shelves {
 public:
  using Vector = std::array<double, Dim>;

  /// No row is longer than `longest` along x, no shelf along y, but for a single box.
  Shelves(const Vector& longest, double clearance) : longest_(longest), clearance_(clearance) {}

  /// The corner of the next box.
  [[nodiscard]] Vector put(const Vector& size) {
    for (std::size_t axis = 0; axis + 1 < Dim; ++axis) {
      const bool is_first = next_[axis] == 0.0;
      if (!is_first && next_[axis] + size[axis] > longest_[axis]) start_behind(axis + 1);
    }
    const Vector corner = next_;
    next_[0] += size[0] + clearance_;
    for (std::size_t axis = 1; axis < Dim; ++axis) {
      deepest_[axis] = std::max(deepest_[axis], size[axis] + clearance_);
    }
    return corner;
  }

 private:
  /// Starts a row, or a shelf, behind what was filled along an axis.
  void start_behind(std::size_t axis) {
    next_[axis] += deepest_[axis];
    for (std::size_t before = 0; before < axis; ++before) next_[before] = 0.0;
    for (std::size_t up_to = 1; up_to <= axis; ++up_to) deepest_[up_to] = 0.0;
  }

  Vector longest_;
  double clearance_;
  Vector next_{};
  Vector deepest_{};
};

/// Sides of about a cube, or square, that has the volume of all boxes with what keeps them apart,
/// and in which each of them fits.
template <int Dim>
std::array<double, Dim> sides_of_all(std::span<const std::array<double, Dim>> sizes,
                                     double clearance) {
  std::array<double, Dim> sides{};
  double cells = 0.0;
  for (const auto& size : sizes) {
    double its_cells = 1.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      its_cells *= size[axis] / clearance + 1.0;
      sides[axis] = std::max(sides[axis], size[axis]);
    }
    cells += its_cells;
  }
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double side = exact::side_of(cells, static_cast<int>(Dim - axis));
    sides[axis] = std::max(sides[axis], side * clearance);
    cells /= sides[axis] / clearance;
  }
  return sides;
}

}  // namespace

template <int Dim>
ShelfLayout<Dim>::ShelfLayout(base::MemoryMeter& memory)
    : corners_(base::make_array_for_overwrite<Vector>(memory, 0)),
      by_height_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim>
void ShelfLayout<Dim>::place(std::span<const Vector> sizes, double clearance,
                             base::WorkCounter& work) {
  base::make_room(corners_, sizes.size());
  base::make_room(by_height_, sizes.size());
  const std::span by_height = std::span(by_height_).first(sizes.size());
  std::iota(by_height.begin(), by_height.end(), std::uint32_t{0});
  base::sort_asking(by_height.begin(), by_height.end(), work,
                    [&](std::uint32_t a, std::uint32_t b) {
                      const double height_a = sizes[a][Dim - 1];
                      const double height_b = sizes[b][Dim - 1];
                      return height_a != height_b ? height_a > height_b : a < b;
                    });
  Shelves<Dim> shelves(sides_of_all<Dim>(sizes, clearance), clearance);
  for (const std::uint32_t k : by_height) corners_[k] = shelves.put(sizes[k]);
  work.did(sizes.size());
}

template class ShelfLayout<2>;
template class ShelfLayout<3>;

}  // namespace abut::engine
