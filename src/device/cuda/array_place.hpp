#pragma once

#include "device/device_columns.hpp"

namespace abut::device {

/// Asks the runtime where an array lies.
[[nodiscard]] ArrayPlace place_of_array(const void* address);

}  // namespace abut::device
