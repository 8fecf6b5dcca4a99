#pragma once

#include <cstdint>

namespace abut::testing {

/// Basic blocks that this program has entered, where it is built with -fsanitize-coverage=trace-pc;
/// otherwise 0.
[[nodiscard]] std::uint64_t entered_blocks() noexcept;

}  // namespace abut::testing
