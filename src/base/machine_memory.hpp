#pragma once

#include <cstdint>

namespace abut::base {

/// Bytes of memory that the machine has; the largest number where the system does not say.
[[nodiscard]] std::uint64_t machine_memory();

}  // namespace abut::base
