#pragma once

#include "scenes/scene.hpp"

#include <cstddef>

/// The packs of A. Munjiza, K. R. F. Andrews, "NBS contact detection algorithm for bodies of
/// similar size", Int. J. Numer. Meth. Engng 43 (1998) 131-149; A. Munjiza, The Combined
/// Finite-Discrete Element Method, 2004, Figures 3.46 to 3.53. Discs of diameter 1 in rows and
/// columns, numbered row by row; spacings between centres, in diameters.
namespace abut::scenes {

/// x spacing 1, y spacing 2: each row a chain of discs that touch exactly.
[[nodiscard]] Scene pack_1(std::size_t rows, std::size_t columns);

/// x spacing as given, y spacing 2.
[[nodiscard]] Scene pack_2(std::size_t rows, std::size_t columns, double spacing);

/// Makes a pack with both spacings as given.
[[nodiscard]] Scene pack_3(std::size_t rows, std::size_t columns, double spacing);

/// x spacings 1 and the given one in turn, y spacing 2: discs touch in twos.
[[nodiscard]] Scene pack_4(std::size_t rows, std::size_t columns, double spacing);

}  // namespace abut::scenes
