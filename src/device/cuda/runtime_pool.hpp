#pragma once

#include <abut/device.hpp>

namespace abut::device {

/// The memory pool of the runtime, in the order of streams.
[[nodiscard]] Allocator pool_of_runtime();

/// The same allocator, but that the runtime keeps no error where it has no memory.
[[nodiscard]] Allocator without_errors(Allocator allocator);

}  // namespace abut::device
