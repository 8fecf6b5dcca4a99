#pragma once

#include "exact/features/feature_geometry.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"
#include "kernels/walls/feature_kernels.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/simd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::walls {

/// Contacts with features of one kind, all or none of which a shift moves, to be measured together
/// in vectors.
class FeatureBlock {
 public:
  /// The arrays that are not empty are filled. Shifts are those of the lattice.
  FeatureBlock(Simd level, const PairGeometrySpans& geometry,
               const exact::Lattice& lattice) noexcept;

  void clear() noexcept {
    count_ = 0;
    is_moved_ = false;
  }
  [[nodiscard]] bool is_empty() const noexcept { return count_ == 0; }

  /// Adds the contact whose quantities go to `place` of the arrays; at most most_features.
  void add(std::size_t place, const exact::Sphere<3>& sphere,
           const exact::Feature& feature) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_.center[axis][count_] = sphere.center[axis];
      for (std::size_t k = 0; k < static_cast<std::size_t>(feature.corners); ++k) {
        columns_.corner[k][axis][count_] = feature.corner[k][axis];
      }
    }
    columns_.radius[count_] = sphere.radius;
    places_[count_++] = place;
  }

  /// Moves the feature that was added last, but not along the axes that are left out, a bit for
  /// each: on these, the center and the feature have a 0.
  void move_last(const ImageShift& shift, unsigned left_out = 0) noexcept {
    is_moved_ = true;
    const std::array<std::int32_t, 3> numbers = exact::numbers(shift);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_still = (left_out >> axis & 1u) != 0;
      for (std::size_t k = 0; k < 3; ++k) {
        moves_.number[axis][k][count_ - 1] = is_still ? 0 : numbers[k];
      }
    }
  }

  /// Measures the contacts with features of so many corners. Returns the places of those that are
  /// to be measured one by one.
  [[nodiscard]] std::span<const std::size_t> measure(int corners) noexcept;

 private:
  /// Vectors have at most so many lanes.
  static constexpr std::size_t most_lanes = 8;
  static constexpr std::size_t size = kernels::most_features;
  static_assert(size % most_lanes == 0);

  [[nodiscard]] std::size_t fill_last_vector(int corners) noexcept;
  void write(std::size_t count) const noexcept;

  kernels::FeatureKernels kernels_;
  const PairGeometrySpans& geometry_;
  std::size_t count_ = 0;
  bool is_moved_ = false;
  bool can_move_ = true;  ///< whether vectors bear the lattice
  std::array<std::size_t, size> places_;
  std::array<std::size_t, size> open_places_;
  std::array<std::uint32_t, size> open_;
  kernels::FeatureColumns columns_;
  kernels::FeatureMoves moves_;
  double gaps_[size];
  double distances_[size];
  double normals_[size][3];
  double points_[size][3];
  double vectors_[size][3];
};

}  // namespace abut::walls
