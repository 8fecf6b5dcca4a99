#pragma once

#include <abut/progress.hpp>

#include <cstdint>
#include <string_view>

namespace abut::base {

/// Calls the caller's hook every few thousand steps; turns `cancel` into Error{cancelled}.
class ProgressReporter {
 public:
  ProgressReporter() = default;
  explicit ProgressReporter(const ProgressHook& hook) : hook_(hook ? &hook : nullptr) {}

  void begin(std::string_view phase, std::uint64_t total) {
    now_ = {phase, 0, total};
    poll();
  }

  /// `done` elements of the phase are treated. Cheap: most calls only compare.
  void at(std::uint64_t done) {
    if (hook_ == nullptr || done % steps_between_calls != 0) return;
    now_.done = done;
    poll();
  }

  /// The same, asked at once.
  void report(std::uint64_t done) {
    now_.done = done < now_.total ? done : now_.total;
    poll();
  }

  /// For long stretches inside one element: asks whether to go on.
  void poll() {
    if (hook_ != nullptr) ask();
  }

 private:
  static constexpr std::uint64_t steps_between_calls = 4096;

  void ask() const;

  const ProgressHook* hook_ = nullptr;
  Progress now_;
};

}  // namespace abut::base
