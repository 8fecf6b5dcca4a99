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

  [[nodiscard]] exact::Sphere<Dim> operator[](std::size_t number) const {
    return given_ == nullptr ? gathered_[number] : elements::sphere_at<Dim>(*given_, number);
  }

 private:
  std::span<const exact::Sphere<Dim>> gathered_;
  const ElementView* given_ = nullptr;
};

}  // namespace abut::skin
