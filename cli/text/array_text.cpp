#include "text/array_text.hpp"

#include "text/human_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace abut::cli {
namespace {

constexpr std::size_t text_width = 100;
constexpr std::int32_t widest_matrix = 24;
constexpr std::int32_t highest_matrix = 60;
constexpr std::size_t longest_list = 120;

std::string_view name_of(trace::IndexedBy index) {
  static constexpr std::array<std::string_view, 5> names{"element", "position", "cell", "row",
                                                         "layer"};
  return names[static_cast<std::size_t>(index)];
}

/// C of the screening array has two or three axes, even where one of them has a single cell; the
/// cells of a row (A of NBS) have one.
bool is_grid(const RecordedArray& array) {
  return array.book_symbol == "C" && array.indexed_by == trace::IndexedBy::cell;
}

bool is_empty(const RecordedArray& array) {
  return std::all_of(array.values.begin(), array.values.end(),
                     [](std::int32_t value) { return value < 0; });
}

std::string label_of(const RecordedArray& array) {
  return fmt::format("{} ({})", array.book_symbol, array.name);
}

std::vector<std::int32_t> numbered_all(const RecordedArray& array, Numbering numbering) {
  std::vector<std::int32_t> result = array.values;
  for (std::int32_t& value : result) value = numbered(value, numbering);
  return result;
}

/// "C[5][7] = 4, ...; 96 others are -1".
std::string entries_text(const RecordedArray& array, Numbering numbering) {
  std::string text;
  std::size_t others = 0;
  for (std::size_t k = 0; k < array.values.size(); ++k) {
    if (array.values[k] < 0) {
      ++others;
      continue;
    }
    auto rest = static_cast<std::int32_t>(k);
    std::array<std::int32_t, 3> index{};
    for (std::size_t axis = 3; axis-- > 0; rest /= array.extent[axis]) {
      index[axis] = rest % array.extent[axis];
    }
    if (!text.empty()) text += ", ";
    text += array.book_symbol;
    const std::size_t axes = is_grid(array) ? (array.extent[2] > 1 ? 3 : 2) : 1;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      text += fmt::format("[{}]", numbered(index[axis], numbering));
    }
    text += fmt::format(" = {}", numbered(array.values[k], numbering));
  }
  if (others > 0)
    text += fmt::format("; {} {} -1", others, others == 1 ? "other is" : "others are");
  return text;
}

std::string matrix_text(const RecordedArray& array, Numbering numbering) {
  const auto columns = static_cast<std::size_t>(array.extent[1]);
  std::vector<NumberRow> rows(1);
  for (std::int32_t j = 0; j < array.extent[1]; ++j) {
    rows[0].numbers.push_back(numbered(j, numbering));
  }
  const std::vector<std::int32_t> values = numbered_all(array, numbering);
  for (std::size_t i = 0; i * columns < values.size(); ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * columns);
    rows.push_back({fmt::format("{:>4}", numbered(static_cast<std::int32_t>(i), numbering)),
                    {first, first + static_cast<std::ptrdiff_t>(columns)}});
  }
  return fmt::format("  {}, i down, j across\n{}", label_of(array), rows_text(rows));
}

std::string lists_text(std::span<const RecordedArray> arrays, Numbering numbering,
                       std::size_t label_width) {
  std::vector<NumberRow> rows(1);
  rows[0].label = name_of(arrays[0].indexed_by);
  for (std::size_t k = 0; k < arrays[0].values.size(); ++k) {
    rows[0].numbers.push_back(numbered(static_cast<std::int32_t>(k), numbering));
  }
  for (const RecordedArray& array : arrays) {
    rows.push_back({label_of(array), numbered_all(array, numbering)});
  }
  return rows_text(rows, label_width);
}

bool share_an_index(const RecordedArray& a, const RecordedArray& b) {
  return a.indexed_by == b.indexed_by && a.values.size() == b.values.size();
}

bool is_drawn_as_matrix(const RecordedArray& array) {
  return is_grid(array) && array.extent[2] == 1 && array.extent[0] <= highest_matrix &&
         array.extent[1] <= widest_matrix;
}

}  // namespace

std::int32_t numbered(std::int32_t value, Numbering numbering) {
  return value < 0 ? value : value + static_cast<std::int32_t>(numbering);
}

std::string rows_text(std::span<const NumberRow> rows, std::size_t label_width) {
  std::size_t width = 2;
  std::size_t count = 0;
  for (const NumberRow& row : rows) {
    label_width = std::max(label_width, row.label.size());
    count = std::max(count, row.numbers.size());
    for (const std::int32_t number : row.numbers) {
      width = std::max(width, std::to_string(number).size());
    }
  }
  const std::size_t per_line =
      std::max<std::size_t>(1, (text_width - 2 - label_width) / (width + 1));
  std::string text;
  for (std::size_t first = 0; first < count; first += per_line) {
    for (const NumberRow& row : rows) {
      text += fmt::format("  {:<{}}", row.label, label_width);
      const std::size_t last = std::min(row.numbers.size(), first + per_line);
      for (std::size_t k = first; k < last; ++k)
        text += fmt::format(" {:>{}}", row.numbers[k], width);
      text += '\n';
    }
  }
  return text;
}

std::string arrays_text(std::span<const RecordedArray> arrays, Numbering numbering) {
  std::size_t label_width = 0;
  for (const RecordedArray& array : arrays) {
    if (!is_grid(array)) label_width = std::max(label_width, label_of(array).size());
  }
  std::string text;
  while (!arrays.empty()) {
    std::size_t group = 1;
    const RecordedArray& array = arrays[0];
    if (is_empty(array)) {
      text += fmt::format("  {:<{}} all -1\n", label_of(array), label_width);
    } else if (is_drawn_as_matrix(array)) {
      text += matrix_text(array, numbering);
    } else if (is_grid(array) || array.values.size() > longest_list) {
      text += "  " +
              wrapped(fmt::format("{}: {}", label_of(array), entries_text(array, numbering)),
                      text_width - 2, 4) +
              '\n';
    } else {
      while (group < arrays.size() && share_an_index(array, arrays[group]) &&
             !is_empty(arrays[group])) {
        ++group;
      }
      text += lists_text(arrays.first(group), numbering, label_width);
    }
    arrays = arrays.subspan(group);
  }
  return text;
}

}  // namespace abut::cli
