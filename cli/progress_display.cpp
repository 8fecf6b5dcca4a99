#include "progress_display.hpp"

#include "interrupt.hpp"
#include "talk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <unistd.h>

namespace abut::cli {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds patience{500};
constexpr milliseconds between_bars{100};
constexpr seconds between_lines{10};

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// A bar needs a terminal that can return to the beginning of a line. It has no colour, so that
/// NO_COLOR has nothing to take away.
bool bar_is_welcome() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  return isatty(STDERR_FILENO) == 1 && !dumb && !is_set("CI");
}

std::string_view name_of_phase(std::string_view phase) {
  return phase == "gather" ? "search" : phase;
}

std::string clock_text(double time) {
  const auto whole = std::lround(time);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

double fraction_of(const Progress& progress) {
  if (progress.total == 0) return 0.0;
  return std::min(1.0, static_cast<double>(progress.done) / static_cast<double>(progress.total));
}

std::string bar_text(std::string_view phase, double fraction, double phase_time, double time) {
  if (fraction <= 0.0) return fmt::format("{:<6}  {}", phase, clock_text(time));
  constexpr std::size_t width = 30;
  const auto filled = static_cast<std::size_t>(fraction * static_cast<double>(width));
  return fmt::format("{:<6} {:3.0f} % [{:-<{}}] {} left", phase, fraction * 100.0,
                     std::string(filled, '#'), width,
                     clock_text(phase_time * (1.0 - fraction) / fraction));
}

}  // namespace

ProgressDisplay::ProgressDisplay(ProgressMode mode, Clock::time_point start)
    : mode_(mode), start_(start), phase_start_(start) {
  if (mode_ == ProgressMode::automatic) {
    mode_ = bar_is_welcome() ? ProgressMode::bar : ProgressMode::log;
  }
  next_ = start_;
  if (mode_ == ProgressMode::bar) next_ += patience;
  if (mode_ == ProgressMode::log) next_ += between_lines;
}

ProgressHook ProgressDisplay::hook() {
  return [this](const Progress& progress) {
    if (mode_ != ProgressMode::none) show(progress);
    return interrupted() ? ProgressAction::cancel : ProgressAction::proceed;
  };
}

void ProgressDisplay::show(const Progress& progress, Clock::time_point now) {
  const std::string_view phase = name_of_phase(progress.phase);
  if (phase != phase_) {
    phase_ = phase;
    phase_start_ = now;
  }
  if (now < next_) return;
  const double time = duration<double>(now - start_).count();
  const double phase_time = duration<double>(now - phase_start_).count();
  const double fraction = fraction_of(progress);
  if (mode_ == ProgressMode::bar) {
    draw(bar_text(phase, fraction, phase_time, time));
    next_ = now + between_bars;
  } else {
    const std::string share = fraction > 0.0 ? fmt::format(" {:.0f} %", fraction * 100.0) : "";
    talk(fmt::format("abut: {}{} after {}\n", phase, share, clock_text(time)));
    next_ = now + between_lines;
  }
}

void ProgressDisplay::draw(const std::string& line) {
  talk(fmt::format("\r{:<{}}", line, drawn_));
  drawn_ = std::max(drawn_, line.size());
}

void ProgressDisplay::clear() {
  if (drawn_ == 0) return;
  talk(fmt::format("\r{:<{}}\r", "", drawn_));
  drawn_ = 0;
}

}  // namespace abut::cli
