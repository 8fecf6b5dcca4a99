#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "kernels/images/image_kernels.hpp"
#include "lattice/cell_extent.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/reduced_lattice.hpp"
#include "lattice/wrap_rules.hpp"
#include "lattice/wrapper.hpp"
#include "periodic/list_ghosts.hpp"
#include "periodic/moved_cells.hpp"
#include "periodic/place_ghosts.hpp"
#include "periodic/place_locals.hpp"

#include <abut/element_view.hpp>
#include <abut/pair.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace abut::periodic {

struct ImageSettings {
  double margin = 0.0;
  std::size_t workers = 1;
  kernels::ImageKernels kernels;
  Shape shape = Shape::sphere;
  double size_cut = HUGE_VAL;  ///< GhostWindows::cut, of spheres
  /// Spheres from which on those in one cell of oblique vectors stay there.
  std::size_t least_in_oblique_cell = 0;
  double given_unit = 1.0;  ///< what elements, lattice and all lengths are given times
  base::ProgressReporter* progress = nullptr;  ///< asked now and then, by the first worker
};

/// Everything that a search in open space needs in order to find every pair of a periodic domain
/// exactly once: the elements themselves in about one cell, the *locals*, and copies of some of
/// them around it, the *ghosts*. Pairs among locals and of each local element with each ghost that
/// counts for it, its own included, are all the pairs, each once; ghosts do not pair with ghosts.
/// docs/derivations/periodic_images.md has the proof.
///
/// Locals and ghosts are a little off where they were moved: the distance of two of them, here, by
/// at most slack(). Whether a pair is within reach is decided on the caller's elements, by
/// exact::within_reach with the shift that shift_between tells. Boxes come as their stand-ins
/// (exact::Elements).
template <int Dim>
class Images {
 public:
  explicit Images(base::MemoryMeter& memory);

  /// Finds the images of the elements of a detection; `bounds` are theirs. Where no element must be
  /// moved, ghosts are appended to `elements`, whose first numbers stay what they are. Elements and
  /// lattice must live on. The result does not depend on the number of workers.
  ///
  /// Throws Error{invalid_input} when an element lies more than 2^31 - 1 cells outside, and
  /// Error{limit_exceeded} when there are more locals and ghosts than elements can be numbered.
  void find(base::Array<exact::Sphere<Dim>>& elements, const grid::Bounds<Dim>& bounds,
            const lattice::ReducedLattice<Dim>& lattice, const ImageSettings& settings);

  /// Finds those of elements that stay where they lie. Where no element must be moved, ghosts stand
  /// in an array of their own. Where shifts might not fit, nothing is listed: such elements must be
  /// packed. Throws likewise.
  void find(const kernels::StridedSpheres& elements, const grid::Bounds<Dim>& bounds,
            const lattice::ReducedLattice<Dim>& lattice, const ImageSettings& settings);

  /// Locals in the order of the elements, all numbers times unit().
  [[nodiscard]] const kernels::StridedSpheres& locals() const noexcept { return locals_; }
  [[nodiscard]] std::span<const exact::Sphere<Dim>> ghost_spheres() const noexcept {
    return ghost_spheres_;
  }
  /// Ghosts behind locals; nothing where they stand apart.
  [[nodiscard]] std::span<const exact::Sphere<Dim>> locals_and_ghosts() const noexcept {
    return locals_and_ghosts_;
  }

  /// Bounds of the locals.
  [[nodiscard]] const grid::Bounds<Dim>& local_bounds() const noexcept { return bounds_; }
  [[nodiscard]] const grid::Bounds<Dim>& ghost_bounds() const noexcept { return places_.bounds; }

  /// True if the reach is so long that there are far more images than locals. Nothing is listed
  /// then.
  [[nodiscard]] bool reach_is_long() const noexcept { return reach_is_long_; }

  /// True if each ghost lies strictly outside of the locals' box; false where vectors are oblique
  /// to the axes, or locals lie on both of two opposite faces of the cell.
  [[nodiscard]] bool ghosts_are_outside() const noexcept { return places_.all_outside; }

  /// Ordered by element, then by image.
  [[nodiscard]] std::span<const Ghost> ghosts() const noexcept { return ghosts_; }

