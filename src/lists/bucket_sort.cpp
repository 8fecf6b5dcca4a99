#include "lists/bucket_sort.hpp"

#include "base/asking_sort.hpp"

#include <algorithm>
#include <concepts>
#include <limits>
#include <utility>

namespace abut::lists {
namespace {

/// Number of pairs with one digit beyond which they are not sorted by insertion alone, whose cost
/// is quadratic.
constexpr std::uint32_t crowd = 16;

/// Steps of insertion, on average for each pair, beyond which std::sort takes over.
constexpr std::size_t most_steps = 8;

/// Returns a number of digits that tells most partners of one element apart and whose counters
/// stay in the cache.
std::size_t most_partner_digits(std::size_t pairs) {
  return std::max<std::size_t>(1024, pairs / 4);
}

/// A value in a range, coarsened so that it takes few digits.
class Digits {
 public:
  Digits(std::uint32_t least, std::uint32_t greatest, std::size_t most) : least_(least) {
    while (((greatest - least) >> shift_) >= most) ++shift_;
    count_ = ((greatest - least) >> shift_) + 1;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::uint32_t of(ElementIndex element) const {
    return (element - least_) >> shift_;
  }

 private:
  std::uint32_t least_;
  std::uint32_t count_;
  int shift_ = 0;
};

struct ByFirst : Digits {
  using Digits::Digits;
  template <RangeEntry Entry>
  [[nodiscard]] std::uint32_t operator()(const Entry& entry) const {
    return of(pair_of(entry).first);
  }
};

struct BySecond : Digits {
  using Digits::Digits;
  template <RangeEntry Entry>
  [[nodiscard]] std::uint32_t operator()(const Entry& entry) const {
    return of(pair_of(entry).second);
  }
};

/// Range of the second elements of pairs, and how many lie in the range of the first ones.
struct Partners {
  ElementIndex least = std::numeric_limits<ElementIndex>::max();
  ElementIndex greatest = 0;
  std::size_t near = 0;  ///< those within the range itself
};

template <RangeEntry Entry>
Partners partners_of(std::span<const Entry> entries, std::size_t first_element, std::size_t width,
                     base::WorkCounter& work) {
  Partners all;
  work.in_pieces(0, entries.size(), [&](std::size_t begin, std::size_t end) {
    Partners partners = all;
    for (const Entry& entry : entries.subspan(begin, end - begin)) {
      const ElementIndex partner = pair_of(entry).second;
      partners.least = std::min(partners.least, partner);
      partners.greatest = std::max(partners.greatest, partner);
      partners.near += partner - first_element < width ? 1 : 0;
    }
    all = partners;
  });
  return all;
}

/// Most pairs of one digit; `ends` says where the pairs of each digit end.
std::uint32_t most_of_digit(std::span<const std::uint32_t> ends) {
  std::uint32_t begin = 0;
  std::uint32_t most = 0;
  for (const std::uint32_t end : ends) most = std::max(most, end - std::exchange(begin, end));
  return most;
}

bool has_crowd(std::span<const std::uint32_t> ends) {
  return most_of_digit(ends) > crowd;
}

/// True if so many entries are out of order that the branches of insertion could not be predicted.
template <RangeEntry Entry>
bool is_shuffled(std::span<const Entry> entries, base::WorkCounter& work) {
  std::size_t descents = 0;
  work.in_pieces(1, entries.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t in_piece = 0;
    for (std::size_t k = begin; k < end; ++k) {
      in_piece += comes_before(entries[k], entries[k - 1]) ? 1 : 0;
    }
    descents += in_piece;
  });
  return descents > entries.size() / 4;
}

/// Sorts entries that are nearly in order. If that takes too many steps, or an entry is far from
/// its place, std::sort takes over.
template <RangeEntry Entry>
void sort_by_insertion(std::span<Entry> entries, base::WorkCounter& work) {
  constexpr std::size_t farthest = std::size_t{1} << 16;
  constexpr std::size_t piece = 4096;
  std::size_t steps_left = most_steps * entries.size();
  for (std::size_t begin = 1; begin < entries.size(); begin += piece) {
    const std::size_t end = std::min(begin + piece, entries.size());
    const std::size_t least = begin - std::min(begin, farthest);
    const std::size_t steps_before = steps_left;
    for (std::size_t k = begin; k < end; ++k) {
      const Entry entry = entries[k];
      std::size_t place = k;
      for (; place > least && comes_before(entry, entries[place - 1]); --place) {
        entries[place] = entries[place - 1];
      }
      entries[place] = entry;
      if (k - place > steps_left || (place == least && least > 0)) {
        return base::sort_asking(entries.begin(), entries.end(), work);
      }
      steps_left -= k - place;
    }
    work.did(end - begin + (steps_before - steps_left));
  }
}

}  // namespace

/// Sorts by a digit, stably. Returns where the entries of each digit end.
template <RangeEntry Entry>
template <class Digit>
std::span<const std::uint32_t> BucketSort<Entry>::scatter(std::span<const Entry> from, Digit digit,
                                                          std::span<Entry> target,
                                                          base::WorkCounter& work) {
  base::make_room(places_, digit.count());
  const auto places = std::span(places_).first(digit.count());
  std::fill(places.begin(), places.end(), 0u);
  work.in_pieces(0, from.size(), [&](std::size_t begin, std::size_t end) {
    // A copy: the compiler knows that no write below changes it.
    const Digit digit_of = digit;
    for (const Entry& entry : from.subspan(begin, end - begin)) ++places[digit_of(entry)];
  });
  std::uint32_t next = 0;
  for (std::uint32_t& place : places) next += std::exchange(place, next);
  work.did(places.size());
  work.in_pieces(0, from.size(), [&](std::size_t begin, std::size_t end) {
    const Digit digit_of = digit;
    for (const Entry& entry : from.subspan(begin, end - begin)) {
      target[places[digit_of(entry)]++] = entry;
    }
  });
  return places;
}

/// Sorts the rows of `moved_` into `entries` in vectors, unless one of them is too long.
template <RangeEntry Entry>
bool BucketSort<Entry>::sort_rows(std::span<Entry> entries, std::span<const std::uint32_t> ends,
                                  std::size_t first_element, const kernels::OrderKernels& kernels,
                                  base::WorkCounter& work) const {
  if constexpr (std::same_as<Entry, ContactPair>) {
    if (kernels.sort_rows == nullptr || most_of_digit(ends) > kernels::longest_sorted_row) {
      return false;
    }
    kernels.sort_rows(
        {moved_.data(), entries.size(), static_cast<ElementIndex>(first_element), ends.data()},
        entries.data());
    work.did(entries.size());
    return true;
  }
  return false;
}

template <RangeEntry Entry>
void BucketSort<Entry>::sort(std::span<Entry> entries, std::size_t first_element, std::size_t width,
                             const kernels::OrderKernels& kernels, base::WorkCounter& work) {
  if (entries.size() > std::numeric_limits<std::uint32_t>::max()) {
    return base::sort_asking(entries.begin(), entries.end(), work);
  }
  if (entries.empty()) return;
  base::make_room(moved_, entries.size() + kernels::longest_sorted_row);
  const std::span<Entry> moved = std::span(moved_).first(entries.size());
  const ElementIndex first = row_origin<Entry>(first_element);
  // If most elements have no pair, several share a digit: an empty digit costs as much as a pair.
  const ByFirst by_first(first, first + static_cast<ElementIndex>(width - 1), 2 * entries.size());
  const Partners partners = partners_of<Entry>(entries, first_element, width, work);
  // A few pairs need no pass over second elements. Rows of elements that are numbered nearby have
  // partners in the same cache lines: vectors sort them faster than a second pass would, which is
  // faster where partners lie anywhere.
  if (entries.size() < width / 2 || partners.near > entries.size() / 2) {
    const auto ends = scatter(entries, by_first, moved, work);
    const bool digits_are_rows = by_first.count() == width;
    if (digits_are_rows && sort_rows(entries, ends, first_element, kernels, work)) return;
    if (!has_crowd(ends) && !is_shuffled<Entry>(moved, work)) {
      std::copy(moved.begin(), moved.end(), entries.begin());
      return sort_by_insertion(entries, work);
    }
  }
  const BySecond by_second(partners.least, partners.greatest, most_partner_digits(entries.size()));
  scatter(entries, by_second, moved, work);
  scatter(moved, by_first, entries, work);
  sort_by_insertion(entries, work);
}

template class BucketSort<ContactPair>;
template class BucketSort<ImagePair>;
template class BucketSort<PackedEntry>;

}  // namespace abut::lists
