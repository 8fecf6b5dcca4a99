// abut, the tool: parses the command line, runs one command, turns errors into a sentence on
// standard error and an exit code (abut::ErrorCode).

#include "interrupt.hpp"
#include "io/quoted_text.hpp"
#include "io/write/output_file.hpp"
#include "options/parse.hpp"
#include "talk.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <new>
#include <string_view>
#include <variant>

#include <fcntl.h>
#include <unistd.h>

namespace abut::cli {
namespace {

void run(const HelpText& help) {
  write_out(help.text);
}

/// A caller may have closed a standard stream: a file opened later must not take its number.
void occupy_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Read-only, so that writing fails instead of vanishing.
    if (fcntl(descriptor, F_GETFD) == -1) static_cast<void>(open("/dev/null", O_RDONLY));
  }
}

int complain(ErrorCode code, std::string_view sentence) {
  constexpr std::size_t longest = 1000;
  talk(fmt::format("abut: {}\n", io::visible(sentence, longest)));
  return static_cast<int>(code);
}

int guarded_main(int argc, const char* const* argv) {
  try {
    std::visit([](const auto& command) { run(command); }, parse(argc, argv));
    return 0;
  } catch (const io::ClosedPipe&) {
    return 0;
  } catch (const Error& error) {
    const bool cancelled = error.code() == ErrorCode::cancelled;
    return complain(error.code(), cancelled ? "interrupted" : error.what());
  } catch (const std::bad_alloc&) {
    return complain(ErrorCode::limit_exceeded,
                    "memory ran out; take fewer elements, or count the pairs with --count");
  } catch (const std::exception& error) {
    return complain(ErrorCode::unexpected, fmt::format("unexpected failure: {}", error.what()));
  }
}

}  // namespace
}  // namespace abut::cli

int main(int argc, char** argv) {
  // Writing to a closed pipe, or more than the limit of a file allows, is an error like others
  // then.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  abut::cli::occupy_standard_streams();
  abut::cli::catch_interrupts();
  return abut::cli::guarded_main(argc, argv);
}
