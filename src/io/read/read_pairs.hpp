#pragma once

#include <abut/pair.hpp>
#include <abut/progress.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace abut::io {

/// Numbers of elements that the numbers of a pair may name.
struct ElementCounts {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// Reads pairs of elements from columns `i` and `j` of a CSV file, as write_contacts writes them;
/// other columns are ignored. "-" is standard input. Throws Error:
///  invalid_input   one sentence with file, line, column and value
///  limit_exceeded  the pairs do not fit into memory
///  cancelled       the progress hook asked to stop
[[nodiscard]] std::vector<ContactPair> read_pairs(const std::string& path,
                                                  const ElementCounts& elements,
                                                  const ProgressHook& progress = {});

}  // namespace abut::io
