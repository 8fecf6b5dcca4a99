#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace abut::io {

/// Number of bytes at the beginning of a file that tell its format.
inline constexpr std::size_t telling_bytes = 512;

/// The facts that are known of a file before it is read.
struct FileHead {
  std::string_view text;               ///< its first bytes, `telling_bytes` if there are so many
  std::optional<std::uint64_t> bytes;  ///< of the whole; unknown for pipes
};

/// Returns what to say of a file in a format that no reader here knows; nothing where it may be
/// text. `name` is the file's, for the command that the sentence ends in.
[[nodiscard]] std::optional<std::string> foreign_format(const FileHead& file,
                                                        std::string_view name);

}  // namespace abut::io
