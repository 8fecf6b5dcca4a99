#include "lists/bucket_sort.hpp"

#include "base/asking_sort.hpp"
#include "lists/far_apart.hpp"

#include <algorithm>
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

/// Tells whether most partners, judged by a few of them, are elements of the range themselves.
template <RangeEntry Entry>
bool are_near(std::span<const Entry> entries, std::size_t first_element, std::size_t width) {
  constexpr std::size_t asked = 64;
  const std::size_t step = std::max<std::size_t>(entries.size() / asked, 1);
  std::size_t near = 0;
  std::size_t all = 0;
  for (std::size_t k = 0; k < entries.size(); k += step, ++all) {
    near += pair_of(entries[k]).second - first_element < width ? 1 : 0;
  }
  return near > all / 2;
}

/// Digits of second elements that tell most partners of one element apart.
template <RangeEntry Entry>
BySecond digits_of_partners(std::span<const Entry> entries, base::WorkCounter& work) {
  ElementIndex least = std::numeric_limits<ElementIndex>::max();
  ElementIndex greatest = 0;
  work.in_pieces(0, entries.size(), [&](std::size_t begin, std::size_t end) {
    ElementIndex least_of_piece = least;
    ElementIndex greatest_of_piece = greatest;
    for (const Entry& entry : entries.subspan(begin, end - begin)) {
      const ElementIndex partner = pair_of(entry).second;
      least_of_piece = std::min(least_of_piece, partner);
      greatest_of_piece = std::max(greatest_of_piece, partner);
    }
    least = least_of_piece;
    greatest = greatest_of_piece;
  });
  return BySecond(least, greatest, most_partner_digits(entries.size()));
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

/// Turns counts into first places.
void lay_out(std::span<std::uint32_t> places, base::WorkCounter& work) {
  std::uint32_t next = 0;
  for (std::uint32_t& place : places) next += std::exchange(place, next);
  work.did(places.size());
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

/// Counters of that many digits, all 0.
template <RangeEntry Entry>
std::span<std::uint32_t> BucketSort<Entry>::no_places(std::size_t digits) {
  base::make_room(places_, digits);
  const auto places = std::span(places_).first(digits);
  std::fill(places.begin(), places.end(), 0u);
  return places;
}

/// Sorts by a digit; entries of one digit come in any order. Returns where those of each digit end.
template <RangeEntry Entry>
template <class Digit>
std::span<const std::uint32_t> BucketSort<Entry>::scatter(std::span<const Entry> from,
                                                          const Digit& digit,
                                                          std::span<Entry> target,
                                                          base::WorkCounter& work) {
  const std::span<std::uint32_t> places = no_places(digit.count());
  const auto places_of = places.data();
  const auto* const entries = from.data();
  for_each_far_apart(from.size(), work, [digit, entries, places_of](std::size_t k) {
    ++places_of[digit(entries[k])];
  });
  lay_out(places, work);
  const auto placed = target.data();
  for_each_far_apart(from.size(), work, [digit, entries, places_of, placed](std::size_t k) {
    placed[places_of[digit(entries[k])]++] = entries[k];
  });
  return places;
}

/// Sorts by a digit, stably.
template <RangeEntry Entry>
template <class Digit>
void BucketSort<Entry>::scatter_stably(std::span<const Entry> from, const Digit& digit,
                                       std::span<Entry> target, base::WorkCounter& work) {
  const std::span<std::uint32_t> places = no_places(digit.count());
  work.in_pieces(0, from.size(), [&](std::size_t begin, std::size_t end) {
    // A copy: the compiler knows that no write below changes it.
    const Digit digit_of = digit;
    for (const Entry& entry : from.subspan(begin, end - begin)) ++places[digit_of(entry)];
  });
  lay_out(places, work);
  work.in_pieces(0, from.size(), [&](std::size_t begin, std::size_t end) {
    const Digit digit_of = digit;
    for (const Entry& entry : from.subspan(begin, end - begin)) {
      target[places[digit_of(entry)]++] = entry;
    }
  });
}

template <RangeEntry Entry>
void BucketSort<Entry>::sort(std::span<Entry> entries, std::size_t first_element, std::size_t width,
                             base::WorkCounter& work) {
  if (entries.size() > std::numeric_limits<std::uint32_t>::max()) {
    return base::sort_asking(entries.begin(), entries.end(), work);
  }
  if (entries.empty()) return;
  base::make_room(moved_, entries.size());
  const std::span<Entry> moved = std::span(moved_).first(entries.size());
  const ElementIndex first = row_origin<Entry>(first_element);
  // If most elements have no pair, several share a digit: an empty digit costs as much as a pair.
  const ByFirst by_first(first, first + static_cast<ElementIndex>(width - 1), 2 * entries.size());
  // Few pairs, and those of rows whose partners lie in the same cache lines, are sorted by
  // insertion without a pass over second elements.
  if (entries.size() < width / 2 || are_near<Entry>(entries, first_element, width)) {
    const auto ends = scatter(entries, by_first, moved, work);
    if (!has_crowd(ends) && !is_shuffled<Entry>(moved, work)) {
      std::copy(moved.begin(), moved.end(), entries.begin());
      return sort_by_insertion(entries, work);
    }
  }
  scatter(entries, digits_of_partners<Entry>(entries, work), moved, work);
  scatter_stably(moved, by_first, entries, work);
  sort_by_insertion(entries, work);
}

template class BucketSort<ContactPair>;
template class BucketSort<ImagePair>;
template class BucketSort<PackedEntry>;

}  // namespace abut::lists
