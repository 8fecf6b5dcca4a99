#pragma once

#include "io/read/line_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace abut::io {

/// The number of elements that a header line says. Throws Error{invalid_input} unless it is a whole
/// number from 0.
[[nodiscard]] std::uint64_t parse_element_count(const LineReader& reader, std::string_view text);

/// Elements that a count from a header may make room for: all of them where the bytes of the file
/// suffice for so many lines of so many columns, few where the size of the input is unknown.
/// Throws Error{invalid_input} where they do not suffice.
[[nodiscard]] std::size_t room_for(const LineReader& reader, std::uint64_t count,
                                   std::size_t columns);

}  // namespace abut::io
