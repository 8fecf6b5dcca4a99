#include "elements/curve_sort.hpp"

#include "base/asking_workers.hpp"
#include "base/fetch_next_line.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace abut::elements {
namespace {

/// A part of so many is divided by all workers, into so many that they lie in a near cache.
constexpr std::size_t least_shared = 1 << 15;
constexpr int bits_of_all = 11;
constexpr std::size_t digits_of_all = std::size_t{1} << bits_of_all;

/// A smaller one by one worker, whose stack has room for as many counts at each of several depths.
constexpr int bits_of_one = 8;
constexpr std::size_t digits_of_one = std::size_t{1} << bits_of_one;

/// A few are sorted by insertion.
constexpr std::size_t most_inserted = 24;

std::uint64_t differing_bits_of(std::span<const CurvePlace> places, std::uint64_t one) {
  std::uint64_t bits = 0;
  for (const CurvePlace& place : places) bits |= place.along ^ one;
  return bits;
}

}  // namespace

CurveSort::CurveSort(base::MemoryMeter& memory, std::size_t elements, std::size_t workers)
    : places_(base::make_array_for_overwrite<CurvePlace>(memory, elements)),
      room_(base::make_array_for_overwrite<CurvePlace>(memory, elements)),
      cursors_(base::make_array_for_overwrite<std::size_t>(
          memory, elements < least_shared ? 0 : workers * digits_of_all)),
      differing_(base::make_array_for_overwrite<std::uint64_t>(memory, workers)),
      workers_(workers) {}

void CurveSort::write_order(std::span<ElementIndex> order, base::WorkCounter& work) {
  sort_with_all({places_, room_, order}, work);
}

void CurveSort::sort_few(const CurvePart& part) {
  const std::span<CurvePlace> places = part.places;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const CurvePlace place = places[k];
    std::size_t to = k;
    for (; to > 0 && place.along < places[to - 1].along; --to) places[to] = places[to - 1];
    places[to] = place;
  }
  std::ranges::transform(places, part.order.begin(), &CurvePlace::element);
}

void CurveSort::sort_alone(const CurvePart& part) {
  const std::size_t count = part.places.size();
  if (count <= most_inserted) return sort_few(part);
  const auto top =
      static_cast<int>(std::bit_width(differing_bits_of(part.places, part.places[0].along)));
  const int bits = std::min({top, bits_of_one, static_cast<int>(std::bit_width(count))});
  const Digit digit{top - bits, bits};
  std::array<std::uint32_t, digits_of_one + 1> begin{};
  for (const CurvePlace& place : part.places) ++begin[digit.of(place) + 1];
  const std::size_t digits = std::size_t{1} << bits;
  for (std::size_t k = 0; k < digits; ++k) begin[k + 1] += begin[k];
  std::array<std::uint32_t, digits_of_one> next;
  std::copy_n(begin.begin(), digits, next.begin());
  for (const CurvePlace& place : part.places) part.room[next[digit.of(place)]++] = place;
  for (std::size_t k = 0; k < digits; ++k) {
    sort_rest(part.in_room(begin[k], begin[k + 1] - begin[k]), digit);
  }
}

/// Sorts places that have a digit in common, and all that tells more before it.
void CurveSort::sort_rest(const CurvePart& part, const Digit& digit) {
  if (digit.shift > 0) return sort_alone(part);
  std::ranges::transform(part.places, part.order.begin(), &CurvePlace::element);
}

std::size_t* CurveSort::cursors_of(std::size_t worker) noexcept {
  return cursors_.data() + worker * digits_of_all;
}

std::uint64_t CurveSort::differing_bits(const CurvePart& part, base::WorkCounter& work) {
  const std::uint64_t one = part.places[0].along;
  base::for_each_share(workers_, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers_, part.places.size());
    differing_[worker] = 0;
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      differing_[worker] |= differing_bits_of(part.places.subspan(begin, end - begin), one);
    });
  });
  std::uint64_t bits = 0;
  for (const std::uint64_t its : differing_) bits |= its;
  return bits;
}

/// Brings the places to the room, sorted by a digit. The cursors of the last worker are then the
/// ends of all digits.
void CurveSort::divide_with_all(const CurvePart& part, const Digit& digit,
                                base::WorkCounter& work) {
  const auto for_each_place = [&](const auto& visit) {
    base::for_each_share(workers_, work, [&](std::size_t worker, base::WorkCounter& its_work) {
      const auto [first, last] = base::share_of(worker, workers_, part.places.size());
      std::size_t* const cursors = cursors_of(worker);
      its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) visit(part.places[k], cursors);
      });
    });
  };
  std::ranges::fill(cursors_, 0);
  for_each_place([&](const CurvePlace& place, std::size_t* counts) { ++counts[digit.of(place)]; });
  std::size_t next = 0;
  for (std::size_t k = 0; k < digits_of_all; ++k) {
    for (std::size_t worker = 0; worker < workers_; ++worker) {
      next += std::exchange(cursors_of(worker)[k], next);
    }
  }
  for_each_place([&](const CurvePlace& place, std::size_t* cursors) {
    CurvePlace* const to = part.room.data() + cursors[digit.of(place)]++;
    base::fetch_next_line(to);
    *to = place;
  });
}

void CurveSort::sort_with_all(const CurvePart& part, base::WorkCounter& work) {
  if (part.places.size() < least_shared) return sort_alone(part);
  const auto top = static_cast<int>(std::bit_width(differing_bits(part, work)));
  const int bits = std::min(top, bits_of_all);
  const Digit digit{top - bits, bits};
  divide_with_all(part, digit, work);
  std::array<std::size_t, digits_of_all + 1> end{};
  std::copy_n(cursors_of(workers_ - 1), digits_of_all, end.begin() + 1);
  const auto part_of = [&](std::size_t k) { return part.in_room(end[k], end[k + 1] - end[k]); };
  const auto waits = [&](const CurvePart& some) {
    return digit.shift > 0 && some.places.size() >= least_shared;
  };
  base::for_each_index(workers_, digits_of_all, work,
                       [&](std::size_t, std::size_t k, base::WorkCounter& its_work) {
                         const CurvePart some = part_of(k);
                         if (waits(some)) return;
                         sort_rest(some, digit);
                         its_work.did(some.places.size());
                       });
  for (std::size_t k = 0; k < digits_of_all; ++k) {
    if (const CurvePart some = part_of(k); waits(some)) sort_with_all(some, work);
  }
}

}  // namespace abut::elements
