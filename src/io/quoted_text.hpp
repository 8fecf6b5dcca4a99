#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// The form in which text that is not the project's own (names of files and columns, values,
/// arguments) is shown: a terminal must neither obey it nor take it for another message.
namespace abut::io {

/// The character that a text begins with.
struct Character {
  std::size_t bytes = 1;    ///< of the text that it takes
  char32_t code = 0;        ///< in Unicode; of a byte that is no UTF-8 the byte itself
  bool is_utf8 = false;     ///< whether these bytes are UTF-8
  bool is_visible = false;  ///< whether a terminal shows it and does nothing else
};

/// Returns the first character of a text that is not empty. Controls, characters that turn the
/// direction of writing or have no width, and bytes that are no UTF-8 are not visible.
[[nodiscard]] Character first_character(std::string_view text) noexcept;

/// The text with \xNN for each byte of what is not visible in ASCII or no UTF-8, \u{NNNN} for other
/// characters that are not visible. Of a text of more than `most` characters the middle is left
/// out. A text that has been made visible stays as it is.
[[nodiscard]] std::string visible(std::string_view text, std::size_t most = 400);

/// The visible text between quotes: its first 40 characters.
[[nodiscard]] std::string quoted(std::string_view text);

/// A file name that can be pasted into a shell; with $'...' (POSIX 2024, section 2.2.4) where a
/// terminal would not show it as it is.
[[nodiscard]] std::string shell_quoted(std::string_view word);

}  // namespace abut::io
