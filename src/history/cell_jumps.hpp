#pragma once

#include "exact/lattice.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::history {

/// Remembers where elements were a step ago and finds the lattice vectors by which the caller has
/// moved (wrapped) them since, beside their own small motion. All workers take parts of the
/// elements.
class CellJumps {
 public:
  /// Compares the elements with those remembered: element k was number `before[k]`, or not there;
  /// where `before` is empty, k. Forgets what it cannot compare.
  void find(const ElementView& elements, const Domain& domain,
            std::span<const std::uint32_t> before, std::size_t workers);

  /// True if any element was moved by a lattice vector.
  [[nodiscard]] bool any() const noexcept { return any_; }
  [[nodiscard]] const ImageShift& of(std::size_t number) const noexcept { return jumps_[number]; }

  /// Makes the positions compared last those to compare with in the next step.
  void accept() noexcept;

 private:
  using Position = std::array<double, 3>;
  struct Jump {
    std::size_t number;
    ImageShift cells;
  };

  template <int Dim, class T>
  void find_in(const ElementView& elements, const Domain& domain,
               std::span<const std::uint32_t> before, std::size_t workers);
  void collect(std::size_t elements);

  bool any_ = false;
  std::vector<ImageShift> jumps_;         ///< one for each element where there are any
  std::vector<std::vector<Jump>> found_;  ///< by each worker
  std::vector<Position> positions_;
  std::vector<Position> now_;
};

}  // namespace abut::history
