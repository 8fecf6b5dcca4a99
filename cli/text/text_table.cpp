#include "text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace abut::cli {

std::string TextTable::text(std::string_view indent) const {
  std::vector<std::size_t> width(columns_.size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t k = 0; k < row.size(); ++k) width[k] = std::max(width[k], row[k].size());
  }
  std::string result;
  for (const auto& row : rows_) {
    std::string line(indent);
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) line += "  ";
      line += columns_[k] == Align::left ? fmt::format("{:<{}}", row[k], width[k])
                                         : fmt::format("{:>{}}", row[k], width[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

}  // namespace abut::cli
