#pragma once

#include "exact/sphere.hpp"
#include "kernels/sphere_parts.hpp"
#include "kernels/strided_boxes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Moves a cluster: what is at `from` comes to `to`.
template <int Dim>
struct ClusterMove {
  double from[Dim];
  double to[Dim];

  [[nodiscard]] double moved(double x, std::size_t axis) const noexcept {
    return (x - from[axis]) + to[axis];
  }
};

/// Spheres, or the stand-ins of boxes (exact::Elements), as layers see them: where they are given,
/// or moved with their clusters.
template <int Dim>
class LayerSpheres {
 public:
  explicit LayerSpheres(const kernels::SphereParts& given) : given_(given) {}

  /// `labels` tells the move of each sphere.
  LayerSpheres(const kernels::SphereParts& given, const std::uint32_t* labels,
               const ClusterMove<Dim>* moves)
      : given_(given), labels_(labels), moves_(moves) {}

  [[nodiscard]] const kernels::SphereParts& given() const noexcept { return given_; }
  [[nodiscard]] std::size_t size() const noexcept { return given_.size(); }
  /// Radius of sphere k. Columns of boxes have none: it follows from the box.
  [[nodiscard]] double radius(std::size_t k) const noexcept {
    return have_radii() ? given_.radius(k)
                        : kernels::stand_in(kernels::box_at<Dim>(boxes_, k)).radius;
  }
  [[nodiscard]] bool have_radii() const noexcept {
    return !stand_for_boxes() || given_.parts[0].stride[kernels::StridedSpheres::radii] != 0;
  }
  /// The same spheres, which stand for these boxes unless there are none.
  [[nodiscard]] LayerSpheres standing_for(const kernels::StridedBoxes& boxes) const noexcept {
    LayerSpheres stand_ins = *this;
    stand_ins.boxes_ = boxes;
    return stand_ins;
  }

  /// The same spheres, those with these numbers, which ascend, being coarse: they stand in no
  /// layer.
  [[nodiscard]] LayerSpheres with_coarse(std::span<const std::uint32_t> numbers) const noexcept {
    LayerSpheres spheres = *this;
    spheres.coarse_ = numbers;
    return spheres;
  }
  [[nodiscard]] std::span<const std::uint32_t> coarse() const noexcept { return coarse_; }

  /// The same spheres, of which those alone stand in layers that have these numbers, which ascend:
  /// the coarse ones are of the others.
  [[nodiscard]] LayerSpheres with_only(std::span<const std::uint32_t> numbers) const noexcept {
    LayerSpheres spheres = *this;
    spheres.only_ = numbers;
    return spheres;
  }

  [[nodiscard]] std::size_t count_in_layers() const noexcept {
    return only_.empty() ? size() - coarse_.size() : only_.size();
  }

  /// Calls visit(first, last) with the stretches [first, last) of [begin, end) that stand in
  /// layers.
  template <class Visit>
  void for_each_stretch(std::size_t begin, std::size_t end, const Visit& visit) const {
    if (!only_.empty()) return for_each_stretch_of_some(begin, end, visit);
    auto next = std::lower_bound(coarse_.begin(), coarse_.end(), begin);
    for (; next != coarse_.end() && *next < end; ++next) {
      if (begin < *next) visit(begin, std::size_t{*next});
      begin = std::size_t{*next} + 1;
    }
    if (begin < end) visit(begin, end);
  }

  /// The first sphere from number k on that stands in layers, or behind the last one, the first of
  /// all; there is one.
  [[nodiscard]] std::size_t in_layers(std::size_t k) const noexcept {
    if (!only_.empty()) {
      const auto next = std::lower_bound(only_.begin(), only_.end(), k);
      return next != only_.end() ? *next : only_.front();
    }
    while (std::binary_search(coarse_.begin(), coarse_.end(), k)) {
      if (++k == size()) k = 0;
    }
    return k;
  }

  [[nodiscard]] bool stand_for_boxes() const noexcept { return boxes_.size > 0; }
  /// The boxes by their numbers.
  [[nodiscard]] const kernels::StridedBoxes& boxes() const noexcept { return boxes_; }

  [[nodiscard]] bool are_moved() const noexcept { return moves_ != nullptr; }

  [[nodiscard]] LayerSpheres first(std::size_t count) const noexcept {
    LayerSpheres some = *this;
    some.given_ = given_.first(count);
    return some;
  }

  /// Brings sphere k, which will be read soon, into the nearest cache.
  void fetch(std::size_t k) const noexcept {
    const std::size_t elements = given_.parts[0].size;
    if (k < elements) {
      kernels::fetch<Dim>(given_.parts[0], k);
    } else {
      kernels::fetch<Dim>(given_.parts[1], k - elements);
    }
    if (are_moved()) __builtin_prefetch(labels_ + k);
  }

  [[nodiscard]] exact::Sphere<Dim> operator[](std::size_t k) const noexcept {
    return moved(kernels::sphere_at<Dim>(given_, k), k);
  }

  /// Sphere k, which is given so.
  [[nodiscard]] exact::Sphere<Dim> moved(exact::Sphere<Dim> sphere, std::size_t k) const noexcept {
    if (!are_moved()) return sphere;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sphere.center[axis] = moved(sphere.center[axis], k, axis);
    }
    return sphere;
  }
  [[nodiscard]] double moved(double x, std::size_t k, std::size_t axis) const noexcept {
    return moves_[labels_[k]].moved(x, axis);
  }

 private:
  template <class Visit>
  void for_each_stretch_of_some(std::size_t begin, std::size_t end, const Visit& visit) const {
    auto next = std::lower_bound(only_.begin(), only_.end(), begin);
    while (next != only_.end() && *next < end) {
      const std::size_t first = *next;
      std::size_t last = first;
      while (next != only_.end() && *next == last && last < end) ++next, ++last;
      visit(first, last);
    }
  }

  kernels::SphereParts given_;
  kernels::StridedBoxes boxes_{};
  const std::uint32_t* labels_ = nullptr;
  const ClusterMove<Dim>* moves_ = nullptr;
  std::span<const std::uint32_t> coarse_{};
  std::span<const std::uint32_t> only_{};
};

}  // namespace abut::engine
