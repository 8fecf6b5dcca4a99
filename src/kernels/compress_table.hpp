#pragma once

#include <array>
#include <cstdint>

namespace abut::kernels {

/// The orders of lanes for each set out of eight: those lanes first, then the others, in eight
/// bytes. Vectors of four lanes use the first sixteen rows.
///
/// Highway 1.0.3 has the like as a local array, which GCC 12 copies to the stack at every use.
inline constexpr auto compress_table = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t mask = 0; mask < table.size(); ++mask) {
    std::size_t next = 0;
    for (const bool wanted : {true, false}) {
      for (std::uint8_t lane = 0; lane < 8; ++lane) {
        if (((mask >> lane & 1) != 0) == wanted) table[mask][next++] = lane;
      }
    }
  }
  return table;
}();

}  // namespace abut::kernels
