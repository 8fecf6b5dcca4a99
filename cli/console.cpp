#include "console.hpp"

#include "talk.hpp"

#include <fmt/format.h>

namespace abut::cli {

void Console::note(std::string_view sentence) {
  if (quiet_) return;
  display_.clear();
  talk(fmt::format("abut: {}\n", sentence));
}

}  // namespace abut::cli