  /// True if this pair of a local element and a ghost is the one of its two descriptions that is
  /// reported.
  /// Of a small and a large element the ghost is the large one.
  [[nodiscard]] bool counts(std::size_t local, const Ghost& ghost) const noexcept {
    if (all_ghosts_count()) return true;
    const bool large = locals_.radius(local) >= size_cut_;
    if (locals_.radius(ghost.element) < size_cut_) return !large;
    return !large || ghost.is_positive();
  }

  /// True if each ghost counts for all locals, since none is large.
  [[nodiscard]] bool all_ghosts_count() const noexcept {
    return size_cut_ > bounds_.largest_radius;
  }

  /// True if some locals are not where their elements are given.
  [[nodiscard]] bool moved_any() const noexcept { return moved_any_; }

  /// True if local or ghost k is where its element is given.
  [[nodiscard]] bool is_as_given(std::size_t k) const noexcept {
    return k < locals_.size && (!moved_any_ || cells_moved_[k] == lattice::CellsMoved{});
  }

  /// True if both of a pair are.
  [[nodiscard]] bool are_as_given(std::size_t i, std::size_t j) const noexcept {
    return is_as_given(i) && is_as_given(j);
  }

  /// True if the slack makes cells more than twice as wide as the smallest elements ask for;
  /// elements without any size ask for none.
  [[nodiscard]] bool are_coarse(double margin) const noexcept {
    const double smallest = bounds_.smallest_radius;
    const double least =
        smallest > 0.0 ? 2.0 * smallest : bounds_.largest_radius + bounds_.second_largest_radius;
    return least_cell() > 2.0 * (least + margin * unit());
  }

  /// Turns the vectors of sides along which images lie farther from the origin than their elements.
  /// Returns whether there are any; the images must be found again then. None is turned where a
  /// cell may be one of the last that can be counted: on the other side of the origin it cannot.
  bool turn_towards_origin(lattice::ReducedLattice<Dim>& lattice) const;

  /// True if no shift can exceed 2^31 - 1, so that shift_between never throws.
  [[nodiscard]] bool shifts_always_fit() const noexcept { return shifts_always_fit_; }

  /// A power of two; not 1 only where numbers might overflow otherwise.
  [[nodiscard]] double unit() const noexcept { return unit_ * given_unit_; }

  /// Times unit().
  [[nodiscard]] double slack() const noexcept { return slack_; }

  /// The least length of cells, times unit(): in smaller ones the slack would not be covered
  /// (docs/derivations/tile_filter.md, section 3).
  [[nodiscard]] double least_cell() const noexcept { return slack_ * lattice::cells_of_error; }

  /// The shift n for which x_i - (x_j + n A), of the elements as given, is what local i and local
  /// j, or local i and a ghost, stand for. Throws Error{invalid_input} where |n| would exceed
  /// 2^31 - 1 on an axis.
  [[nodiscard]] ImageShift shift_between(std::size_t i, std::size_t j) const {
    return moved_any_ ? shift_between(i, j, {}) : ImageShift{};
  }
  [[nodiscard]] ImageShift shift_between(std::size_t i, const Ghost& ghost) const {
    return shift_between(i, ghost.element, ghost.image);
  }

  /// Returns the shift in terms of the reduced lattice, of any size.
  [[nodiscard]] lattice::ImageNumbers numbers_between(
      std::size_t i, std::size_t j, const std::array<std::int32_t, 3>& image) const;

  /// Returns how many vectors of the reduced lattice lead from an element as given to its image.
  [[nodiscard]] lattice::ImageNumbers numbers_from_given(const Ghost& image) const;

  /// Times given_unit(), as the elements that were given to `find`.
  [[nodiscard]] const lattice::ReducedLattice<Dim>& reduced_lattice() const noexcept {
    return *lattice_;
  }
  [[nodiscard]] double given_unit() const noexcept { return given_unit_; }
  /// Fills in the shifts of many pairs of two locals.
  void shifts_between(std::span<const ContactPair> pairs, std::span<ImageShift> shifts) const;

 private:
  /// Extents and counts that one worker finds for its elements.
  struct FoundGhosts {
    explicit FoundGhosts(base::MemoryMeter& memory)
        : ghosts(base::make_array_for_overwrite<Ghost>(memory, 0)) {}

