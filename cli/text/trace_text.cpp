#include "text/trace_text.hpp"

#include "text/human_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <vector>

namespace abut::cli {
namespace {

constexpr std::size_t text_width = 100;
using Cell = std::array<std::int32_t, 3>;

std::string cell_text(const Cell& cell, Numbering numbering) {
  std::string text;
  for (const std::int32_t number : cell) {
    if (number < 0) continue;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", numbered(number, numbering));
  }
  return '(' + text + ')';
}

/// "central row 7: lists of ..." from the title "central row: lists of ..." and the place y = 7;
/// a cell is written with all its numbers.
std::string heading(const RecordedStage& stage, Numbering numbering) {
  if (!stage.is_of_a_place()) return stage.title;
  std::string place = cell_text(stage.cell, numbering);
  if (stage.cell[0] < 0) {
    place = stage.cell[1] < 0 ? fmt::format("z = {}", numbered(stage.cell[2], numbering))
                              : fmt::format("y = {}", numbered(stage.cell[1], numbering));
    if (stage.cell[1] >= 0 && stage.cell[2] >= 0) {
      place += fmt::format(", z = {}", numbered(stage.cell[2], numbering));
    }
  }
  const std::size_t colon = stage.title.find(':');
  if (colon == std::string::npos) return stage.title + ' ' + place;
  return stage.title.substr(0, colon) + ' ' + place + stage.title.substr(colon);
}

std::string range_text(std::size_t first, std::size_t last, Numbering numbering) {
  const auto number = [numbering](std::size_t k) {
    return numbered(static_cast<std::int32_t>(k), numbering);
  };
  return last - first == 1 ? fmt::format("{}", number(first))
                           : fmt::format("{}-{}", number(first), number(last - 1));
}

/// "{1-4|5-8} keep right, {5-6|7-8} keep left, {5|6} keep right".
std::string steps_text(std::span<const trace::SearchStep> steps, Numbering numbering) {
  std::string text;
  for (const trace::SearchStep& step : steps) {
    text += fmt::format("{}{{{}|{}}} keep {}", text.empty() ? "" : ", ",
                        range_text(step.first, step.middle, numbering),
                        range_text(step.middle, step.last, numbering),
                        step.kept_first == step.middle ? "right" : "left");
  }
  return text;
}

/// The sorted arrays that searches look at.
class SortedView {
 public:
  explicit SortedView(std::span<const RecordedStage> stages) {
    for (const RecordedStage& stage : stages) {
      for (const RecordedArray& array : stage.arrays) {
        if (array.book_symbol == "X") axis_[0] = &array;
        if (array.book_symbol == "Y") axis_[1] = &array;
        if (array.book_symbol == "Z") axis_[2] = &array;
        if (array.book_symbol == "D") element_ = &array;
      }
    }
  }

  [[nodiscard]] bool holds(std::size_t position, const Cell& cell) const {
    for (std::size_t k = 0; k < axis_.size(); ++k) {
      if (axis_[k] != nullptr && axis_[k]->values[position] != cell[k]) return false;
    }
    return true;
  }

  [[nodiscard]] std::int32_t element(std::size_t position) const {
    return element_->values[position];
  }

 private:
  std::array<const RecordedArray*, 3> axis_{};
  const RecordedArray* element_ = nullptr;
};

std::string search_text(const RecordedStage& stage, const SortedView& sorted, Numbering numbering) {
  const std::size_t position = stage.search_steps.back().kept_first;
  const bool found = sorted.holds(position, stage.cell);
  const std::string end =
      found ? fmt::format("position {}, element {}",
                          numbered(static_cast<std::int32_t>(position), numbering),
                          numbered(sorted.element(position), numbering))
            : "the cell is empty";
  return fmt::format("binary search for cell {}\n  {}: {} ({})\n", cell_text(stage.cell, numbering),
                     steps_text(stage.search_steps, numbering), end,
                     counted(stage.search_steps.size(), "step"));
}

std::string candidates_text(const RecordedStage& stage, Numbering numbering) {
  return "  " + pairs_text("candidate pair", stage.candidates, numbering);
}

}  // namespace

std::string trace_text(std::span<const RecordedStage> stages, Numbering numbering,
                       const SearchChoice& searches) {
  const SortedView sorted(stages);
  std::set<Cell> shown;
  std::size_t searches_done = 0;
  std::string text;
  for (const RecordedStage& stage : stages) {
    if (!stage.search_steps.empty()) {
      ++searches_done;
      const bool wanted = searches.only.has_value()
                              ? stage.cell == *searches.only
                              : sorted.holds(stage.search_steps.back().kept_first, stage.cell);
      if (wanted && shown.insert(stage.cell).second) {
        text += '\n' + search_text(stage, sorted, numbering);
      }
      continue;
    }
    if (stage.arrays.empty() && stage.candidates.empty()) continue;
    text += '\n' + heading(stage, numbering) + '\n' + arrays_text(stage.arrays, numbering);
    if (stage.is_of_a_place() && !stage.candidates.empty()) {
      text += candidates_text(stage, numbering);
    }
  }
  if (searches_done > 0) {
    text += fmt::format(
        "\nbinary searches: {}; shown: {}\n", searches_done,
        searches.only.has_value() ? "this one" : "those that find an element, each cell once");
  }
  return text;
}

std::string mapping_text(const trace::CellSystem& system, Numbering numbering) {
  std::vector<NumberRow> rows{{"element", {}}};
  for (std::size_t k = 0; k < system.cells.size(); ++k) {
    rows[0].numbers.push_back(numbered(static_cast<std::int32_t>(k), numbering));
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(system.dimensions); ++axis) {
    NumberRow row{fmt::format("cell {}", "xyz"[axis]), {}};
    for (const Cell& cell : system.cells) row.numbers.push_back(numbered(cell[axis], numbering));
    rows.push_back(std::move(row));
  }
  return rows_text(rows);
}

std::string pairs_text(std::string_view kind, std::span<const ContactPair> pairs,
                       Numbering numbering) {
  std::string text = counted(pairs.size(), kind);
  const auto shift = static_cast<ElementIndex>(numbering);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    text +=
        fmt::format("{} {}-{}", k == 0 ? ":" : "", pairs[k].first + shift, pairs[k].second + shift);
  }
  return wrapped(text, text_width, 2) + '\n';
}

}  // namespace abut::cli
