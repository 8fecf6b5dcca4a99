#include "skin/candidate_layout.hpp"

#include "base/asking_sort.hpp"
#include "base/asking_workers.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace abut::skin {
namespace {

constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

/// Tells whether most partners are at hand, by their numbers, of some of the pairs: so few numbers
/// apart that the slots between, 256 KiB, stay in the cache. Of shuffled elements a quarter are.
/// Where there are fewer candidates than elements, slots save more.
bool follow_space(lists::PairPieces found, std::size_t element_count, base::WorkCounter& work) {
  constexpr std::size_t pairs_for_a_sample = 16;
  const std::size_t numbers_at_hand = std::min<std::size_t>(1 << 14, element_count / 8);
  std::size_t pairs = 0;
  std::uint64_t samples = 0;
  std::uint64_t at_hand = 0;
  for (const auto& piece : found) {
    work.did(1 + piece.size() / pairs_for_a_sample);
    pairs += piece.size();
    for (std::size_t k = 0; k < piece.size(); k += pairs_for_a_sample) {
      const ContactPair& pair = piece[k];
      ++samples;
      at_hand += pair.second - pair.first <= numbers_at_hand ? 1 : 0;
    }
  }
  return pairs >= element_count && 8 * at_hand >= 5 * samples;
}

/// Ascend as the candidates of one first element do in canonical order.
std::uint64_t key_of(ElementIndex second, ShiftNumber shift) {
  return std::uint64_t{second} << 16 | shift;
}
ElementIndex second_of(std::uint64_t key) {
  return static_cast<ElementIndex>(key >> 16);
}
ShiftNumber shift_of(std::uint64_t key) {
  return static_cast<ShiftNumber>(key);
}

/// Sorts the keys of a run, mostly a few.
void sort_run(std::uint64_t* keys, std::size_t count, base::WorkCounter& work) {
  constexpr std::size_t few = 24;
  if (count > few) return base::sort_asking(keys, keys + count, work);
  for (std::size_t k = 1; k < count; ++k) {
    const std::uint64_t key = keys[k];
    std::size_t place = k;
    for (; place > 0 && key < keys[place - 1]; --place) keys[place] = keys[place - 1];
    keys[place] = key;
  }
}

}  // namespace

CandidateLayout::CandidateLayout(base::MemoryMeter& memory)
    : slot_of_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      elements_(base::make_array_for_overwrite<ElementIndex>(memory, 0)),
      end_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      keys_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      candidates_(base::make_array_for_overwrite<SlotPair>(memory, 0)),
      shifts_(base::make_array_for_overwrite<ShiftNumber>(memory, 0)),
      pairs_(base::make_array_for_overwrite<ContactPair>(memory, 0)),
      places_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      canonical_shifts_(base::make_array_for_overwrite<ShiftNumber>(memory, 0)) {}

void CandidateLayout::arrange(lists::PairPieces found, std::span<const ShiftNumber> shifts,
                              std::size_t element_count, std::size_t workers,
                              base::WorkCounter& work) {
  with_shifts_ = !shifts.empty();
  size_ = 0;
  for (const auto& piece : found) size_ += piece.size();
  follows_space_ = follow_space(found, element_count, work);
  if (follows_space_) {
    take_elements_as_slots(found, element_count, work);
  } else {
    give_slots(found, element_count, work);
  }
  base::make_room(keys_, size_);
  collect_runs(found, shifts, work);
  base::make_room(candidates_, size_);
  if (with_shifts_) base::make_room(shifts_, size_);
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, slot_count_);
    sort_runs(first, last, its_work);
  });
  if (!follows_space_) list_canonically(element_count, workers, work);
}

/// Counts the candidates of each element, as give_slots() does.
void CandidateLayout::take_elements_as_slots(lists::PairPieces found, std::size_t element_count,
                                             base::WorkCounter& work) {
  slot_count_ = element_count;
  base::make_room(end_, element_count + 2);
  std::fill_n(end_.begin(), element_count + 2, 0u);
  for (const auto& piece : found) {
    work.did(1);
    work.in_pieces(0, piece.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++end_[piece[k].first + 2];
    });
  }
}

/// Counts without branches, since whether an element was met before cannot be guessed. Counts the
/// candidates of each slot, two places behind its own: where the next is to begin when they are
/// summed up.
void CandidateLayout::give_slots(lists::PairPieces found, std::size_t element_count,
                                 base::WorkCounter& work) {
  base::make_room(slot_of_, element_count);
  base::make_room(elements_, element_count + 1);
  base::make_room(end_, element_count + 2);
  std::fill_n(slot_of_.begin(), element_count, no_slot);
  std::fill_n(end_.begin(), element_count + 2, 0u);
  std::uint32_t next = 0;
  const auto meet = [&](ElementIndex element) {
    std::uint32_t slot = slot_of_[element];
    const bool is_new = slot == no_slot;
    slot = is_new ? next : slot;
    elements_[next] = element;
    slot_of_[element] = slot;
    next += is_new ? 1 : 0;
    return slot;
  };
  for (const auto& piece : found) {
    work.did(1);
    work.in_pieces(0, piece.size(), [&](std::size_t begin, std::size_t end) {
      for (const ContactPair& pair : piece.subspan(begin, end - begin)) {
        ++end_[meet(pair.first) + 2];
        meet(pair.second);
      }
    });
  }
  slot_count_ = next;
}

