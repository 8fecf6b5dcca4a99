#include "base/thread_team.hpp"

#include "base/float_environment.hpp"
#include "base/openmp_settings.hpp"
#include "base/process.hpp"

#include <algorithm>
#include <new>

namespace abut::base {
namespace {

/// Tells the processor that a loop waits.
void relax() noexcept {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  __asm__ volatile("yield");
#endif
}

/// Stack of a helper that suffices for the library and leaves a visitor of the caller's some room.
constexpr std::size_t least_stack = std::size_t{1} << 20;

/// Attributes of helpers. Their stacks are what the system gives by default, `ulimit -s`, but at
/// least what suffices, and no more than that where addresses are scarce.
class Attributes {
 public:
  explicit Attributes(std::size_t bound) noexcept {
    is_set_ = pthread_attr_init(&attributes_) == 0;
    std::size_t stack = 0;
    if (!is_set_ || pthread_attr_getstacksize(&attributes_, &stack) != 0) return;
    if (bound > 0 || stack < least_stack) pthread_attr_setstacksize(&attributes_, least_stack);
  }
  ~Attributes() {
    if (is_set_) pthread_attr_destroy(&attributes_);
  }

  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  [[nodiscard]] const pthread_attr_t* get() const noexcept {
    return is_set_ ? &attributes_ : nullptr;
  }

 private:
  pthread_attr_t attributes_;
  bool is_set_ = false;
};

/// Threads whose stacks leave most of the addresses to the arrays.
std::size_t threads_within(std::size_t bound) noexcept {
  if (bound == 0) return ThreadTeam::most_threads;
  return std::min(1 + bound / 8 / least_stack, ThreadTeam::most_threads);
}

struct OwnThread {
  ThreadTeam* team = nullptr;
  bool works_alone = false;  ///< a helper, or a thread that ends
};

// Of the initial-exec kind, there is room for it when a thread starts: otherwise its first use in a
// library loaded by dlopen allocates, and where that fails there is no process left.
[[gnu::tls_model("initial-exec")]] thread_local OwnThread own_thread;

/// Ends the thread's team when the thread ends; the main thread does when the process exits. The C
/// runtime keeps the library loaded until then, so that helpers never run code that is gone.
class TeamEnd {
 public:
  constexpr TeamEnd() noexcept = default;
  ~TeamEnd() {
    own_thread.works_alone = true;
    // Where a visitor exits the process, helpers may wait for this thread, and are left alone.
    if (!own_thread.team->is_at_work()) delete own_thread.team;
    own_thread.team = nullptr;
  }

  TeamEnd(const TeamEnd&) = delete;
  TeamEnd& operator=(const TeamEnd&) = delete;

  /// The first use of an object of a thread has its destructor called at the thread's end.
  void be_used() noexcept { is_used_ = true; }

