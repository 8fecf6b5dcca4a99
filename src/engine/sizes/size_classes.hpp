#pragma once

#include "engine/sizes/radius_histogram.hpp"
#include "grid/bounds.hpp"

#include <array>
#include <cstddef>

namespace abut::engine {

/// Facts about a search set from which it is estimated what a search costs.
struct SizeDistribution {
  double largest_radius;
  double smallest_radius;
  double margin;
  double volume;  ///< that a search set of even density would fill, in cells of the largest reach

  /// The largest reach: the unit of length of estimates.
  [[nodiscard]] double reach() const noexcept { return 2.0 * largest_radius + margin; }
};

template <int Dim>
[[nodiscard]] SizeDistribution sizes_of(const grid::Bounds<Dim>& sizes, double margin,
                                        double volume) {
  return {sizes.largest_radius, sizes.smallest_radius, margin, volume};
}

/// Elements of similar radii.
struct SizeClass {
  double count;
  double radius;  ///< upper end, in largest reaches
  double cut;     ///< the same as it was given
};

/// The classes of radii that have elements, the smallest first: a short array that needs no memory
/// of its own.
class SizeClasses {
 public:
  /// Up to one more where the largest radius begins a class.
  static constexpr std::size_t most = 128;

  SizeClasses(const RadiusHistogram& histogram, const SizeDistribution& sizes);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] const SizeClass& operator[](std::size_t k) const noexcept { return classes_[k]; }
  [[nodiscard]] const SizeClass* begin() const noexcept { return classes_.data(); }
  [[nodiscard]] const SizeClass* end() const noexcept { return classes_.data() + size_; }

 private:
  std::array<SizeClass, most + 1> classes_;
  std::size_t size_ = 0;
};

}  // namespace abut::engine
