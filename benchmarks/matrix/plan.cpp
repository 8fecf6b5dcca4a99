#include "benchmarks/matrix/plan.hpp"

#include "benchmarks/matrix/contestants.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <thread>

namespace abut::benchmarks {
namespace {

bool takes_part(const Entry& entry, const Plan& plan) {
  const auto holds = [](const auto& list, const auto& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  return holds(plan.threads, entry.threads) && entry.threads <= std::max(1, processors) &&
         (plan.contestants.empty() || holds(plan.contestants, entry.name));
}

/// Those whose pairs are believed, if they finish: the trivial algorithm, the book's for any
/// domain, then whoever stores pairs. The table says who it was.
std::vector<Entry> referees_of(const std::vector<Entry>& all) {
  std::vector<Entry> referees;
  for (const Entry& entry : all) {
    if (entry.task == Task::list && entry.threads == 1) referees.push_back(entry);
  }
  const auto rank = [](const Entry& entry) {
    constexpr std::array<std::string_view, 3> believed{"abut_direct_check", "abut_sorting_array",
                                                       "abut_rows"};
    return std::find(believed.begin(), believed.end(), entry.name) - believed.begin();
  };
  std::stable_sort(referees.begin(), referees.end(),
                   [&](const Entry& a, const Entry& b) { return rank(a) < rank(b); });
  return referees;
}

}  // namespace

Contestants contestants_of(const Plan& plan) {
  const std::vector<Entry> all = all_contestants();
  for (const std::string& name : plan.contestants) {
    if (std::any_of(all.begin(), all.end(), [&](const Entry& e) { return e.name == name; })) {
      continue;
    }
    throw Error(ErrorCode::wrong_usage,
                "no contestant is called '" + name + "'; `matrix list` names those found");
  }
  Contestants who{{}, referees_of(all)};
  std::copy_if(all.begin(), all.end(), std::back_inserter(who.entries),
               [&](const Entry& entry) { return takes_part(entry, plan); });
  return who;
}

}  // namespace abut::benchmarks
