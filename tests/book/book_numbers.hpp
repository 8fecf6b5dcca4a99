#pragma once

#include "book/recorded_trace.hpp"

#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

/// The examples of A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, stand in
/// the tests with the book's numbers: elements and cells counted from 1, none -1.
namespace abut::testing {

using BookCell = std::pair<std::int32_t, std::int32_t>;
using BookPair = std::pair<std::int32_t, std::int32_t>;
using Numbers = std::vector<std::int32_t>;

/// Elements 1, 2, ... by the book's cells (i, j), in its grid of 10 x 10 cells.
[[nodiscard]] inline trace::CellSystem book_system(std::initializer_list<BookCell> cells) {
  trace::CellSystem system;
  system.dimensions = 2;
  system.cell_count = {10, 10, 1};
  for (const auto& [i, j] : cells) system.cells.push_back({i - 1, j - 1, 0});
  return system;
}

/// The values as the book writes them.
[[nodiscard]] inline Numbers in_book_numbers(const ShownArray& shown) {
  Numbers values = shown.values;
  for (std::int32_t& value : values) {
    if (value >= 0) ++value;
  }
  return values;
}

/// Candidate pairs as the book writes them, ascending, repetitions kept.
[[nodiscard]] inline std::vector<BookPair> in_book_numbers(const RecordedTrace& recorded) {
  std::vector<BookPair> pairs;
  for (const ContactPair& pair : recorded.sorted_candidates()) {
    pairs.emplace_back(pair.first + 1, pair.second + 1);
  }
  return pairs;
}

/// The list that begins with `head`, following `next`; both in the book's numbers.
[[nodiscard]] inline Numbers book_list(std::int32_t head, const Numbers& next) {
  Numbers list;
  for (std::int32_t e = head; e != -1; e = next.at(static_cast<std::size_t>(e - 1))) {
    list.push_back(e);
    if (list.size() > next.size()) throw std::out_of_range("the list never ends");
  }
  return list;
}

/// The titles' cells of all stages called so, along one axis, in the book's numbers.
[[nodiscard]] inline Numbers order_met(const RecordedTrace& recorded, std::string_view title,
                                       std::size_t axis) {
  Numbers order;
  for (const ShownStage* shown : recorded.stages_called(title)) {
    order.push_back(shown->cell.at(axis) + 1);
  }
  return order;
}

}  // namespace abut::testing
