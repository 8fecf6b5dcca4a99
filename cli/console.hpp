#pragma once

#include "progress_display.hpp"

#include <abut/progress.hpp>

#include <string_view>

namespace abut::cli {

struct ConsoleOptions {
  bool quiet = false;
  ProgressMode progress = ProgressMode::automatic;
};

/// What a command says beside its results: notes, warnings and progress, on standard error.
class Console {
 public:
  explicit Console(const ConsoleOptions& options)
      : quiet_(options.quiet), display_(options.quiet ? ProgressMode::none : options.progress) {}

  [[nodiscard]] bool is_quiet() const noexcept { return quiet_; }

  /// A line beginning with "abut: ", unless quiet.
  void note(std::string_view sentence);

  /// The same, quiet or not: the result may not be what was meant.
  void warn(std::string_view sentence);

  [[nodiscard]] ProgressHook progress() { return display_.hook(); }

  /// The long work is over: the bar goes away.
  void finish() { display_.clear(); }

 private:
  bool quiet_;
  ProgressDisplay display_;
};

}  // namespace abut::cli
