#include "io/read/element_count.hpp"

#include "io/number_text.hpp"
#include "io/quoted_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace abut::io {

std::uint64_t parse_element_count(const LineReader& reader, std::string_view text) {
  const std::optional<std::int64_t> count = parse_integer(text);
  if (!count || *count < 0) {
    reader.fail_at_line(
        fmt::format("{} is no number of elements; it must be a whole number from 0", quoted(text)));
  }
  return static_cast<std::uint64_t>(*count);
}

std::size_t room_for(const LineReader& reader, std::uint64_t count, std::size_t columns) {
  constexpr std::size_t room_if_unknown = 4096;
  const std::optional<std::uint64_t> bytes = reader.bytes_left();
  if (!bytes) return static_cast<std::size_t>(std::min<std::uint64_t>(count, room_if_unknown));
  // Each column takes a character and a blank or the end of the line, which may lack at the end of
  // the file.
  const std::uint64_t most = (*bytes + 1) / (2 * columns);
  if (count > most) {
    reader.fail_at_line(
        fmt::format("{} elements are announced, but the {} bytes that follow hold at most {}; the "
                    "file is cut off or its count is wrong",
                    count, *bytes, most));
  }
  return static_cast<std::size_t>(count);
}

}  // namespace abut::io
