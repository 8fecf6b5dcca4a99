#include "base/workers.hpp"

#include "base/float_environment.hpp"
#include "base/openmp_settings.hpp"
#include "base/thread_team.hpp"

#include <algorithm>

namespace abut::base {
namespace {

/// Threads that the work is worth.
std::size_t wanted_workers(int asked, std::size_t elements) noexcept {
  if (asked > 0)
    return std::min(static_cast<std::size_t>(asked), std::max(elements, std::size_t{1}));
  // Waking a thread takes as long as detecting the contacts of some thousand elements.
  constexpr std::size_t worth_a_thread = 8192;
  return workers_worth(elements, worth_a_thread, openmp::default_threads());
}

}  // namespace

std::size_t worker_count(int asked, std::size_t elements) {
  const std::size_t wanted = wanted_workers(asked, elements);
  if (wanted == 1 || openmp::grants_one_thread_only()) return 1;
  ThreadTeam* const team = own_team();
  // A detection within a region of another, from a visitor, is the thread's own.
  if (team == nullptr || team->is_at_work()) return 1;
  return team->grow(wanted);
}

void detail::run_on_threads(std::size_t count, void (*body)(void* context, std::size_t worker),
                            void* context) {
  ThreadTeam* const team = own_team_so_far();
  if (team != nullptr && !team->is_at_work()) return team->run({body, context, count});
  const FloatEnvironment environment;
  for (std::size_t w = 0; w < count; ++w) body(context, w);
}

}  // namespace abut::base
