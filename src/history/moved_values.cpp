#include "history/moved_values.hpp"

#include "base/workers.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace abut::history {
namespace {

using Run = MovedValues::Run;
using Values = MovedValues::Values;

/// Saved values are no more than one of so many parts of all; else one worker moves them.
constexpr std::size_t parts_saved = 8;

/// The contacts from `first` to `last`, and the runs that they meet. Values that were behind all
/// contacts of now are in reach of the last part.
class PartOfValues {
 public:
  PartOfValues(std::span<const Run> runs, PairCount first, PairCount last, PairCount all)
      : first_(first), last_(last), end_before_(last < all ? last : behind_all) {
    const auto begin = std::partition_point(
        runs.begin(), runs.end(), [&](const Run& run) { return run.now + run.count <= first; });
    const auto end =
        std::partition_point(begin, runs.end(), [&](const Run& run) { return run.now < last; });
    runs_ = {begin, end};
  }

  [[nodiscard]] PairCount first() const noexcept { return first_; }
  [[nodiscard]] PairCount last() const noexcept { return last_; }
  [[nodiscard]] std::size_t size() const noexcept { return runs_.size(); }

  /// What of run k is in the part.
  [[nodiscard]] Run run(std::size_t k) const noexcept {
    const Run& whole = runs_[k];
    const PairCount begin = std::max(whole.now, first_);
    const PairCount end = std::min(whole.now + whole.count, last_);
    return {begin, whole.before + (begin - whole.now), end - begin};
  }

  /// What of a run was in the part before.
  [[nodiscard]] Run from_within(const Run& run) const noexcept {
    const PairCount begin = std::clamp(first_, run.before, run.before + run.count);
    const PairCount end = std::clamp(end_before_, begin, run.before + run.count);
    return {run.now + (begin - run.before), begin, end - begin};
  }

  /// Calls visit(run) with what was elsewhere, in order.
  template <class Visit>
  void for_each_from_elsewhere(Visit&& visit) const {
    for (std::size_t k = 0; k < size(); ++k) {
      const Run whole = run(k);
      const Run within = from_within(whole);
      const PairCount before_it = within.before - whole.before;
      const PairCount to_its_end = before_it + within.count;
      if (before_it > 0) visit(Run{whole.now, whole.before, before_it});
      if (to_its_end < whole.count) {
        visit(Run{whole.now + to_its_end, whole.before + to_its_end, whole.count - to_its_end});
      }
    }
  }

 private:
  static constexpr PairCount behind_all = std::numeric_limits<PairCount>::max();

  std::span<const Run> runs_;
  PairCount first_;
  PairCount last_;
  PairCount end_before_;  ///< of values that were in the part
};

PartOfValues part_of(std::span<const Run> runs, const Values& values, std::size_t worker,
                     std::size_t workers) {
  const auto [first, last] = base::share_of(worker, workers, values.count);
  return {runs, first, last, values.count};
}

PairCount count_from_elsewhere(const PartOfValues& part) {
  PairCount count = 0;
  part.for_each_from_elsewhere([&](const Run& run) { count += run.count; });
  return count;
}

/// Tells whether so many workers need not save much.
bool may_share(std::span<const Run> runs, const Values& values, std::size_t workers) {
  PairCount saved = 0;
  for (std::size_t w = 0; w < workers; ++w) {
    saved += count_from_elsewhere(part_of(runs, values, w, workers));
  }
  return saved <= values.count / parts_saved;
}

/// Moves what was in the part before. Runs keep their order and do not overlap, before or now.
/// Those that move to the front go first, the first of them first: what each writes over lies
/// before all that is still to be read. Then those that move to the back, the last of them first.
void move_within(const PartOfValues& part, const Values& values) {
  const auto move = [&](const Run& run) {
    if (run.count == 0) return;
    std::memmove(values.first + run.now * values.bytes, values.first + run.before * values.bytes,
                 run.count * values.bytes);
  };
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Run run = part.from_within(part.run(k));
    if (run.now < run.before) move(run);
  }
  for (std::size_t k = part.size(); k-- > 0;) {
    const Run run = part.from_within(part.run(k));
    if (run.now > run.before) move(run);
  }
}

void bring_saved(const PartOfValues& part, const std::byte* saved, const Values& values) {
  part.for_each_from_elsewhere([&](const Run& run) {
    std::memcpy(values.first + run.now * values.bytes, saved, run.count * values.bytes);
    saved += run.count * values.bytes;
  });
}

/// Writes the value of a new contact to the places from `begin` to `end`.
void fill(const Values& values, PairCount begin, PairCount end) {
  for (PairCount k = begin; k < end; ++k) {
    std::memcpy(values.first + k * values.bytes, values.fresh, values.bytes);
  }
}

void fill_between(const PartOfValues& part, const Values& values) {
  PairCount end = part.first();  // of the run before
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Run run = part.run(k);
    fill(values, end, run.now);
    end = run.now + run.count;
  }
  fill(values, end, part.last());
}

}  // namespace

void MovedValues::save(std::span<const Run> runs, const Values& values, std::size_t worker,
                       std::size_t workers) {
  const PartOfValues part = part_of(runs, values, worker, workers);
  std::vector<std::byte>& saved = saved_[worker];
  saved.clear();
  part.for_each_from_elsewhere([&](const Run& run) {
    const std::byte* const first = values.first + run.before * values.bytes;
    saved.insert(saved.end(), first, first + run.count * values.bytes);
  });
}

void MovedValues::shift(std::span<const Run> runs, const Values& values, std::size_t workers) {
  if (workers > 1 && !may_share(runs, values, workers)) workers = 1;
  saved_.resize(workers);
  base::for_each_worker(workers, [&](std::size_t worker) { save(runs, values, worker, workers); });
  base::for_each_worker(workers, [&](std::size_t worker) {
    const PartOfValues part = part_of(runs, values, worker, workers);
    move_within(part, values);
    bring_saved(part, saved_[worker].data(), values);
    fill_between(part, values);
  });
}

void MovedValues::copy(std::span<const Run> runs, const std::byte* from, const Values& to,
                       std::size_t workers) {
  base::for_each_worker(workers, [&](std::size_t worker) {
    const PartOfValues part = part_of(runs, to, worker, workers);
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Run run = part.run(k);
      std::memcpy(to.first + run.now * to.bytes, from + run.before * to.bytes,
                  run.count * to.bytes);
    }
    fill_between(part, to);
  });
}

}  // namespace abut::history
