#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/element_ids.hpp"
#include "history/carried_pairs.hpp"
#include "history/cell_jumps.hpp"
#include "history/moved_values.hpp"
#include "history/pairs_found_again.hpp"

#include <abut/contact_history.hpp>
#include <abut/error.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut::detail {

struct ContactMatcher::State {
  // State of the step that was accepted last.
  PairArray pairs;
  ShiftArray shifts;  ///< empty where all are 0
  elements::ElementIds ids;
  history::CellJumps jumps;

  // State of the step that was matched last.
  PairArray next_pairs;
  ShiftArray next_shifts;
  elements::ElementIds next_ids;
  bool ids_change = false;
  std::vector<std::uint32_t> number_before;
  std::vector<std::uint32_t> number_now;
  history::CarriedPairs carried;
  history::PairsFoundAgain found;
  std::vector<Lost> lost;
  history::MovedValues moved;

  // What is read after accept(): that of a match that fails stays in `found`.
  std::vector<PairCount> born;
  std::vector<PairCount> flipped;

  int threads = 0;
  std::size_t workers = 1;  ///< of this step

  void carry(const ElementView& elements, const Domain& domain,
             std::span<const std::uint64_t> given);
  void lose(PairCount origin) {
    lost.push_back({origin, ids.of(pairs[origin].first), ids.of(pairs[origin].second)});
  }
  void lose_those_without_elements();
  void keep(const PairList& list, bool with_shifts);
  void match(const PairList& list, const ElementView& elements, const Domain& domain,
             std::span<const std::uint64_t> given);
};

/// The pairs of the step before, called as they are called now.
void ContactMatcher::State::carry(const ElementView& elements, const Domain& domain,
                                  std::span<const std::uint64_t> given) {
  const std::size_t count = elements.size();
  number_before.clear();
  ids_change = !ids.same(given, count);
  if (ids_change) {
    next_ids.set(given, count);
    next_ids.find_in(ids, number_before);
    ids.find_in(next_ids, number_now);
  }
  jumps.find(elements, domain, number_before, workers);
  if (ids_change) {
    carried.renumber(pairs, shifts, jumps, number_now);
  } else {
    carried.keep(pairs, shifts, jumps);
  }
}

void ContactMatcher::State::lose_those_without_elements() {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (number_now[pairs[k].first] == elements::ElementIds::none ||
        number_now[pairs[k].second] == elements::ElementIds::none) {
      lose(k);
    }
  }
}

/// Copies the list: that of a detector is valid until its next call.
void ContactMatcher::State::keep(const PairList& list, bool with_shifts) {
  next_pairs.resize(list.size());
  next_shifts.resize(with_shifts ? list.size() : 0);
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, list.size());
    std::copy_n(list.pairs().data() + first, last - first, next_pairs.data() + first);
    if (!with_shifts) return;
    std::copy_n(list.shifts().data() + first, last - first, next_shifts.data() + first);
  });
}

void ContactMatcher::State::match(const PairList& list, const ElementView& elements,
                                  const Domain& domain, std::span<const std::uint64_t> given) {
  detect::require_dimensions(elements, domain);
  const bool with_shifts = domain.is_periodic();
  if (with_shifts && list.shifts().size() != list.size()) {
    throw Error(ErrorCode::wrong_usage,
                "pairs of a periodic domain without their image shifts; set Options::shifts to "
                "stored");
  }
  workers = base::worker_count(threads, elements.size());
  lost.clear();
  carry(elements, domain, given);
  keep(list, with_shifts);
  found.find({next_pairs, next_shifts, elements.size()}, carried, workers);
  for (const PairCount origin : found.lost()) lose(origin);
  if (ids_change) lose_those_without_elements();
  std::sort(lost.begin(), lost.end(),
            [](const Lost& a, const Lost& b) { return a.before < b.before; });
}

ContactMatcher::ContactMatcher(const Options& options)
    : state_(base::reporting_lack_of_memory([] { return std::make_unique<State>(); })) {
  detect::require_threads(options);
  state_->threads = options.threads;
}
ContactMatcher::~ContactMatcher() = default;
ContactMatcher::ContactMatcher(ContactMatcher&&) noexcept = default;
ContactMatcher& ContactMatcher::operator=(ContactMatcher&&) noexcept = default;

void ContactMatcher::match(const PairList& list, const ElementView& elements, const Domain& domain,
                           std::span<const std::uint64_t> ids) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] { state_->match(list, elements, domain, ids); });
}

void ContactMatcher::lack_memory() {
  base::report_lack_of_memory();
}

void ContactMatcher::accept() noexcept {
  State& state = *state_;
  state.pairs.swap(state.next_pairs);
  state.shifts.swap(state.next_shifts);
  if (state.ids_change) std::swap(state.ids, state.next_ids);
  state.jumps.accept();
  state.found.swap_places(state.born, state.flipped);
}

bool ContactMatcher::keeps_order() const noexcept {
  const auto runs = state_->found.runs();
  return std::is_sorted(runs.begin(), runs.end(),
                        [](const Run& a, const Run& b) { return a.before < b.before; });
}

void ContactMatcher::move_values(const Values& values) {
  base::reporting_lack_of_memory(
      [&] { state_->moved.shift(state_->found.runs(), values, state_->workers); });
}

void ContactMatcher::copy_values(const std::byte* from, const Values& to) {
  base::reporting_lack_of_memory(
      [&] { history::MovedValues::copy(state_->found.runs(), from, to, state_->workers); });
}

std::span<const PairCount> ContactMatcher::born() const noexcept {
  return state_->born;
}
std::span<const PairCount> ContactMatcher::flipped() const noexcept {
  return state_->flipped;
}
std::span<const ContactMatcher::Lost> ContactMatcher::lost() const noexcept {
  return state_->lost;
}

}  // namespace abut::detail