 private:
  bool is_used_ = false;
};

[[gnu::tls_model("initial-exec")]] thread_local TeamEnd team_end;

}  // namespace

std::unique_ptr<Helper> Helper::start(ThreadTeam& team, std::size_t number, int place,
                                      const pthread_attr_t* attributes) noexcept {
  std::unique_ptr<Helper> helper(new (std::nothrow) Helper(team, number, place));
  if (helper == nullptr) return nullptr;
  const auto live = [](void* self) -> void* {
    static_cast<Helper*>(self)->live();
    return nullptr;
  };
  helper->is_started_ = pthread_create(&helper->thread_, attributes, live, helper.get()) == 0;
  if (!helper->is_started_) return nullptr;
  return helper;
}

Helper::~Helper() {
  if (!is_started_ || is_forked()) return;
  dismiss();
  pthread_join(thread_, nullptr);
}

void Helper::dismiss() noexcept {
  if (state_.exchange(State::leaving) == State::asleep) state_.notify_one();
}

void Helper::call() noexcept {
  if (state_.exchange(State::called) == State::asleep) state_.notify_one();
}

bool Helper::take_back() noexcept {
  State seen = State::called;
  return state_.compare_exchange_strong(seen, State::resting);
}

Helper::State Helper::look() noexcept {
  State seen = state_.load();
  for (unsigned k = team_.looks_.load(std::memory_order_relaxed); k > 0 && seen == State::resting;
       --k) {
    relax();
    seen = state_.load(std::memory_order_relaxed);
  }
  if (seen == State::resting && state_.compare_exchange_strong(seen, State::asleep)) {
    seen = State::asleep;
  }
  while (seen == State::asleep) {
    state_.wait(State::asleep);
    seen = state_.load();
  }
  return seen;
}

/// False when it is to end.
bool Helper::wait_for_call() noexcept {
  while (true) {
    State seen = look();
    if (seen == State::leaving) return false;
    // The caller may have taken the share back by now.
    if (seen == State::called && state_.compare_exchange_strong(seen, State::busy)) return true;
  }
}

void Helper::live() noexcept {
  own_thread.works_alone = true;
  openmp::stay_in_place(place_);
  while (wait_for_call()) {
    team_.help(number_);
    state_.store(State::resting);
    team_.finish_part();
  }
}

ThreadTeam::~ThreadTeam() {
  for (std::size_t k = 1; k < threads_; ++k) helpers_[k]->dismiss();
}

std::size_t ThreadTeam::grow(std::size_t threads) noexcept {
  if (threads <= threads_) return threads;
  const std::size_t bound = bound_of_address_space();
  const Attributes attributes(bound);
  const BlockedSignals blocked;
  const std::size_t before = threads_;
  for (const std::size_t end = std::min(threads, threads_within(bound)); threads_ < end;
       ++threads_) {
    const int place = openmp::place_of_thread(threads_, end);
    helpers_[threads_] = Helper::start(*this, threads_, place, attributes.get());
    if (helpers_[threads_] == nullptr) break;
  }
  if (threads_ > before) looks_ = openmp::looks_before_sleep(threads_);
  return threads_;
}

void ThreadTeam::help(std::size_t number) noexcept {
  const FloatEnvironment environment;
  work_.body(work_.context, number);
  do_shares_of_nobody();
}

void ThreadTeam::finish_part() noexcept {
  if (unfinished_.fetch_sub(1) == 1) unfinished_.notify_one();
}

void ThreadTeam::do_shares_of_nobody() noexcept {
  for (std::size_t k = next_++; k < work_.count; k = next_++) work_.body(work_.context, k);
}

void ThreadTeam::wait_for_helpers() noexcept {
  std::uint32_t seen = unfinished_.load();
  for (unsigned k = looks_.load(std::memory_order_relaxed); k > 0 && seen > 0; --k) {
    relax();
    seen = unfinished_.load();
  }
  for (; seen > 0; seen = unfinished_.load()) unfinished_.wait(seen);
}

void ThreadTeam::run(const Work& work) noexcept {
  const FloatEnvironment environment;
  const std::size_t end = std::min(work.count, threads_);
  work_ = work;
  next_ = end;
  unfinished_ = static_cast<std::uint32_t>(end - 1);
  is_at_work_ = true;
  for (std::size_t k = 1; k < end; ++k) helpers_[k]->call();
  work.body(work.context, 0);
  do_shares_of_nobody();
  for (std::size_t k = end; k-- > 1;) {
    if (!helpers_[k]->take_back()) continue;
    work.body(work.context, k);
    unfinished_.fetch_sub(1);
  }
  wait_for_helpers();
  is_at_work_ = false;
}

ThreadTeam* own_team_so_far() noexcept {
  return own_thread.works_alone || is_forked() ? nullptr : own_thread.team;
}

ThreadTeam* own_team() noexcept {
  if (own_thread.team != nullptr || own_thread.works_alone || is_forked()) {
    return own_team_so_far();
  }
  if (!may_have_threads) return nullptr;
  // The C runtime ends the process where it lacks the bytes in which it notes a destructor; more
  // than these are free again when it asks.
  std::unique_ptr<char[]> spare(new (std::nothrow) char[4096]);
  if (spare == nullptr) return nullptr;
  own_thread.team = new (std::nothrow) ThreadTeam;
  spare.reset();
  if (own_thread.team != nullptr) team_end.be_used();
  return own_thread.team;
}

}  // namespace abut::base
