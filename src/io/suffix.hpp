#pragma once

#include <string>
#include <string_view>

namespace abut::io {

/// The suffix of the last part of a path in lower case, with its dot: ".csv"; empty if none.
[[nodiscard]] std::string suffix_of(std::string_view path);

/// Tells whether a word is in a list of words set apart by one blank.
[[nodiscard]] bool has_word(std::string_view words, std::string_view word);

}  // namespace abut::io
