#pragma once

#include "base/host_device.hpp"
#include "exact/box.hpp"
#include "exact/sphere.hpp"
#include "lattice/image_window.hpp"
#include "lattice/reduced_lattice.hpp"
#include "lattice/wrap_rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::device {

/// The number of images in a window, and the largest of their numbers, by magnitude; of many
/// windows the largest of both.
struct WindowSize {
  double images = 0.0;
  double farthest = 0.0;
};

struct JoinWindowSizes {
  [[nodiscard]] ABUT_HD WindowSize operator()(const WindowSize& a,
                                              const WindowSize& b) const noexcept {
    return {std::max(a.images, b.images), std::max(a.farthest, b.farthest)};
  }
};

[[nodiscard]] ABUT_HD inline WindowSize size_of_window(
    const lattice::ImageWindow& window) noexcept {
  if (window.is_empty()) return {};
  WindowSize size{1.0, window.farthest()};
  for (std::size_t k = 0; k < 3; ++k) {
    size.images *= static_cast<double>(window.last[k] - window.first[k]) + 1.0;
  }
  return size;
}

/// The images of a window in ascending order, of which there are fewer than 2^53. Of an element's
/// own images (i, i, n) and (i, i, -n) are one pair: its window is as wide below as above, and the
/// images behind the middle, the element itself, are half of them.
struct WindowImages {
  lattice::ImageNumbers first;
  std::uint64_t along_second;
  std::uint64_t along_third;
  std::uint64_t before;  ///< images of the window that are passed over
  std::uint64_t count;
  bool shifts_fit;  ///< whether all shifts fit into 32 bits

  template <std::size_t Sides>
  ABUT_HD WindowImages(const lattice::ImageWindow& window, bool of_itself,
                       const std::int64_t (&shift_of_side)[Sides][3]) noexcept
      : first(window.first),
        along_second(numbers_along(window, 1)),
        along_third(numbers_along(window, 2)),
        before(0),
        count(numbers_along(window, 0) * along_second * along_third),
        shifts_fit(true) {
    if (of_itself && count > 0) {
      before = count / 2 + 1;
      count -= before;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double bound = 0.0;
      for (std::size_t side = 0; side < Sides; ++side) {
        const auto farthest = static_cast<double>(std::max(-window.first[side], window.last[side]));
        bound += farthest * std::fabs(static_cast<double>(shift_of_side[side][axis]));
      }
      shifts_fit = shifts_fit && bound < lattice::largest_bound_of_shifts;
    }
  }

  [[nodiscard]] ABUT_HD lattice::ImageNumbers at(std::uint64_t k) const noexcept {
    const std::uint64_t number = before + k;
    const std::uint64_t row = number / along_third;
    return {first[0] + static_cast<std::int64_t>(row / along_second),
            first[1] + static_cast<std::int64_t>(row % along_second),
            first[2] + static_cast<std::int64_t>(number % along_third)};
  }

  ABUT_HD void advance(lattice::ImageNumbers& numbers) const noexcept {
    if (++numbers[2] < first[2] + static_cast<std::int64_t>(along_third)) return;
    numbers[2] = first[2];
    if (++numbers[1] < first[1] + static_cast<std::int64_t>(along_second)) return;
    numbers[1] = first[1];
    ++numbers[0];
  }

  /// How many of `most` images from this one on there are.
  [[nodiscard]] ABUT_HD std::uint64_t in_item(std::uint64_t k, std::uint64_t most) const noexcept {
    return count - k < most ? count - k : most;
  }

 private:
  [[nodiscard]] ABUT_HD static std::uint64_t numbers_along(const lattice::ImageWindow& window,
                                                           std::size_t k) noexcept {
    if (window.first[k] > window.last[k]) return 0;
    return static_cast<std::uint64_t>(window.last[k] - window.first[k]) + 1;
  }
};

/// What some vectors of a basis, rounded, move an element by.
template <int Dim>
class MovedBy {
 public:
  ABUT_HD MovedBy(const lattice::SideSteps<Dim>& steps,
                  const lattice::ImageNumbers& numbers) noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < Dim; ++k) {
        const double step = static_cast<double>(numbers[k]) * steps[k][axis];
        by_[axis] += step;
        magnitude_ += std::fabs(step);
      }
    }
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> of(exact::Sphere<Dim> sphere) noexcept {
    for (int axis = 0; axis < Dim; ++axis) move(sphere.center[axis], axis);
    return sphere;
  }
  [[nodiscard]] ABUT_HD exact::Box<Dim> of(exact::Box<Dim> box) noexcept {
    for (int axis = 0; axis < Dim; ++axis) {
      move(box.lower[axis], axis);
      move(box.upper[axis], axis);
    }
    return box;
  }

  /// Of the distance to what was moved.
  [[nodiscard]] ABUT_HD double slack() const noexcept { return 0x1p-45 * magnitude_; }

 private:
  ABUT_HD void move(double& coordinate, int axis) noexcept {
    magnitude_ += std::fabs(coordinate);
    coordinate += by_[axis];
  }

  double by_[Dim] = {};
  double magnitude_ = 0x1p-1000;
};

}  // namespace abut::device
