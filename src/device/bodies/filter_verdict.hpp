#pragma once

#include <cstdint>

namespace abut::device {

/// What a filter says of a candidate: only `doubtful` ones are decided exactly.
enum class FilterVerdict : std::uint8_t { apart, doubtful, within };

}  // namespace abut::device
