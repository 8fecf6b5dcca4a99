#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/periodic/packed_cells.hpp"
#include "device/bodies/periodic/periodic_elements.hpp"
#include "device/levels.hpp"
#include "exact/lattice.hpp"
#include "grid/bounds.hpp"
#include "lattice/cell_extent.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/orthogonal_cell.hpp"
#include "lattice/reduced_lattice.hpp"
#include "lattice/wrap_rules.hpp"
#include "lattice/wrapper.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cmath>
#include <cstdint>

namespace abut::device {

/// What the host decides of the images of a detection, from extents that the device tells: the
/// steps of periodic::Images, in which no element is looked at.
template <int Dim>
class ImagePlan {
 public:
  /// Throws Error{invalid_input} as lattice::ReducedLattice does.
  ImagePlan(Shape shape, const exact::Lattice& given, double margin);

  /// Takes the extent of the elements as given. Throws Error{invalid_input} where their numbers
  /// exceed what can be told beside the lattice.
  void take_extent(const Extent<Dim>& extent);

  /// False in an open domain: nothing below is asked then.
  [[nodiscard]] bool has_images() const noexcept { return reduced_.count > 0; }

  /// Of spheres: sets the radius from which on spheres are large (lattice::choose_ghost_cut).
  void choose_size_cut(std::uint64_t elements, const SizeCounts& counts);

  /// Cell, wrapper along all sides, and what it moves is multiplied by, for elements as given.
  [[nodiscard]] const lattice::OrthogonalCell<Dim>& cell_as_given() const noexcept { return cell_; }
  [[nodiscard]] lattice::Wrapper<Dim> wrapper_of_all() const;
  [[nodiscard]] const lattice::ReducedLattice<Dim>& reduced() const noexcept { return reduced_; }
  [[nodiscard]] double given_unit() const noexcept { return given_unit_; }

  /// Takes their extent in that cell, times given_unit(), and chooses how they are moved.
  void take_extent_in_cell(const lattice::CellExtent<Dim>& extent);

  /// True if no element can be too far out, or too large, to be told by shifts.
  [[nodiscard]] bool is_in_range() const noexcept { return is_in_range_; }
  [[nodiscard]] bool moves_any() const noexcept { return moves_any_; }
  [[nodiscard]] lattice::Wrapper<Dim> wrapper() const;

  /// Of the numbers that elements are moved by.
  [[nodiscard]] PackedLayout packing_of_cells_moved() const noexcept;

  /// The cell that locals are in, which are all times unit(), and their extent in it.
  [[nodiscard]] double unit() const noexcept { return unit_; }
  [[nodiscard]] lattice::OrthogonalCell<Dim> cell_of_locals() const { return {reduced_, unit_}; }
  [[nodiscard]] bool needs_extent_of_locals() const noexcept { return moves_any_ || unit_ != 1.0; }
  void take_extent_of_locals(const lattice::CellExtent<Dim>& extent) noexcept { extent_ = extent; }

  /// Which images are ghosts. Throws where they cannot be told apart.
  [[nodiscard]] lattice::GhostWindows<Dim> windows() const;

  /// Of locals as given, and as they are moved, while there are no ghosts.
  [[nodiscard]] ImageMap<Dim> map_as_given() const {
    return map_of({reduced_, cell_, {}, {shape_, given_unit_, 1.0}}, 1.0);
  }
  [[nodiscard]] ImageMap<Dim> map_of_locals() const { return map_of(wrapper(), unit_); }
  /// Of elements as given, times unit_of_checks(), and images by vectors of the reduced basis.
  [[nodiscard]] ImageMap<Dim> map_of_basis() const;
  /// A power of two, beside given_unit(): squares of reaches are far from both ends of the range of
  /// exponents then.
  [[nodiscard]] double unit_of_checks() const noexcept { return unit_of_checks_; }
  /// Of windows().
  [[nodiscard]] ImageMap<Dim> map(const lattice::GhostWindows<Dim>& windows) const;
  /// Of the numbers of ghosts.
  [[nodiscard]] static PackedLayout packing_of_images(
      const lattice::GhostWindows<Dim>& windows) noexcept;
  /// How far the distance of two positions may be off, times unit().
  [[nodiscard]] double slack(const lattice::GhostWindows<Dim>& windows) const;
  [[nodiscard]] double margin() const noexcept { return margin_ * unit_; }
  [[nodiscard]] double margin_of_checks() const noexcept { return margin_ * unit_of_checks_; }

 private:
  [[nodiscard]] ImageMap<Dim> map_of(const lattice::Wrapper<Dim>& wrapper, double unit) const {
    return {wrapper, {}, given_unit_, unit, HUGE_VAL, false, true, {}, given_};
  }
  [[nodiscard]] lattice::GhostWindows<Dim> windows_in(const lattice::OrthogonalCell<Dim>& cell,
                                                      double unit) const;

  Shape shape_;
  exact::Lattice given_;
  grid::Bounds<Dim> bounds_;  ///< as given
  double given_unit_;
  double margin_as_given_;
  double margin_;  ///< and the rest times given_unit_
  lattice::ReducedLattice<Dim> reduced_;
  lattice::OrthogonalCell<Dim> cell_;
  double unit_ = 1.0;
  double unit_of_checks_ = 1.0;
  double size_cut_ = HUGE_VAL;
  lattice::CellExtent<Dim> extent_;
  lattice::AlongSides<Dim> along_{};
  std::array<double, Dim> cells_moved_at_most_{};
  bool is_in_range_ = false;
  bool moves_any_ = false;
};

}  // namespace abut::device
