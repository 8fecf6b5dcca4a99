#include "history/pairs_found_again.hpp"

#include "base/workers.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

namespace abut::history {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::wrong_usage, what);
}

/// Pairs whose bytes are compared at once.
constexpr PairCount pairs_at_once = 32;
static_assert(std::has_unique_object_representations_v<ContactPair>);
static_assert(std::has_unique_object_representations_v<ImageShift>);

void append_all(auto& to, const auto& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void PairsFoundAgain::PairsOfWorker::clear() noexcept {
  runs.clear();
  born.clear();
  flipped.clear();
  lost.clear();
}

/// A run that ends where a part does goes on in the next one.
void PairsFoundAgain::PairsOfWorker::append(const PairsOfWorker& next) {
  std::span<const Run> others = next.runs;
  if (!runs.empty() && !others.empty()) {
    Run& last = runs.back();
    const Run& first = others.front();
    if (last.now + last.count == first.now && last.before + last.count == first.before) {
      last.count += first.count;
      others = others.subspan(1);
    }
  }
  append_all(runs, others);
  append_all(born, next.born);
  append_all(flipped, next.flipped);
  append_all(lost, next.lost);
}

/// Two ascending lists of pairs side by side.
template <bool WithShifts>
class PairsFoundAgain::Merge {
 public:
  Merge(const PairsOfStep& now, const CarriedPairs& before)
      : now_(now),
        before_(before),
        pairs_before_(before.pairs()),
        shifts_before_(before.shifts()) {}

  [[nodiscard]] PairCount now_size() const noexcept { return now_.pairs.size(); }
  [[nodiscard]] PairCount before_size() const noexcept { return pairs_before_.size(); }

  /// The first pair of the step before that does not come before pair k.
  [[nodiscard]] PairCount first_before(PairCount k) const noexcept {
    if (k == now_size()) return before_size();
    PairCount first = 0;
    for (PairCount left = before_size(); left > 0;) {
      const PairCount half = left / 2;
      const PairCount middle = first + half;
      const bool comes_before = !equal(k, middle) && !less(k, middle);
      if (comes_before) first = middle + 1;
      left = comes_before ? left - half - 1 : half;
    }
    return first;
  }

  /// Compares the pairs [k, end) with those [b, before_end) of the step before.
  void compare(PairCount k, PairCount end, PairCount b, PairCount before_end,
               PairsOfWorker& found) const {
    while (k < end && b < before_end) {
      if (equal(k, b)) {
        const Run run = take_run(k, end, b, before_end, found);
        k += run.count;
        b += run.count;
      } else if (less(k, b)) {
        take_born(k++, found);
      } else {
        found.lost.push_back(before_.origin(b++));
      }
    }
    for (; b < before_end; ++b) found.lost.push_back(before_.origin(b));
    for (; k < end; ++k) take_born(k, found);
  }

 private:
  [[nodiscard]] bool equal(PairCount k, PairCount b) const noexcept {
    if (now_.pairs[k] != pairs_before_[b]) return false;
    if constexpr (WithShifts) return now_.shifts[k] == shift_before(b);
    return true;
  }
  [[nodiscard]] bool less(PairCount k, PairCount b) const noexcept {
    if (now_.pairs[k] != pairs_before_[b]) return now_.pairs[k] < pairs_before_[b];
    if constexpr (WithShifts) return now_.shifts[k] < shift_before(b);
    return false;
  }
  [[nodiscard]] ImageShift shift_before(PairCount b) const noexcept {
    return shifts_before_.empty() ? ImageShift{} : shifts_before_[b];
  }

  /// Pairs that both steps have, as long as they followed each other before, too.
  Run take_run(PairCount k, PairCount end, PairCount b, PairCount before_end,
               PairsOfWorker& found) const {
    require_ascending(k);
    const PairCount most = std::min(end - k, before_end - b);
    const PairCount count =
        before_.are_renumbered() ? follow(k, b, most, found) : count_equal(k, b, most);
    return found.runs.emplace_back(Run{k, before_.origin(b), count});
  }

  /// Counts the pairs from k and from b on that are equal, which the first ones are. Most are:
  /// several are compared at once.
  [[nodiscard]] PairCount count_equal(PairCount k, PairCount b, PairCount most) const noexcept {
    PairCount count = 1;
    while (count + pairs_at_once <= most && are_equal(k + count, b + count)) count += pairs_at_once;
    while (count < most && equal(k + count, b + count)) ++count;
    return count;
  }

  [[nodiscard]] bool are_equal(PairCount k, PairCount b) const noexcept {
    const auto same = [](const auto& now, const auto& before) {
      return std::memcmp(now, before, pairs_at_once * sizeof(*now)) == 0;
    };
    if (!same(&now_.pairs[k], &pairs_before_[b])) return false;
    if constexpr (!WithShifts) return true;
    if (!shifts_before_.empty()) return same(&now_.shifts[k], &shifts_before_[b]);
    const auto shifts = now_.shifts.subspan(k, pairs_at_once);
    return std::all_of(shifts.begin(), shifts.end(),
                       [](const ImageShift& shift) { return shift == ImageShift{}; });
  }

  /// The same of pairs that were renumbered: their places before need not follow each other.
  PairCount follow(PairCount k, PairCount b, PairCount most, PairsOfWorker& found) const {
    PairCount count = 0;
    do {
      if (before_.flipped(b + count)) found.flipped.push_back(k + count);
      ++count;
    } while (count < most && equal(k + count, b + count) &&
             before_.origin(b + count) == before_.origin(b) + count);
    return count;
  }

  void take_born(PairCount k, PairsOfWorker& found) const {
    require_ascending(k);
    const ContactPair& pair = now_.pairs[k];
    if (pair.first > pair.second || pair.second >= now_.elements) {
      refuse("pair " + std::to_string(k) + " is of elements " + std::to_string(pair.first) +
             " and " + std::to_string(pair.second) + ", but there are " +
             std::to_string(now_.elements) + "; give the elements that the pairs were found for");
    }
    found.born.push_back(k);
  }

  /// Pairs that follow a kept one in its run ascend, since they did before.
  void require_ascending(PairCount k) const {
    if (k == 0 || now_.pairs[k - 1] < now_.pairs[k]) return;
    if constexpr (WithShifts) {
      if (now_.pairs[k - 1] == now_.pairs[k] && now_.shifts[k - 1] < now_.shifts[k]) return;
    }
    refuse("pair " + std::to_string(k) +
           " is not in canonical order; ask for Order::canonical, and in a periodic domain for "
           "Shifts::stored");
  }

  PairsOfStep now_;
  const CarriedPairs& before_;
  std::span<const ContactPair> pairs_before_;
  std::span<const ImageShift> shifts_before_;
};

template <bool WithShifts>
void PairsFoundAgain::find_in(const Merge<WithShifts>& lists, std::size_t workers) {
  all_.clear();
  parts_.resize(workers - 1);
  base::for_each_worker(workers, [&](std::size_t worker) {
    PairsOfWorker& found = worker == 0 ? all_ : parts_[worker - 1];
    found.clear();
    const auto [first, last] = base::share_of(worker, workers, lists.now_size());
    const PairCount first_before = worker == 0 ? 0 : lists.first_before(first);
    lists.compare(first, last, first_before, lists.first_before(last), found);
  });
  for (const PairsOfWorker& part : parts_) all_.append(part);
}

void PairsFoundAgain::find(const PairsOfStep& now, const CarriedPairs& before,
                           std::size_t workers) {
  if (now.shifts.empty()) return find_in(Merge<false>(now, before), workers);
  find_in(Merge<true>(now, before), workers);
}

}  // namespace abut::history
