#pragma once

#include "engine/search_set.hpp"
#include "exact/sphere.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace abut::engine {

/// Numbered elements one behind the other, as vector kernels read them: copies of some of a list,
/// or the elements themselves where the numbers are 0, 1, 2, ...
template <int Dim>
class SphereBlock {
 public:
  /// Number of spheres, so few that their numbers stay in the nearest cache.
  static constexpr std::size_t size = 256;

  /// The elements numbers[begin] .. numbers[end - 1], at most `size`; valid until the next call.
  [[nodiscard]] std::span<const exact::Sphere<Dim>> of(std::span<const exact::Sphere<Dim>> spheres,
                                                       const Numbers& numbers, std::size_t begin,
                                                       std::size_t end) {
    if (numbers.are_the_first()) return spheres.subspan(begin, end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      if (k + fetched_ahead < numbers.size()) {
        __builtin_prefetch(&spheres[numbers[k + fetched_ahead]]);
      }
      copies_[k - begin] = spheres[numbers[k]];
    }
    return std::span(copies_).first(end - begin);
  }

  /// Calls body(begin, end) for the blocks of [first, last).
  template <class Body>
  static void for_each(std::size_t first, std::size_t last, Body&& body) {
    for (; first < last; first += size) body(first, std::min(first + size, last));
  }

 private:
  /// Elements of a list lie anywhere in memory.
  static constexpr std::size_t fetched_ahead = 16;

  std::array<exact::Sphere<Dim>, size> copies_;
};

}  // namespace abut::engine
