#pragma once

#include "fuzz/number_maker.hpp"

#include <abut/domain.hpp>

#include <array>
#include <optional>

namespace abut::fuzz {

/// A domain of every kind, as lattice vectors that may move from state to state.
class DomainMaker {
 public:
  /// `expanse` stretches what is periodic, for many elements.
  DomainMaker(ByteReader& reader, NumberMaker& numbers, int dimensions, double expanse);

  /// None where the vectors enclose no cell.
  [[nodiscard]] std::optional<Domain> domain() const;

  /// Lengths, tilts or the shift of Lees-Edwards change a little.
  void move();

  [[nodiscard]] bool is_open() const noexcept { return kind_ == Kind::open; }
  [[nodiscard]] double component(std::size_t k, std::size_t axis) const {
    return is_periodic(k) ? vectors_[k][axis] : 0.0;
  }

 private:
  enum class Kind { open, block, sheared, lattice, lees_edwards };

  [[nodiscard]] bool is_periodic(std::size_t k) const {
    return kind_ != Kind::open && (axes_ >> k & 1U) != 0;
  }
  [[nodiscard]] Domain made() const;

  ByteReader& reader_;
  NumberMaker& numbers_;
  std::size_t dimensions_;
  Kind kind_ = Kind::open;
  unsigned axes_ = 0;
  std::array<std::array<double, 3>, 3> vectors_{};
  double shift_ = 0.0;
};

}  // namespace abut::fuzz
