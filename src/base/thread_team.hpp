#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <pthread.h>

namespace abut::base {

/// A call of body(context, w) for each share w < count of some work. The body throws nothing.
struct Work {
  void (*body)(void* context, std::size_t share) = nullptr;
  void* context = nullptr;
  std::size_t count = 0;
};

class ThreadTeam;

/// A thread beside the caller's own, and the word by which the two come to terms.
class Helper {
 public:
  /// Helper `number`, from 1, of a team that outlives it, at a place of OpenMP's (-1: at any). Null
  /// where the system refuses a thread or the memory for it.
  [[nodiscard]] static std::unique_ptr<Helper> start(ThreadTeam& team, std::size_t number,
                                                     int place,
                                                     const pthread_attr_t* attributes) noexcept;
  /// Ends the thread and waits for that; in a forked process, which has no such thread, neither.
  ~Helper();

  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  /// Hands it its share; the caller, and only when the share before is done or taken back.
  void call() noexcept;

  /// Takes a share back that was not begun; returns whether it was not, and is the caller's again.
  [[nodiscard]] bool take_back() noexcept;

  /// Has the thread end when it can; nothing is handed to it afterwards.
  void dismiss() noexcept;

 private:
  enum class State : std::uint32_t { resting, asleep, called, busy, leaving };

  Helper(ThreadTeam& team, std::size_t number, int place) noexcept
      : team_(team), number_(number), place_(place) {}

  void live() noexcept;
  [[nodiscard]] bool wait_for_call() noexcept;
  [[nodiscard]] State look() noexcept;

  std::atomic<State> state_ = State::resting;
  ThreadTeam& team_;
  std::size_t number_;
  int place_;
  bool is_started_ = false;
  pthread_t thread_{};
  /// Keeps the states of two helpers on different lines of the cache.
  [[maybe_unused]] std::array<char, 64> padding_{};
};

/// The threads that one thread of the caller's keeps for the regions of its detections: itself and
/// helpers, which sleep between regions. Helpers are made when a detection begins, and one that the
/// system refuses is done without.
class ThreadTeam {
 public:
  static constexpr std::size_t most_threads = 1024;

  ThreadTeam() = default;
  ~ThreadTeam();

  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Makes helpers until there are `threads`, the caller's included; returns how many of these
  /// there are. Not while work is done.
  std::size_t grow(std::size_t threads) noexcept;

  /// Does all shares; share 0 in the caller's thread, share k by helper k or, where that one has
  /// not begun when the caller is done with its own, in the caller's. A helper that is late
  /// therefore holds up nobody. Shares that no helper stands for go to whoever is free.
  void run(const Work& work) noexcept;

  [[nodiscard]] bool is_at_work() const noexcept { return is_at_work_; }

 private:
  friend class Helper;

  /// The part of a helper that was called.
  void help(std::size_t number) noexcept;
  void finish_part() noexcept;
  void do_shares_of_nobody() noexcept;
  void wait_for_helpers() noexcept;

  Work work_;
  std::atomic<std::size_t> next_ = 0;          ///< of the shares that no helper stands for
  std::atomic<std::uint32_t> unfinished_ = 0;  ///< helpers that were called and are not done
  std::atomic<unsigned> looks_ = 0;            ///< for work, before a thread sleeps
  bool is_at_work_ = false;
  std::size_t threads_ = 1;
  std::array<std::unique_ptr<Helper>, most_threads> helpers_;  ///< from place 1 on
};

/// The team of the calling thread: made when first asked for, gone with the thread. Null in a
/// helper, in a forked process, at the thread's end and where memory is short.
[[nodiscard]] ThreadTeam* own_team() noexcept;

/// Returns the team of this thread if one was made already, or null.
[[nodiscard]] ThreadTeam* own_team_so_far() noexcept;

}  // namespace abut::base
