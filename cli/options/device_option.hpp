#pragma once

#include <optional>
#include <string>

namespace abut::cli {

/// The device that a command line asks for; none for the processor.
using DeviceChoice = std::optional<int>;

/// "cpu", "gpu" for the first device, or "gpu:N". Throws Error{wrong_usage}.
[[nodiscard]] DeviceChoice device_given(const std::string& text);

}  // namespace abut::cli
