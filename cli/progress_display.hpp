#pragma once

#include <abut/progress.hpp>

#include <chrono>
#include <cstddef>
#include <string>

namespace abut::cli {

enum class ProgressMode {
  automatic,  ///< a bar on a terminal, else a log
  bar,        ///< one line that is redrawn, from half a second on
  log,        ///< one line every ten seconds
  none,
};

/// Shows on standard error how far long work is, and asks it to stop after an interrupt.
class ProgressDisplay {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ProgressDisplay(ProgressMode mode, Clock::time_point start = Clock::now());
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// Returns the hook for the work, which is valid as long as the display.
  [[nodiscard]] ProgressHook hook();

  [[nodiscard]] bool is_shown() const noexcept { return mode_ != ProgressMode::none; }

  /// Shows how far the work is, unless it was shown a short while ago.
  void show(const Progress& progress, Clock::time_point now = Clock::now());

  /// Removes the bar; called before anything else is written to the terminal.
  void clear();

 private:
  void draw(const std::string& line);

  ProgressMode mode_;
  Clock::time_point start_;
  Clock::time_point phase_start_;
  Clock::time_point next_;
  std::string phase_;
  std::size_t drawn_ = 0;
};

}  // namespace abut::cli
