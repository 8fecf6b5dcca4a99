#pragma once

#include "base/host_device.hpp"

#include <abut/image_shift.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::exact {

/// Lattice vectors a, b, c as the rows, as given by the caller; those of axes that are not periodic
/// mean nothing. In two dimensions a and b count, and of them the first two components.
struct Lattice {
  std::array<std::array<double, 3>, 3> vectors{};
  std::array<bool, 3> periodic{};
};

/// The three numbers of a shift, for loops over axes.
[[nodiscard]] constexpr std::array<std::int32_t, 3> numbers(const ImageShift& shift) noexcept {
  return {shift.x, shift.y, shift.z};
}

/// The steps of a shift: each lattice vector that it uses, and how often.
template <int Dim>
class LatticeSteps {
 public:
  ABUT_HD LatticeSteps(const ImageShift& shift, const Lattice& lattice) noexcept {
    for (std::size_t k = 0; k < Dim; ++k) {
      const std::int32_t number = numbers(shift)[k];
      if (!lattice.periodic[k] || number == 0) continue;
      steps_[count_++] = {number, lattice.vectors[k].data()};
    }
  }

  struct Step {
    std::int32_t number;   ///< not 0
    const double* vector;  ///< Dim components
  };

  [[nodiscard]] ABUT_HD const Step* begin() const noexcept { return steps_.data(); }
  [[nodiscard]] ABUT_HD const Step* end() const noexcept { return steps_.data() + count_; }
  [[nodiscard]] ABUT_HD bool empty() const noexcept { return count_ == 0; }

 private:
  std::array<Step, Dim> steps_{};
  std::size_t count_ = 0;
};

}  // namespace abut::exact