/// Collects the candidates of each slot. end_[slot + 1] is where they begin at first, and where
/// they end afterwards.
void CandidateLayout::collect_runs(lists::PairPieces found, std::span<const ShiftNumber> shifts,
                                   base::WorkCounter& work) {
  work.in_pieces(2, slot_count_ + 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) end_[slot] += end_[slot - 1];
  });
  std::size_t number = 0;
  for (const auto& piece : found) {
    work.did(1);
    work.in_pieces(0, piece.size(), [&](std::size_t begin, std::size_t end) {
      for (const ContactPair& pair : piece.subspan(begin, end - begin)) {
        const ShiftNumber shift = with_shifts_ ? shifts[number++] : ShiftNumber{0};
        keys_[end_[slot_of(pair.first) + 1]++] = key_of(pair.second, shift);
      }
    });
  }
}

void CandidateLayout::sort_runs(std::size_t first_slot, std::size_t last_slot,
                                base::WorkCounter& work) {
  for (std::size_t slot = first_slot; slot < last_slot;) {
    const std::size_t sorted = sort_short_runs(slot, last_slot);
    const std::size_t end = std::max(sorted, slot + 1);
    work.did(end - slot + 2 * (end_[end] - end_[slot]));
    if (sorted == slot) sort_run(keys_.data() + end_[slot], end_[slot + 1] - end_[slot], work);
    for (; slot < end; ++slot) list_run(slot);
  }
}

/// Sorts runs in vectors, from the first slot on, as far as they are short and fit a buffer;
/// returns the slot behind them.
std::size_t CandidateLayout::sort_short_runs(std::size_t first_slot, std::size_t last_slot) {
  constexpr std::size_t most_runs = 64;
  constexpr std::size_t most_keys = 512;
  static_assert(most_keys >= kernels::longest_sorted_row);
  if (kernels_.sort_word_rows == nullptr) return first_slot;
  const std::uint32_t begin = end_[first_slot];
  std::array<std::uint32_t, most_runs> ends;
  std::uint32_t runs = 0;
  for (std::size_t slot = first_slot; slot < last_slot && runs < most_runs; ++slot, ++runs) {
    const std::uint32_t end = end_[slot + 1];
    if (end - end_[slot] > kernels::longest_sorted_row || end - begin > most_keys) break;
    ends[runs] = end - begin;
  }
  if (runs == 0) return first_slot;
  const std::uint32_t count = ends[runs - 1];
  // A copy: whole vectors are read, and behind the last run lie keys that another worker sorts.
  std::array<std::uint64_t, most_keys + kernels::longest_sorted_row> keys;
  std::copy_n(keys_.data() + begin, count, keys.data());
  kernels_.sort_word_rows({keys.data(), ends.data(), runs, count}, keys_.data() + begin);
  return first_slot + runs;
}

/// Lists the candidates of a slot from their keys.
void CandidateLayout::list_run(std::size_t slot) {
  for (std::uint32_t k = end_[slot]; k < end_[slot + 1]; ++k) {
    candidates_[k] = {static_cast<std::uint32_t>(slot), slot_of(second_of(keys_[k]))};
    if (with_shifts_) shifts_[k] = shift_of(keys_[k]);
  }
}

/// Counts the candidates of the elements [first, last).
std::size_t CandidateLayout::candidates_of(std::size_t first, std::size_t last,
                                           base::WorkCounter& work) const {
  std::size_t sum = 0;
  for (std::size_t element = first; element < last; ++element) {
    work.did(1);
    const std::uint32_t slot = slot_of_[element];
    if (slot != no_slot) sum += end_[slot + 1] - end_[slot];
  }
  return sum;
}

void CandidateLayout::list_canonically(std::size_t element_count, std::size_t workers,
                                       base::WorkCounter& work) {
  base::make_room(pairs_, size_);
  base::make_room(places_, size_);
  if (with_shifts_) base::make_room(canonical_shifts_, size_);
  if (workers == 1) return list_canonically(0, element_count, 0, work);
  begins_.assign(workers, 0);
  const auto share = [&](std::size_t worker) {
    return base::share_of(worker, workers, element_count);
  };
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    begins_[worker] = candidates_of(share(worker).first, share(worker).second, its_work);
  });
  std::size_t end = 0;
  for (std::size_t& place : begins_) end += std::exchange(place, end);
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    list_canonically(share(worker).first, share(worker).second, begins_[worker], its_work);
  });
}

/// Numbers need not follow space: what each of them finds lies elsewhere in memory, and is fetched
/// some elements ahead.
void CandidateLayout::list_canonically(std::size_t first_element, std::size_t last_element,
                                       std::size_t place, base::WorkCounter& work) {
  constexpr std::size_t ahead = 32;
  const auto slot_at = [&](std::size_t element) {
    return element < last_element ? slot_of_[element] : no_slot;
  };
  for (std::size_t element = first_element; element < last_element; ++element) {
    const std::uint32_t far = slot_at(element + 2 * ahead);
    if (far != no_slot) __builtin_prefetch(end_.data() + far);
    const std::uint32_t next = slot_at(element + ahead);
    if (next != no_slot) __builtin_prefetch(keys_.data() + end_[next]);
    const std::uint32_t slot = slot_of_[element];
    if (slot == no_slot) continue;
    const std::uint32_t end = end_[slot + 1];
    work.did(1 + end - end_[slot]);
    for (std::uint32_t k = end_[slot]; k < end; ++k, ++place) {
      pairs_[place] = {static_cast<ElementIndex>(element), second_of(keys_[k])};
      places_[place] = k;
      if (with_shifts_) canonical_shifts_[place] = shift_of(keys_[k]);
    }
  }
}

}  // namespace abut::skin
