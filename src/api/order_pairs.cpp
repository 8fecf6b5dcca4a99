#include "api/order_pairs.hpp"

#include "base/workers.hpp"

#include <algorithm>
#include <utility>

namespace abut::api {
namespace {

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

}  // namespace

void PairOrder::join(PairPieces pieces, std::span<ContactPair> target, std::size_t workers) {
  base::make_room(begin_, pieces.size());
  std::uint64_t end = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    begin_[k] = end;
    end += pieces[k].size();
  }
  base::for_each_index(workers, pieces.size(), [&](std::size_t, std::size_t k) {
    std::copy(pieces[k].begin(), pieces[k].end(),
              target.begin() + static_cast<std::ptrdiff_t>(begin_[k]));
  });
}

void PairOrder::sort(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
                     std::size_t workers) {
  if (target.empty()) return;
  const Buckets buckets(element_count);
  base::make_room(cursors_, workers * buckets.count);
  base::make_room(begin_, buckets.count + 1);
  while (sorts_.size() < workers) sorts_.emplace_back(memory_);
  const auto for_each_pair = [&](std::size_t worker, auto&& body) {
    const auto [first, last] = base::share_of(worker, workers, pieces.size());
    std::uint64_t* const own = cursors_.data() + worker * buckets.count;
    for (std::size_t k = first; k < last; ++k) {
      for (const ContactPair& pair : pieces[k]) body(own[buckets.of(pair)], pair);
    }
  };
  base::for_each_worker(workers, [&](std::size_t worker) {
    std::fill_n(cursors_.data() + worker * buckets.count, buckets.count, std::uint64_t{0});
    for_each_pair(worker, [](std::uint64_t& count, const ContactPair&) { ++count; });
  });
  std::uint64_t end = 0;
  for (std::size_t b = 0; b < buckets.count; ++b) {
    begin_[b] = end;
    for (std::size_t w = 0; w < workers; ++w) {
      end += std::exchange(cursors_[w * buckets.count + b], end);
    }
  }
  begin_[buckets.count] = end;
  base::for_each_worker(workers, [&](std::size_t worker) {
    for_each_pair(worker,
                  [&](std::uint64_t& cursor, const ContactPair& pair) { target[cursor++] = pair; });
  });
  base::for_each_index(workers, buckets.count, [&](std::size_t worker, std::size_t b) {
    sorts_[worker].sort(target.subspan(begin_[b], begin_[b + 1] - begin_[b]), b << buckets.shift,
                        buckets.width());
  });
}

}  // namespace abut::api
