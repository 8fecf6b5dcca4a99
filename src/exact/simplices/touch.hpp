#pragma once

#include "exact/lattice.hpp"
#include "exact/simplices/simplex.hpp"

#include <abut/image_shift.hpp>

#include <cstdint>

namespace abut::exact {

/// True if the two closed sets have a point in common, in real arithmetic. Adds to
/// `exact_decisions` the number of signs that the filters could not decide.
template <int Dim>
[[nodiscard]] bool touch(const Simplex<Dim>& a, const Simplex<Dim>& b,
                         std::uint64_t& exact_decisions) noexcept;

/// The same for a and the image of b that `shift` names, whose vertices are the real numbers x + n
/// A.
template <int Dim>
[[nodiscard]] bool touch(const Simplex<Dim>& a, const Simplex<Dim>& b, const ImageShift& shift,
                         const Lattice& lattice, std::uint64_t& exact_decisions) noexcept;

}  // namespace abut::exact
