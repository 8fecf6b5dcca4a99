#pragma once

#include "base/array.hpp"
#include "base/sphere_predicate.hpp"
#include "grid/bounds.hpp"
#include "grid/cell_extent.hpp"
#include "grid/ghost_window.hpp"
#include "grid/reduced_lattice.hpp"
#include "grid/wrapper.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::grid {

/// The periodic image of an element moved by `image` vectors of the reduced basis. The first of
/// these numbers that is not 0 is positive.
struct Ghost {
  std::uint32_t element;
  std::array<std::int32_t, 3> image;
};

/// What a search in open space needs in order to find every pair of a periodic domain exactly once:
/// the elements themselves in one cell, the *natives*, and copies of some of them around it, the
/// *ghosts*. Pairs among natives and of each native with each ghost, its own included, are all the
/// pairs, each once; ghosts do not pair with ghosts. docs/derivations/periodic_images.md has the
/// proof.
///
/// Natives and ghosts are a little off where they were moved: the distance of two of them, here, by
/// at most slack(). Whether a pair is within reach is decided on the caller's elements, by
/// base::within_reach with the shift that shift_between tells.
template <int Dim>
class Images {
 public:
  explicit Images(base::MemoryMeter& memory);

  /// Of the elements of a detection; `bounds` are theirs. Elements and lattice must live on. The
  /// result does not depend on the number of workers.
  ///
  /// Throws Error{invalid_input} when an element lies more than 2^31 - 1 cells outside, and
  /// Error{limit_exceeded} when there are more natives and ghosts than elements can be numbered.
  void find(std::span<const base::Sphere<Dim>> spheres, const Bounds<Dim>& bounds,
            const ReducedLattice<Dim>& lattice, double margin, std::size_t workers);

  /// In the order of the elements, all numbers times unit(). The caller's own array where no
  /// element had to be moved.
  [[nodiscard]] std::span<const base::Sphere<Dim>> natives() const noexcept { return natives_; }

  /// Of the natives.
  [[nodiscard]] const Bounds<Dim>& bounds() const noexcept { return bounds_; }

  /// Ordered by element, then by image.
  [[nodiscard]] std::span<const Ghost> ghosts() const noexcept { return ghosts_; }

  /// Times unit(), as the natives are.
  [[nodiscard]] base::Sphere<Dim> sphere_of(const Ghost& ghost) const noexcept {
    base::Sphere<Dim> sphere = natives_[ghost.element];
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < lattice_->count; ++k) {
        sphere.center[axis] += ghost.image[k] * steps_[k][axis];
      }
    }
    return sphere;
  }

  /// Whether no shift can exceed 2^31 - 1, so that shift_between never throws.
  [[nodiscard]] bool shifts_always_fit() const noexcept { return shifts_always_fit_; }

  /// A power of two; not 1 only where numbers might overflow otherwise.
  [[nodiscard]] double unit() const noexcept { return unit_; }

  /// Times unit().
  [[nodiscard]] double slack() const noexcept { return slack_; }

  /// The shift n for which x_i - (x_j + n A), of the elements as given, is what native i and native
  /// j, or native i and a ghost, stand for. Throws Error{invalid_input} where |n| would exceed
  /// 2^31 - 1 on an axis.
  [[nodiscard]] base::ImageShift shift_between(std::size_t i, std::size_t j) const {
    return moved_any_ ? shift_between(i, j, {}) : base::ImageShift{};
  }
  [[nodiscard]] base::ImageShift shift_between(std::size_t i, const Ghost& ghost) const {
    return shift_between(i, ghost.element, ghost.image);
  }

 private:
  /// What one worker finds out about its elements.
  struct Part {
    explicit Part(base::MemoryMeter& memory)
        : ghosts(base::make_array_for_overwrite<Ghost>(memory, 0)) {}

    CellExtent<Dim> extent;
    Bounds<Dim> bounds;
    CellsMoved farthest{};  ///< most cells that an element was moved, by its amount
    base::Array<Ghost> ghosts;
  };

  void place_natives(std::span<const base::Sphere<Dim>> spheres, const Bounds<Dim>& bounds,
                     double margin, std::size_t workers);
  void move_natives(std::span<const base::Sphere<Dim>> spheres, const std::array<bool, Dim>& along,
                    std::size_t workers);
  void join_extents(std::size_t workers);
  void find_ghosts(const GhostWindow<Dim>& window, std::size_t workers);
  [[nodiscard]] double slack_of(const GhostWindow<Dim>& window) const;
  [[nodiscard]] bool all_shifts_fit(const GhostWindow<Dim>& window, std::size_t workers) const;
  [[nodiscard]] base::ImageShift shift_between(std::size_t i, std::size_t j,
                                               const std::array<std::int32_t, 3>& image) const;

  base::MemoryMeter& memory_;
  const ReducedLattice<Dim>* lattice_ = nullptr;
  std::span<const base::Sphere<Dim>> natives_;
  std::span<const Ghost> ghosts_;
  std::array<std::array<double, Dim>, Dim> steps_{};  ///< reduced basis times unit_
  double unit_ = 1.0;
  double slack_ = 0.0;
  CellExtent<Dim> extent_;  ///< of the natives
  Bounds<Dim> bounds_;
  bool moved_any_ = false;
  bool shifts_always_fit_ = false;

  base::Array<base::Sphere<Dim>> own_natives_;
  base::Array<CellsMoved> cells_moved_;
  base::Array<Ghost> own_ghosts_;
  std::vector<Part> parts_;
};

}  // namespace abut::grid
