#pragma once

#include <abut/progress.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace abut::base {

/// Thrown in a worker when another one has failed, so that it stops its part. It carries no
/// message: the failure itself does.
struct Stopped {};

/// Calls the caller's hook after a bounded number of steps of work; turns `cancel` into
/// Error{cancelled}.
///
/// A step is a candidate test, a comparison in a sort, or an element or a pair passed by: what
/// takes some nanoseconds. The hook is asked from the caller's thread only, which is worker 0;
/// the steps of the others count as its own (base/asking_workers.hpp).
class ProgressReporter {
 public:
  /// Some tenths of a millisecond: what asking costs does not show.
  static constexpr std::uint64_t steps_between_calls = std::uint64_t{1} << 16;

  ProgressReporter() = default;
  explicit ProgressReporter(const ProgressHook& hook) : hook_(hook ? &hook : nullptr) {}

  [[nodiscard]] bool is_asked() const noexcept { return hook_ != nullptr; }

  void begin(std::string_view phase, std::uint64_t total) {
    phase_ = phase;
    total_ = total;
    done_ = 0;
    rest();
    poll();
  }

  /// `done` elements of the phase are treated. Cheap: most calls only compare.
  void at(std::uint64_t done) {
    if (hook_ == nullptr || done % elements_between_calls != 0) return;
    done_ = done;
    poll();
  }

  /// Notes that `done` elements are treated and asks the hook at once.
  void report(std::uint64_t done) {
    done_ = done;
    poll();
  }

  /// `count` more elements of the phase are treated. For any worker; asks nobody.
  void advance(std::uint64_t count) noexcept { done_.fetch_add(count, std::memory_order_relaxed); }

  /// The share of the phase that is done: about, where images are treated too, and 0 where only a
  /// hook is told.
  [[nodiscard]] double share_done() const noexcept {
    const auto done = static_cast<double>(done_.load(std::memory_order_relaxed));
    return total_ == 0 ? 0.0 : done / static_cast<double>(total_);
  }

  /// `steps` more are done on the caller's thread. Throws Stopped where another worker has failed.
  void did(std::uint64_t steps) {
    if ((steps_ += steps) >= steps_between_calls) go_on();
  }

  /// Asks at once.
  void poll() {
    if (hook_ != nullptr) ask();
  }

  /// `steps` more are done by another worker. Throws Stopped where a worker has failed.
  void did_elsewhere(std::uint64_t steps) {
    steps_elsewhere_.fetch_add(steps, std::memory_order_relaxed);
    if (hook_ != nullptr) wake();
    if (is_stopped()) throw Stopped();
  }

  /// Asks, on the caller's thread, which has nothing more to do, while `busy` other workers do.
  void ask_while(const std::atomic<std::size_t>& busy);
  /// Ends ask_while, when `busy` has become 0.
  void wake() noexcept {
    ++news_;
    news_.notify_one();
  }

  /// All workers stop when they next tell what they did, until they rest.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool is_stopped() const noexcept {
    return stopped_.load(std::memory_order_relaxed);
  }
  void rest() noexcept { stopped_.store(false, std::memory_order_relaxed); }

  /// Counts what all workers did, on the caller's thread, when they are done.
  void join();

 private:
  static constexpr std::uint64_t elements_between_calls = 4096;

  void go_on();
  void ask();

  const ProgressHook* hook_ = nullptr;
  std::string_view phase_;
  std::uint64_t total_ = 0;
  std::uint64_t steps_ = 0;  ///< since the hook was asked
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<std::uint64_t> steps_elsewhere_ = 0;
  std::atomic<int> news_ = 0;
  std::atomic<bool> stopped_ = false;
};

/// One worker's way to say how many steps it did: cheap enough for each block of some elements.
class WorkCounter {
 public:
  WorkCounter() = default;
  WorkCounter(ProgressReporter& progress, std::size_t worker) noexcept
      : progress_(&progress), worker_(worker) {}

  [[nodiscard]] ProgressReporter& progress() const noexcept { return *progress_; }

  void did(std::uint64_t steps) {
    if (worker_ == 0) return progress_->did(steps);
    if ((steps_ += steps) >= ProgressReporter::steps_between_calls) tell();
  }

  /// Tells what it kept to itself so far.
  void tell() {
    const std::uint64_t steps = steps_;
    steps_ = 0;
    if (worker_ != 0) progress_->did_elsewhere(steps);
  }

  /// Calls body(begin, end) for pieces of [first, last), each of some thousand steps.
  template <class Body>
  void in_pieces(std::size_t first, std::size_t last, Body&& body) {
    constexpr std::size_t piece = 8192;
    while (first < last) {
      const std::size_t end = last - first < piece ? last : first + piece;
      body(first, end);
      did(end - first);
      first = end;
    }
  }

 private:
  ProgressReporter* progress_ = nullptr;
  std::size_t worker_ = 0;
  std::uint64_t steps_ = 0;  ///< not told yet; of the caller's thread none
};

}  // namespace abut::base
