#pragma once

#include "trace_recorder.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {

/// The number from which elements, cells and positions are counted.
enum class Numbering : std::int32_t {
  from_zero = 0,
  from_one = 1,  ///< as the book does
};

/// The value in the numbering; -1 stays, it means none.
[[nodiscard]] std::int32_t numbered(std::int32_t value, Numbering numbering);

/// A labelled row of numbers.
struct NumberRow {
  std::string label;
  std::vector<std::int32_t> numbers;
};

/// Rows below each other, in columns, folded at 100 characters with all rows repeated; labels are
/// at least `label_width` wide.
[[nodiscard]] std::string rows_text(std::span<const NumberRow> rows, std::size_t label_width = 0);

/// The arrays of a stage as the figures draw them: matrices row by row, lists below their index.
/// Arrays too large for that show what is in them, not what is empty.
[[nodiscard]] std::string arrays_text(std::span<const RecordedArray> arrays, Numbering numbering);

}  // namespace abut::cli
