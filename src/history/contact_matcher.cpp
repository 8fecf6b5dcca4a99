#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "detect/validate_options.hpp"
#include "elements/element_ids.hpp"
#include "history/carried_pairs.hpp"
#include "history/cell_jumps.hpp"

#include <abut/contact_history.hpp>
#include <abut/error.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::detail {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::wrong_usage, what);
}

/// Two ascending lists of pairs side by side; without shifts all are alike.
template <bool WithShifts>
class Merge {
 public:
  Merge(std::span<const ContactPair> now, std::span<const ImageShift> now_shifts,
        const history::CarriedPairs& before)
      : now_(now),
        now_shifts_(now_shifts),
        before_(before.pairs()),
        before_shifts_(before.shifts()) {}

  [[nodiscard]] bool equal(PairCount k, PairCount b) const {
    if constexpr (WithShifts) {
      return now_[k] == before_[b] && now_shifts_[k] == shift_before(b);
    } else {
      return now_[k] == before_[b];
    }
  }
  [[nodiscard]] bool less(PairCount k, PairCount b) const {
    if (!(now_[k] == before_[b])) return now_[k] < before_[b];
    if constexpr (WithShifts) return now_shifts_[k] < shift_before(b);
    return false;
  }
  /// True if pair k comes after pair k - 1 in canonical order.
  [[nodiscard]] bool ascends(PairCount k) const {
    if (k == 0 || now_[k - 1] < now_[k]) return true;
    if constexpr (WithShifts) {
      return now_[k - 1] == now_[k] && now_shifts_[k - 1] < now_shifts_[k];
    }
    return false;
  }
  [[nodiscard]] PairCount now_size() const { return now_.size(); }
  [[nodiscard]] PairCount before_size() const { return before_.size(); }

 private:
  [[nodiscard]] ImageShift shift_before(PairCount b) const {
    return before_shifts_.empty() ? ImageShift{} : before_shifts_[b];
  }

  std::span<const ContactPair> now_;
  std::span<const ImageShift> now_shifts_;
  std::span<const ContactPair> before_;
  std::span<const ImageShift> before_shifts_;
};

}  // namespace

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
  std::vector<Run> runs;
  std::vector<PairCount> born;
  std::vector<PairCount> flipped;
  std::vector<Lost> lost;

  // `born` and `flipped` are read after accept(): those of a match that fails stay aside.
  std::vector<PairCount> next_born;
  std::vector<PairCount> next_flipped;

  void carry(const ElementView& elements, const Domain& domain,
             std::span<const std::uint64_t> given);
  template <bool WithShifts>
  void merge(const Merge<WithShifts>& merge, std::size_t elements);
  void lose(PairCount origin) {
    lost.push_back({origin, ids.of(pairs[origin].first), ids.of(pairs[origin].second)});
  }
  void lose_those_without_elements();
  void add_born(PairCount k, std::size_t elements);
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
  jumps.find(elements, domain, number_before);
  if (ids_change) {
    carried.renumber(pairs, shifts, jumps, number_now);
  } else {
    carried.keep(pairs, shifts, jumps);
  }
}

void ContactMatcher::State::add_born(PairCount k, std::size_t elements) {
  const ContactPair& pair = next_pairs[k];
  if (pair.first > pair.second || pair.second >= elements) {
    refuse("pair " + std::to_string(k) + " is of elements " + std::to_string(pair.first) + " and " +
           std::to_string(pair.second) + ", but there are " + std::to_string(elements) +
           "; give the elements that the pairs were found for");
  }
  next_born.push_back(k);
}

template <bool WithShifts>
void ContactMatcher::State::merge(const Merge<WithShifts>& lists, std::size_t elements) {
  PairCount k = 0, b = 0;
  const auto require_ascending = [&] {
    if (lists.ascends(k)) return;
    refuse("pair " + std::to_string(k) +
           " is not in canonical order; ask for Order::canonical, and in a periodic domain for "
           "Shifts::stored");
  };
  while (k < lists.now_size() && b < lists.before_size()) {
    if (lists.equal(k, b)) {
      require_ascending();
      const Run run{k, carried.origin(b), 0};
      const PairCount first = k;
      do {
        if (carried.flipped(b)) next_flipped.push_back(k);
        ++k, ++b;
      } while (k < lists.now_size() && b < lists.before_size() && lists.equal(k, b) &&
               carried.origin(b) == run.before + (k - first));
      runs.push_back({run.now, run.before, k - first});
    } else if (lists.less(k, b)) {
      require_ascending();
      add_born(k++, elements);
    } else {
      lose(carried.origin(b++));
    }
  }
  for (; b < lists.before_size(); ++b) lose(carried.origin(b));
  for (; k < lists.now_size(); ++k) {
    require_ascending();
    add_born(k, elements);
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

void ContactMatcher::State::keep(const PairList& list, bool with_shifts) {
  next_pairs.resize(list.size());
  std::copy(list.begin(), list.end(), next_pairs.begin());
  next_shifts.resize(with_shifts ? list.size() : 0);
  if (with_shifts) std::copy(list.shifts().begin(), list.shifts().end(), next_shifts.begin());
}

void ContactMatcher::State::match(const PairList& list, const ElementView& elements,
                                  const Domain& domain, std::span<const std::uint64_t> given) {
  detect::require_dimensions(elements, domain);
  const bool with_shifts = domain.is_periodic();
  if (with_shifts && list.shifts().size() != list.size()) {
    refuse("pairs of a periodic domain without their image shifts; set Options::shifts to stored");
  }
  runs.clear();
  lost.clear();
  next_born.clear();
  next_flipped.clear();
  carry(elements, domain, given);
  keep(list, with_shifts);
  if (with_shifts) {
    merge(Merge<true>(next_pairs, next_shifts, carried), elements.size());
  } else {
    merge(Merge<false>(next_pairs, {}, carried), elements.size());
  }
  if (ids_change) lose_those_without_elements();
  std::sort(lost.begin(), lost.end(),
            [](const Lost& a, const Lost& b) { return a.before < b.before; });
}

ContactMatcher::ContactMatcher()
    : state_(base::reporting_lack_of_memory([] { return std::make_unique<State>(); })) {}
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
  state.born.swap(state.next_born);
  state.flipped.swap(state.next_flipped);
}

std::span<const ContactMatcher::Run> ContactMatcher::runs() const noexcept {
  return state_->runs;
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
