#include "lists/bucket_sort.hpp"

#include "base/asking_sort.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace abut::lists {
namespace {

/// Pairs of one digit beyond which they are not left to insertion alone, quadratic as it is.
constexpr std::uint32_t crowd = 16;

/// Steps of insertion for each pair beyond which another method takes over.
constexpr std::size_t most_steps = 8;

/// Enough for the partners of one element to fall apart, few enough for the cache.
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
  [[nodiscard]] std::uint32_t operator()(const ContactPair& pair) const { return of(pair.first); }
};

struct BySecond : Digits {
  using Digits::Digits;
  [[nodiscard]] std::uint32_t operator()(const ContactPair& pair) const { return of(pair.second); }
};

/// Where partners lie, seen from a range of elements.
struct Partners {
  ElementIndex least = std::numeric_limits<ElementIndex>::max();
  ElementIndex greatest = 0;
  std::size_t near = 0;  ///< those within the range itself
};

Partners partners_of(std::span<const ContactPair> pairs, std::size_t first_element,
                     std::size_t width, base::WorkCounter& work) {
  Partners all;
  work.in_pieces(0, pairs.size(), [&](std::size_t begin, std::size_t end) {
    Partners partners = all;
    for (const ContactPair& pair : pairs.subspan(begin, end - begin)) {
      partners.least = std::min(partners.least, pair.second);
      partners.greatest = std::max(partners.greatest, pair.second);
      partners.near += pair.second - first_element < width ? 1 : 0;
    }
    all = partners;
  });
  return all;
}

/// One comparison instead of two, the second of which would be a guess.
std::uint64_t key_of(const ContactPair& pair) {
  return std::uint64_t{pair.first} << 32 | pair.second;
}

/// `ends` says where the digits' pairs end.
bool has_crowd(std::span<const std::uint32_t> ends) {
  std::uint32_t begin = 0;
  std::uint32_t most = 0;
  for (const std::uint32_t end : ends) most = std::max(most, end - std::exchange(begin, end));
  return most > crowd;
}

/// Whether so many are out of order that insertion would guess as often as not.
bool is_shuffled(std::span<const ContactPair> pairs, base::WorkCounter& work) {
  std::size_t descents = 0;
  work.in_pieces(1, pairs.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t in_piece = 0;
    for (std::size_t k = begin; k < end; ++k) {
      in_piece += key_of(pairs[k]) < key_of(pairs[k - 1]) ? 1 : 0;
    }
    descents += in_piece;
  });
  return descents > pairs.size() / 4;
}

/// For pairs that are nearly in order. Where many are not, or one is far from its place, another
/// method takes over.
void sort_by_insertion(std::span<ContactPair> pairs, base::WorkCounter& work) {
  constexpr std::size_t farthest = std::size_t{1} << 16;
  constexpr std::size_t piece = 4096;
  std::size_t steps_left = most_steps * pairs.size();
  for (std::size_t begin = 1; begin < pairs.size(); begin += piece) {
    const std::size_t end = std::min(begin + piece, pairs.size());
    const std::size_t least = begin - std::min(begin, farthest);
    const std::size_t steps_before = steps_left;
    for (std::size_t k = begin; k < end; ++k) {
      const ContactPair pair = pairs[k];
      std::size_t place = k;
      for (; place > least && key_of(pair) < key_of(pairs[place - 1]); --place) {
        pairs[place] = pairs[place - 1];
      }
      pairs[place] = pair;
      if (k - place > steps_left || (place == least && least > 0)) {
        return base::sort_asking(pairs.begin(), pairs.end(), work);
      }
      steps_left -= k - place;
    }
    work.did(end - begin + (steps_before - steps_left));
  }
}

}  // namespace

/// Stable. Says where each digit's pairs end.
template <class Digit>
std::span<const std::uint32_t> BucketSort::scatter(std::span<const ContactPair> from, Digit digit,
                                                   std::span<ContactPair> target,
                                                   base::WorkCounter& work) {
  base::make_room(places_, digit.count());
  const auto places = std::span(places_).first(digit.count());
  std::fill(places.begin(), places.end(), 0u);
  work.in_pieces(0, from.size(), [&](std::size_t begin, std::size_t end) {
    // As a copy, of which the compiler knows that nothing written here changes it.
    const Digit digit_of = digit;
    for (const ContactPair& pair : from.subspan(begin, end - begin)) ++places[digit_of(pair)];
  });
  std::uint32_t next = 0;
  for (std::uint32_t& place : places) next += std::exchange(place, next);
  work.did(places.size());
  work.in_pieces(0, from.size(), [&](std::size_t begin, std::size_t end) {
    const Digit digit_of = digit;
    for (const ContactPair& pair : from.subspan(begin, end - begin)) {
      target[places[digit_of(pair)]++] = pair;
    }
  });
  return places;
}

void BucketSort::sort(std::span<ContactPair> pairs, std::size_t first_element, std::size_t width,
                      base::WorkCounter& work) {
  if (pairs.size() > std::numeric_limits<std::uint32_t>::max()) {
    return base::sort_asking(pairs.begin(), pairs.end(), work);
  }
  if (pairs.empty()) return;
  base::make_room(moved_, pairs.size());
  const std::span<ContactPair> moved = std::span(moved_).first(pairs.size());
  const auto first = static_cast<ElementIndex>(first_element);
  // Where most elements have no pair, some to a digit: empty digits cost as much as pairs.
  const ByFirst by_first(first, static_cast<ElementIndex>(first_element + width - 1),
                         2 * pairs.size());
  const Partners partners = partners_of(pairs, first_element, width, work);
  // Few need no order among partners; those numbered nearby may have been found nearly in order.
  if (pairs.size() < width / 2 || partners.near > pairs.size() / 2) {
    const auto ends = scatter(pairs, by_first, moved, work);
    if (!has_crowd(ends) && !is_shuffled(moved, work)) {
      std::copy(moved.begin(), moved.end(), pairs.begin());
      return sort_by_insertion(pairs, work);
    }
  }
  const BySecond by_second(partners.least, partners.greatest, most_partner_digits(pairs.size()));
  scatter(pairs, by_second, moved, work);
  scatter(moved, by_first, pairs, work);
  sort_by_insertion(pairs, work);
}

}  // namespace abut::lists
