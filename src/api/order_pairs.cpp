#include "api/order_pairs.hpp"

#include "base/array.hpp"
#include "base/workers.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace abut::api {
namespace {

/// Writes the pairs of one element by their second. Few of them: the place of each is the number of
/// smaller ones, counted without a branch that depends on the data.
void place_partners(std::span<const ContactPair> pairs, std::span<ContactPair> target) {
  constexpr std::size_t few = 16;
  if (pairs.size() > few) {
    std::copy(pairs.begin(), pairs.end(), target.begin());
    std::sort(target.begin(), target.end(),
              [](const ContactPair& a, const ContactPair& b) { return a.second < b.second; });
    return;
  }
  for (const ContactPair& pair : pairs) {
    std::size_t smaller = 0;
    for (const ContactPair& other : pairs) smaller += other.second < pair.second ? 1 : 0;
    target[smaller] = pair;
  }
}

/// Ranges of first elements, a power of two wide: few enough that each is written as a stream, and
/// narrow enough that the pairs of one lie in the cache.
struct Buckets {
  explicit Buckets(std::size_t element_count) {
    while ((element_count >> shift) >= most) ++shift;
    count = (element_count >> shift) + 1;
  }

  [[nodiscard]] std::size_t of(const ContactPair& pair) const { return pair.first >> shift; }
  [[nodiscard]] std::size_t width() const { return std::size_t{1} << shift; }

  static constexpr std::size_t most = 512;
  int shift = 11;
  std::size_t count;
};

/// Counting sort by the first element, then each element's few partners.
class BucketSort {
 public:
  BucketSort(base::MemoryMeter& memory, std::size_t width)
      : end_(base::make_array_for_overwrite<std::uint32_t>(memory, width)),
        by_first_(base::make_array_for_overwrite<ContactPair>(memory, 0)) {}

  /// First elements are first_element .. first_element + width - 1.
  void sort(std::span<ContactPair> pairs, std::size_t first_element) {
    if (pairs.size() > std::numeric_limits<std::uint32_t>::max()) {
      return std::sort(pairs.begin(), pairs.end());
    }
    base::make_room(by_first_, pairs.size());
    std::fill(end_.begin(), end_.end(), 0u);
    for (const ContactPair& pair : pairs) ++end_[pair.first - first_element];
    std::uint32_t begin = 0;
    for (std::uint32_t& end : end_) begin += std::exchange(end, begin);
    // Where an element's pairs begin becomes where they end.
    for (const ContactPair& pair : pairs) by_first_[end_[pair.first - first_element]++] = pair;
    begin = 0;
    for (const std::uint32_t end : end_) {
      place_partners(std::span<const ContactPair>(by_first_).subspan(begin, end - begin),
                     pairs.subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  base::Array<std::uint32_t> end_;
  base::Array<ContactPair> by_first_;
};

}  // namespace

void join(PairPieces pieces, std::span<ContactPair> target, std::size_t workers) {
  std::vector<std::size_t> begin;
  std::size_t end = 0;
  for (const auto piece : pieces) {
    begin.push_back(end);
    end += piece.size();
  }
  base::for_each_index(workers, pieces.size(), [&](std::size_t, std::size_t k) {
    std::copy(pieces[k].begin(), pieces[k].end(),
              target.begin() + static_cast<std::ptrdiff_t>(begin[k]));
  });
}

void order_canonically(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
                       base::MemoryMeter& memory, std::size_t workers) {
  if (target.empty()) return;
  const Buckets buckets(element_count);
  auto cursors = base::make_array<std::uint64_t>(memory, workers * buckets.count, 0);
  auto begin = base::make_array<std::uint64_t>(memory, buckets.count + 1, 0);
  const auto for_each_pair = [&](std::size_t worker, auto&& body) {
    const auto [first, last] = base::share_of(worker, workers, pieces.size());
    std::uint64_t* const own = cursors.data() + worker * buckets.count;
    for (std::size_t k = first; k < last; ++k) {
      for (const ContactPair& pair : pieces[k]) body(own[buckets.of(pair)], pair);
    }
  };
  base::for_each_worker(workers, [&](std::size_t worker) {
    for_each_pair(worker, [](std::uint64_t& count, const ContactPair&) { ++count; });
  });
  std::uint64_t end = 0;
  for (std::size_t b = 0; b < buckets.count; ++b) {
    begin[b] = end;
    for (std::size_t w = 0; w < workers; ++w) {
      end += std::exchange(cursors[w * buckets.count + b], end);
    }
  }
  begin[buckets.count] = end;
  base::for_each_worker(workers, [&](std::size_t worker) {
    for_each_pair(worker,
                  [&](std::uint64_t& cursor, const ContactPair& pair) { target[cursor++] = pair; });
  });

  std::vector<BucketSort> sorts(workers, BucketSort(memory, buckets.width()));
  base::for_each_index(workers, buckets.count, [&](std::size_t worker, std::size_t b) {
    sorts[worker].sort(target.subspan(begin[b], begin[b + 1] - begin[b]), b << buckets.shift);
  });
}

}  // namespace abut::api
