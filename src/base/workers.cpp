#include "base/workers.hpp"

#include "base/float_environment.hpp"

#include <algorithm>

#if defined(_OPENMP)
#include <omp.h>
#include <pthread.h>
#endif

namespace abut::base {

#if defined(_OPENMP)
namespace {

/// The threads of OpenMP do not survive a fork; GCC's runtime waits for them for ever.
class ForkWitness {
 public:
  ForkWitness() {
    pthread_atfork(nullptr, nullptr, [] { forked_.store(true); });
  }
  [[nodiscard]] static bool forked() { return forked_.load(); }

 private:
  static inline std::atomic<bool> forked_ = false;
};

const ForkWitness fork_witness;

}  // namespace

std::size_t worker_count(int asked, std::size_t elements) {
  if (ForkWitness::forked()) return 1;
  if (asked > 0) return static_cast<std::size_t>(asked);
  // Waking a thread takes as long as detecting the contacts of some thousand elements.
  constexpr std::size_t worth_a_thread = 8192;
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  return std::clamp(elements / worth_a_thread, std::size_t{1}, threads);
}

void detail::run_on_threads(std::size_t count, void (*body)(void* context, std::size_t worker),
                            void* context) {
#pragma omp parallel num_threads(static_cast <int>(count))
  {
    const FloatEnvironment environment;
    // OpenMP may grant fewer threads than asked for.
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
    for (auto w = static_cast<std::size_t>(omp_get_thread_num()); w < count; w += threads) {
      body(context, w);
    }
  }
}
#else
std::size_t worker_count(int, std::size_t) {
  return 1;
}

void detail::run_on_threads(std::size_t count, void (*body)(void* context, std::size_t worker),
                            void* context) {
  for (std::size_t w = 0; w < count; ++w) body(context, w);
}
#endif

}  // namespace abut::base
