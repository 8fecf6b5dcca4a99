#pragma once

#include <optional>
#include <string>

namespace abut::io {

/// The path that a chain of symbolic links leads to; it need not exist. Throws std::system_error.
[[nodiscard]] std::string followed(const std::string& path);

/// The folder of a path, "." if it names none.
[[nodiscard]] std::string folder_of(const std::string& path);

/// The descriptor that a name such as "-", "/dev/stdout" or "/dev/fd/3" stands for.
[[nodiscard]] std::optional<int> named_descriptor(const std::string& path);

}  // namespace abut::io
