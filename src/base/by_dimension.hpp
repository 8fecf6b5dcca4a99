#pragma once

namespace abut::base {

/// One object for two dimensions and one for three, of which a caller's elements choose.
template <template <int> class T>
struct ByDimension {
  T<2> in_2d;
  T<3> in_3d;

  template <int Dim>
  [[nodiscard]] constexpr auto& in() noexcept {
    return chosen<Dim>(*this);
  }
  template <int Dim>
  [[nodiscard]] constexpr const auto& in() const noexcept {
    return chosen<Dim>(*this);
  }

 private:
  template <int Dim>
  [[nodiscard]] static constexpr auto& chosen(auto& self) noexcept {
    if constexpr (Dim == 2) {
      return self.in_2d;
    } else {
      return self.in_3d;
    }
  }
};

}  // namespace abut::base
