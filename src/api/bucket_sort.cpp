#include "api/bucket_sort.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace abut::api {
namespace {

/// Writes the pairs of one element by their second. Few of them: the place of each is the number of
/// smaller ones, and of equal ones before it, counted without a branch that depends on the data.
template <Repeats repeats>
void place_partners(std::span<const ContactPair> pairs, std::span<ContactPair> target) {
  constexpr std::size_t few = 16;
  if (pairs.size() > few) {
    std::copy(pairs.begin(), pairs.end(), target.begin());
    std::sort(target.begin(), target.end(),
              [](const ContactPair& a, const ContactPair& b) { return a.second < b.second; });
    return;
  }
  for (const ContactPair& pair : pairs) {
    std::size_t before = 0;
    for (const ContactPair& other : pairs) before += other.second < pair.second ? 1 : 0;
    if constexpr (repeats == Repeats::possible) {
      for (const ContactPair* other = pairs.data(); other != &pair; ++other) {
        before += other->second == pair.second ? 1 : 0;
      }
    }
    target[before] = pair;
  }
}

/// Writes the pairs of each element, which end where `ends` says.
template <Repeats repeats>
void place_all(std::span<const ContactPair> by_first, std::span<const std::uint32_t> ends,
               std::span<ContactPair> target) {
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ends) {
    place_partners<repeats>(by_first.subspan(begin, end - begin),
                            target.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace

void BucketSort::sort(std::span<ContactPair> pairs, std::size_t first_element, std::size_t width,
                      Repeats repeats) {
  if (pairs.size() > std::numeric_limits<std::uint32_t>::max()) {
    return std::sort(pairs.begin(), pairs.end());
  }
  base::make_room(by_first_, pairs.size());
  base::make_room(end_, width);
  const auto ends = std::span(end_).first(width);
  std::fill(ends.begin(), ends.end(), 0u);
  for (const ContactPair& pair : pairs) ++end_[pair.first - first_element];
  std::uint32_t begin = 0;
  for (std::uint32_t& end : ends) begin += std::exchange(end, begin);
  // Where an element's pairs begin becomes where they end.
  for (const ContactPair& pair : pairs) by_first_[end_[pair.first - first_element]++] = pair;
  if (repeats == Repeats::never) return place_all<Repeats::never>(by_first_, ends, pairs);
  place_all<Repeats::possible>(by_first_, ends, pairs);
}

}  // namespace abut::api
