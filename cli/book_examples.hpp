#pragma once

#include "trace_recorder.hpp"

#include <abut/algorithm.hpp>
#include <abut/trace.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace abut::cli {

/// The example that the book works through for one algorithm; cells from 0.
struct BookExample {
  std::string figures;  ///< "Figures 3.19 and 3.20, eq. 3.31"
  std::string note;     ///< what the book leaves open; empty if nothing
  trace::CellSystem system;
  std::optional<std::array<std::int32_t, 3>> searched_cell;  ///< sorting: Figures 3.25 to 3.27
  std::optional<trace::CellSystem> in_space = {};  ///< where the book has 3D without an example
};

[[nodiscard]] BookExample book_example(Algorithm algorithm);

/// The parts of the book's example beside the arrays of the run; empty for most.
[[nodiscard]] std::string book_supplement(Algorithm algorithm,
                                          const std::vector<RecordedStage>& stages);

}  // namespace abut::cli
