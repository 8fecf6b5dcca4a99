#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {

enum class Align { left, right };

/// Columns of text, two blanks apart, as wide as their widest entry. No line ends in blanks.
class TextTable {
 public:
  explicit TextTable(std::vector<Align> columns) : columns_(std::move(columns)) {}

  void add_row(std::vector<std::string> entries) { rows_.push_back(std::move(entries)); }

  /// One line for each row, each beginning with `indent`. The first row is usually the header.
  [[nodiscard]] std::string text(std::string_view indent = "") const;

 private:
  std::vector<Align> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace abut::cli
