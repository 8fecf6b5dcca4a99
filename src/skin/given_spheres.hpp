#pragma once

#include "elements/gathered_elements.hpp"
#include "exact/sphere.hpp"

#include <abut/element_view.hpp>

#include <cstddef>
#include <span>

namespace abut::skin {

/// Spheres of one call, checked, for those who need only some of them: among the gathered ones, or
/// in the caller's arrays.
template <int Dim>
class GivenSpheres {
 public:
  explicit GivenSpheres(std::span<const exact::Sphere<Dim>> gathered) noexcept
      : gathered_(gathered) {}
  explicit GivenSpheres(const ElementView& given) noexcept : given_(&given) {}

  /// Where the sphere lies; in `room` if it had to be read.
  [[nodiscard]] const exact::Sphere<Dim>& find(std::size_t number, exact::Sphere<Dim>& room) const {
    if (given_ == nullptr) return gathered_[number];
    return room = elements::sphere_at<Dim>(*given_, number);
  }

 private:
  std::span<const exact::Sphere<Dim>> gathered_;
  const ElementView* given_ = nullptr;
};

}  // namespace abut::skin
