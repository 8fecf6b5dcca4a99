#pragma once

#include "scenes/scene.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// The test problems of A. Munjiza, K. R. F. Andrews, Int. J. Numer. Meth. Engng 43 (1998) 131-149;
/// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, Figures 3.46 to 3.53.
namespace abut::benchmarks {

enum class Numbering {
  along_the_pack,  ///< row by row
  shuffled,        ///< as left by many steps of motion
};

/// One arrangement of discs: which pack, how large, how loose.
struct PackCase {
  int pack = 1;  ///< 1 to 4
  std::size_t rows = 0;
  std::size_t columns = 0;
  double spacing = 1.0;  ///< S / D; pack I has 1
  Numbering numbering = Numbering::along_the_pack;

  [[nodiscard]] std::size_t elements() const noexcept { return rows * columns; }
};

[[nodiscard]] std::string name_of(const PackCase& pack);

[[nodiscard]] scenes::Scene make_scene(const PackCase& pack);

/// The number of contact pairs, by arithmetic: touching counts.
[[nodiscard]] PairCount expected_contact_pairs(const PackCase& pack);

/// Cells along x and y when the cell is the diameter, as the book's formulas of memory count them.
struct BookCells {
  double x;
  double y;
};
[[nodiscard]] BookCells book_cells(const PackCase& pack);

/// Pack I with 100 to 10^6 elements, once with shuffled numbers; packs II to IV with 10^4 elements
/// at spacings of 1 to 200 diameters.
[[nodiscard]] std::vector<PackCase> full_cases();

/// A few small ones of every kind, which run in a blink.
[[nodiscard]] std::vector<PackCase> quick_cases();

}  // namespace abut::benchmarks
