#include "talk.hpp"

#include "interrupt.hpp"
#include "io/write/output_file.hpp"

#include <cstdio>

namespace abut::cli {

void talk(std::string_view text) noexcept {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
  static_cast<void>(std::fflush(stderr));
}

void write_out(std::string_view text) {
  io::OutputFile out("-", interrupted);
  out.write(text);
  out.commit();
}

}  // namespace abut::cli
