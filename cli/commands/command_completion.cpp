#include "commands/command_completion.hpp"

#include "talk.hpp"
#include "text/completion_text.hpp"
#include "text/manual_text.hpp"

namespace abut::cli {

void run(const CompletionOptions& options) {
  switch (options.reader) {
    case Reader::bash:
      return write_out(bash_completion(options.table));
    case Reader::zsh:
      return write_out(zsh_completion(options.table));
    case Reader::fish:
      return write_out(fish_completion(options.table));
    case Reader::man:
      return write_out(manual_page(options.table));
  }
}

}  // namespace abut::cli
