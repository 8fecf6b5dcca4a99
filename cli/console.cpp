#include "console.hpp"

#include "io/quoted_text.hpp"
#include "talk.hpp"

#include <fmt/format.h>

namespace abut::cli {

void Console::note(std::string_view sentence) {
  if (!quiet_) warn(sentence);
}

void Console::warn(std::string_view sentence) {
  constexpr std::size_t longest = 1000;
  display_.clear();
  talk(fmt::format("abut: {}\n", io::visible(sentence, longest)));
}

}  // namespace abut::cli
