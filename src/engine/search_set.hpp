#pragma once

#include "grid/bounds.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Numbers of elements: a list, or so many from a first one on.
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(std::size_t first_ones) : size_(first_ones) {}
  Numbers(const std::uint32_t* list, std::size_t size) : list_(list), size_(size) {}

  [[nodiscard]] static Numbers from(std::uint32_t first, std::size_t size) {
    Numbers numbers(nullptr, size);
    numbers.first_ = first;
    return numbers;
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  /// 0, 1, 2, ...
  [[nodiscard]] bool are_the_first() const noexcept { return list_ == nullptr && first_ == 0; }
  [[nodiscard]] std::uint32_t operator[](std::size_t k) const noexcept {
    return list_ == nullptr ? first_ + static_cast<std::uint32_t>(k) : list_[k];
  }

 private:
  const std::uint32_t* list_ = nullptr;
  std::uint32_t first_ = 0;
  std::size_t size_ = 0;
};

enum class Wanted {
  all_pairs,       ///< among locals, of locals with halo elements, of locals with coarse elements
  pairs_of_coarse  ///< of locals with coarse elements only
};

/// Elements that are cut into tiles and searched together. *Locals* belong to the search set. The
/// *halo* is copies of the elements around it, smaller or as large as its locals, or periodic
/// images; they pair with locals only, each such pair being found in the local element's search
/// set. *Coarse elements* are larger elements that pair with locals without being sorted into their
/// cells. A halo element lies outside the locals' box.
template <int Dim>
struct SearchSet {
  Numbers locals;
  Numbers halo;
  Numbers coarse_elements;
  Wanted wanted = Wanted::all_pairs;
  double least_tiles = 1.0;  ///< more than one where a single tile would be crowded again
  grid::Bounds<Dim> bounds;  ///< box of the locals; radii of locals and halo elements
};

}  // namespace abut::engine
