#pragma once

#include "exact/far_image.hpp"
#include "exact/lattice.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

namespace abut::testing {

/// A lattice and a shift in it.
struct FarImage {
  exact::Lattice lattice;
  exact::FarShift shift{};
};

/// The same image by 2^bits times as many vectors that are so much shorter; nothing where that
/// would round one.
[[nodiscard]] inline std::optional<FarImage> by_shorter_vectors(const exact::Lattice& lattice,
                                                                const ImageShift& shift, int bits) {
  FarImage result{lattice, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!lattice.periodic[k]) continue;
    result.shift[k] = exact::Int128{exact::numbers(shift)[k]} * (exact::Int128{1} << bits);
    for (double& x : result.lattice.vectors[k]) {
      const double as_given = x;
      x = std::ldexp(x, -bits);
      if (std::ldexp(x, bits) != as_given) return std::nullopt;
    }
  }
  return result;
}

}  // namespace abut::testing
