#include "device/image_plan.hpp"

#include "grid/scaling.hpp"
#include "lattice/check_range.hpp"
#include "lattice/ghost_cut.hpp"
#include "lattice/lattice_unit.hpp"
#include "lattice/turn_downwards.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace abut::device {
namespace {

template <int Dim>
grid::Bounds<Dim> bounds_of(const Extent<Dim>& extent) {
  grid::Bounds<Dim> bounds;
  std::copy_n(extent.lower, Dim, bounds.lower.begin());
  std::copy_n(extent.upper, Dim, bounds.upper.begin());
  bounds.smallest_radius = extent.smallest_radius;
  bounds.largest_radius = extent.largest_radius;
  bounds.second_largest_radius = extent.second_largest_radius;
  return bounds;
}

template <int Dim>
lattice::ReducedLattice<Dim> reduced_for(Shape shape, const exact::Lattice& lattice) {
  lattice::ReducedLattice<Dim> reduced(lattice);
  if (shape == Shape::box) lattice::turn_downwards(reduced);
  return reduced;
}

/// What is not moved stays as it is.
template <int Dim>
double unit_of(const lattice::ReducedLattice<Dim>& lattice, double largest) {
  return lattice.count == 0 ? 1.0 : lattice::unit_of_moved(lattice, largest);
}

/// Brings reaches near 1, unless that would make the largest number too large, or the unit together
/// with the one that all is given times. All lengths are times that unit.
double unit_of_reach(double radius, double margin, double largest, double given_unit) {
  constexpr int farthest = 1000;
  const double longest = std::max(radius, margin);
  if (longest == 0.0) return 1.0;
  const int most = farthest - std::max(std::ilogb(given_unit), std::ilogb(largest));
  return std::ldexp(1.0, std::clamp(-std::ilogb(longest), -farthest, most));
}

/// Counts by size, the smallest class first, of radii times a unit.
struct SizesOfCounts {
  SizeCounts counts;
  std::uint32_t largest_half_octave;
  double unit;

  [[nodiscard]] std::size_t classes() const noexcept {
    return std::min(size_classes - 1, largest_half_octave) + 1;
  }
  [[nodiscard]] double count(std::size_t k) const noexcept {
    return static_cast<double>(counts[classes() - 1 - k]);
  }
  [[nodiscard]] double end(std::size_t k) const noexcept {
    const auto below = static_cast<std::uint32_t>(classes() - 1 - k);
    return end_of_half_octave(largest_half_octave - below) * unit;
  }
};

}  // namespace

template <int Dim>
ImagePlan<Dim>::ImagePlan(Shape shape, const exact::Lattice& given, double margin)
    : shape_(shape),
      given_(given),
      given_unit_(lattice::unit_of<Dim>(given, margin)),
      margin_as_given_(margin),
      margin_(margin * given_unit_),
      reduced_(
          reduced_for<Dim>(shape, given_unit_ == 1.0 ? given : lattice::times(given, given_unit_))),
      cell_(reduced_, 1.0) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!given_.periodic[k]) given_.vectors[k] = {};
  }
}

template <int Dim>
void ImagePlan<Dim>::take_extent(const Extent<Dim>& extent) {
  bounds_ = bounds_of(extent);
  const double largest = grid::largest_number(bounds_, margin_as_given_);
  static_cast<void>(lattice::unit_of<Dim>(given_, largest));
  unit_ = unit_of(reduced_, largest * given_unit_);
  unit_of_checks_ = unit_of_reach(bounds_.largest_radius * given_unit_, margin_,
                                  largest * given_unit_, given_unit_);
}

template <int Dim>
void ImagePlan<Dim>::choose_size_cut(std::uint64_t elements, const SizeCounts& counts) {
  if (!(bounds_.smallest_radius < bounds_.largest_radius)) return;
  size_cut_ = lattice::choose_ghost_cut(
      static_cast<double>(elements), bounds_.largest_radius * given_unit_, reduced_, margin_, [&] {
        return SizesOfCounts{counts, half_octave_of(bounds_.largest_radius), given_unit_};
      });
}

template <int Dim>
lattice::Wrapper<Dim> ImagePlan<Dim>::wrapper_of_all() const {
  lattice::AlongSides<Dim> all{};
  all.fill(true);
  return {reduced_, cell_, all, {shape_, given_unit_, unit_}};
}

