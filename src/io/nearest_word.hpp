#pragma once

#include <span>
#include <string>
#include <string_view>

namespace abut::io {

/// The word that was probably meant: the nearest by the number of letters that must be put in, left
/// out, changed or exchanged with their neighbor, at most one in three; of several the first.
/// A beginning of a single word is that word. Empty where none is near.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> known);

/// "; did you mean WORD?", or nothing where no word is near.
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace abut::io