    lattice::CellExtent<Dim> extent;
    grid::Bounds<Dim> bounds;
    lattice::CellsMoved farthest{};  ///< most cells that an element was moved, by its amount
    base::Array<Ghost> ghosts;
    GhostPlaces<Dim> places;
  };

  using Window = lattice::GhostWindow<Dim>;
  using Windows = GhostWindows<Dim>;
  using Along = std::array<bool, Dim>;

  /// An array where ghosts are put, behind so many locals: all of them or none.
  struct GhostArray {
    base::Array<exact::Sphere<Dim>>& spheres;
    std::size_t locals;
  };

  /// The way to find ghosts among locals, which may have to be moved first.
  struct Plan {
    const lattice::CellSides<Dim>& cell;
    const Windows& windows;
    Along along;
    bool moves;  ///< the elements as given to the locals
  };

  void start_anew(const kernels::StridedSpheres& elements, const grid::Bounds<Dim>& bounds,
                  const lattice::ReducedLattice<Dim>& lattice, const ImageSettings& settings);
  void find_with(const GhostArray& given, const ImageSettings& settings);
  bool find_in_oblique_cell(const GhostArray& given, const ImageSettings& settings);
  [[nodiscard]] bool is_covered_by_cells(double slack, double margin) const;
  void take(const lattice::CellSides<Dim>& cell, const lattice::CellExtent<Dim>& extent);
  [[nodiscard]] lattice::CellExtent<Dim> extent_in(const lattice::CellSides<Dim>& cell,
                                                   const ImageSettings& settings);
  void check_range(const GhostArray& given, const ImageSettings& settings);
  bool wrap_fast_if_near(const WrapEstimate<Dim>& wrap_estimate, const Plan& plan,
                         const ImageSettings& settings);
  void wrap_exactly(const lattice::OrthogonalCell<Dim>& orthogonal_cell, const Along& along,
                    double start, std::size_t workers);
  void add_ghosts(const GhostArray& array, const Plan& plan, const ImageSettings& settings);
  void join_boxes(std::size_t workers);
  void join_ghosts(std::size_t workers);
  void place_ghosts_at(const GhostArray& array, const ImageSettings& settings);
  void note_shifts(const lattice::CellSides<Dim>& cell, const Window& window);
  [[nodiscard]] double magnitude_of(const Window& window, const Along& along, Shape shape) const;
  void packed_shifts_between(std::span<const ContactPair> pairs,
                             std::span<ImageShift> shifts) const;
  [[nodiscard]] ImageShift shift_between(std::size_t i, std::size_t j,
                                         const std::array<std::int32_t, 3>& image) const;

  base::MemoryMeter& memory_;
  const lattice::ReducedLattice<Dim>* lattice_ = nullptr;
  kernels::StridedSpheres given_{};
  kernels::StridedSpheres locals_{};
  std::span<const exact::Sphere<Dim>> ghost_spheres_;
  std::span<const exact::Sphere<Dim>> locals_and_ghosts_;
  std::span<const Ghost> ghosts_;
  std::array<std::size_t, Dim> vector_of_{};          ///< lattice::CellSides::vector_of
  std::array<std::array<double, Dim>, Dim> steps_{};  ///< vectors of the sides times unit_
  double given_unit_ = 1.0;
  double unit_ = 1.0;           ///< beside that
  double size_cut_ = HUGE_VAL;  ///< times unit_
  double slack_ = 0.0;
  lattice::CellExtent<Dim> extent_;  ///< of the locals, at least
  std::array<double, Dim> cells_moved_at_most_{};
  grid::Bounds<Dim> bounds_;  ///< of the locals
  GhostPlaces<Dim> places_;   ///< of the ghosts
  bool are_packed_ = false;   ///< the elements as given
  bool reach_is_long_ = false;
  bool moved_any_ = false;
  bool shifts_always_fit_ = false;
  bool is_in_range_ = false;  ///< by bounds: no element was looked at
  /// The side of each axis, where these are shifts themselves.
  std::optional<std::array<std::size_t, 3>> side_of_axis_;

  base::Array<exact::Sphere<Dim>> own_spheres_;  ///< locals that were moved, and their ghosts
  MovedCells cells_moved_;
  base::Array<Ghost> own_ghosts_;
  std::vector<FoundGhosts> parts_;
};

}  // namespace abut::periodic