template <int Dim>
lattice::Wrapper<Dim> ImagePlan<Dim>::wrapper() const {
  return {reduced_, cell_, along_, {shape_, given_unit_, unit_}};
}

template <int Dim>
void ImagePlan<Dim>::take_extent_in_cell(const lattice::CellExtent<Dim>& extent) {
  extent_ = extent;
  const lattice::GhostWindow<Dim> window = windows_in(cell_, 1.0).of_large;
  is_in_range_ = given_unit_ == 1.0 && lattice::is_in_range<Dim>(cell_, extent_, window);
  along_ = lattice::sides_to_wrap<Dim>(cell_, extent_, window);
  moves_any_ = std::count(along_.begin(), along_.end(), true) > 0;
  cells_moved_at_most_ = lattice::most_cells_moved<Dim>(cell_, extent_, along_);
}

template <int Dim>
PackedLayout ImagePlan<Dim>::packing_of_cells_moved() const noexcept {
  PackedLayout packing;
  for (const double most : cells_moved_at_most_) packing.add_side(most);
  return packing;
}

template <int Dim>
PackedLayout ImagePlan<Dim>::packing_of_images(const lattice::GhostWindows<Dim>& windows) noexcept {
  PackedLayout packing;
  for (std::size_t side = 0; side < windows.of_large.sides(); ++side) {
    packing.add_side(windows.of_large.most_cells(side));
  }
  return packing;
}

template <int Dim>
lattice::GhostWindows<Dim> ImagePlan<Dim>::windows_in(const lattice::OrthogonalCell<Dim>& cell,
                                                      double unit) const {
  const lattice::Reaches reaches{bounds_.largest_radius * given_unit_ * unit, margin_ * unit,
                                 shape_};
  return {reduced_, cell, extent_, reaches, size_cut_ * unit, unit};
}

template <int Dim>
lattice::GhostWindows<Dim> ImagePlan<Dim>::windows() const {
  const lattice::GhostWindows<Dim> windows = windows_in(cell_of_locals(), unit_);
  for (std::size_t side = 0; side < cell_.count; ++side) {
    lattice::require_narrow_window(windows.of_large.most_cells(side));
  }
  return windows;
}

template <int Dim>
ImageMap<Dim> ImagePlan<Dim>::map_of_basis() const {
  ImageMap<Dim> map =
      map_of({reduced_, cell_, {}, {shape_, given_unit_, unit_of_checks_}}, unit_of_checks_);
  map.shifts_always_fit = false;
  for (std::size_t k = 0; k < reduced_.count; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      map.steps[k][axis] = reduced_.vectors[k][axis] * unit_of_checks_;
    }
    for (std::size_t l = 0; l < reduced_.count; ++l) {
      map.shift_of_side[k][reduced_.axis_of[l]] = reduced_.to_given[k][l];
    }
  }
  return map;
}

template <int Dim>
ImageMap<Dim> ImagePlan<Dim>::map(const lattice::GhostWindows<Dim>& windows) const {
  const std::array<double, 3> shifts =
      lattice::most_shifts<Dim>(reduced_, cell_, windows.of_large, cells_moved_at_most_);
  ImageMap<Dim> map{wrapper(),
                    lattice::side_steps<Dim>(reduced_, cell_, unit_),
                    given_unit_,
                    unit_,
                    size_cut_ * unit_,
                    size_cut_ <= bounds_.largest_radius * given_unit_,
                    std::all_of(shifts.begin(), shifts.end(),
                                [](double n) { return n < lattice::largest_bound_of_shifts; }),
                    {},
                    given_};
  for (std::size_t side = 0; side < cell_.count; ++side) {
    for (std::size_t l = 0; l < reduced_.count; ++l) {
      map.shift_of_side[side][reduced_.axis_of[l]] = reduced_.to_given[cell_.vector_of[side]][l];
    }
  }
  return map;
}

template <int Dim>
double ImagePlan<Dim>::slack(const lattice::GhostWindows<Dim>& windows) const {
  const double width =
      shape_ == Shape::box ? 2.0 * (bounds_.largest_radius * given_unit_ * unit_) : 0.0;
  return lattice::slack_of_ghosts *
         lattice::magnitude_of<Dim>(extent_, windows.of_large, along_,
                                    lattice::side_steps<Dim>(reduced_, cell_, unit_), width);
}

template class ImagePlan<2>;
template class ImagePlan<3>;

}  // namespace abut::device
