#pragma once

#include "progress_display.hpp"
#include "ticker.hpp"

#include <abut/progress.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace abut::cli {

struct ConsoleOptions {
  bool quiet = false;
  ProgressMode progress = ProgressMode::automatic;
};

/// The voice of a command beside its results: notes, warnings and progress, on standard error.
class Console {
 public:
  explicit Console(const ConsoleOptions& options)
      : quiet_(options.quiet), display_(options.quiet ? ProgressMode::none : options.progress) {}

  [[nodiscard]] bool is_quiet() const noexcept { return quiet_; }

  /// A line beginning with "abut: ", unless quiet.
  void note(std::string_view sentence);

  /// Writes a warning, quiet or not: the result may not be what was meant.
  void warn(std::string_view sentence);

  [[nodiscard]] ProgressHook progress() { return display_.hook(); }

  /// Does work of so many steps that does not tell how far it is, showing that it goes on; few
  /// steps are not worth a thread.
  template <class Work>
  auto while_shown(std::string_view phase, std::uint64_t steps, const Work& work) {
    constexpr std::uint64_t few = 1'000'000;
    std::optional<Ticker> ticker;
    if (steps > few) ticker.emplace(display_, phase);
    return work();
  }

  /// The long work is over: the bar goes away.
  void finish() { display_.clear(); }

 private:
  bool quiet_;
  ProgressDisplay display_;
};

}  // namespace abut::cli
