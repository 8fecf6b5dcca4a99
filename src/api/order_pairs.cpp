#include "api/order_pairs.hpp"

#include "base/workers.hpp"

#include <algorithm>
#include <utility>

namespace abut::api {

/// Ranges of first elements, a power of two wide: few enough that each is written as a stream, and
/// narrow enough that the pairs of one lie in the cache.
struct PairOrder::Buckets {
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

namespace {

template <class T>
void copy_to(std::span<const T> piece, std::span<T> target, std::uint64_t begin) {
  std::copy(piece.begin(), piece.end(), target.begin() + static_cast<std::ptrdiff_t>(begin));
}

/// Calls body(k) for each piece of a worker's share.
template <class Body>
void for_each_piece(PairPieces pieces, std::size_t worker, std::size_t workers, Body&& body) {
  const auto [first, last] = base::share_of(worker, workers, pieces.size());
  for (std::size_t k = first; k < last; ++k) body(k);
}

}  // namespace

void PairOrder::find_begins(PairPieces pieces) {
  base::make_room(begin_, pieces.size());
  std::uint64_t end = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    begin_[k] = end;
    end += pieces[k].size();
  }
}

void PairOrder::join(PairPieces pieces, std::span<ContactPair> target, std::size_t workers,
                     std::size_t in_place) {
  find_begins(pieces);
  base::for_each_index(workers, pieces.size(), [&](std::size_t, std::size_t k) {
    if (begin_[k] >= in_place) copy_to(pieces[k], target, begin_[k]);
  });
}

void PairOrder::join(const ImagePieces& pieces, std::span<ContactPair> target,
                     std::span<ImageShift> shifts, std::size_t workers) {
  find_begins(pieces.pairs);
  base::for_each_index(workers, pieces.pairs.size(), [&](std::size_t, std::size_t k) {
    copy_to(pieces.pairs[k], target, begin_[k]);
    copy_to(pieces.shifts[k], shifts, begin_[k]);
  });
}

/// Afterwards each worker's cursor of a bucket is where its first pair there goes.
void PairOrder::count(PairPieces pieces, const Buckets& buckets, std::size_t workers) {
  base::make_room(cursors_, workers * buckets.count);
  base::make_room(begin_, buckets.count + 1);
  base::for_each_worker(workers, [&](std::size_t worker) {
    std::uint64_t* const own = cursors_.data() + worker * buckets.count;
    std::fill_n(own, buckets.count, std::uint64_t{0});
    for_each_piece(pieces, worker, workers, [&](std::size_t k) {
      for (const ContactPair& pair : pieces[k]) ++own[buckets.of(pair)];
    });
  });
  std::uint64_t end = 0;
  for (std::size_t b = 0; b < buckets.count; ++b) {
    begin_[b] = end;
    for (std::size_t w = 0; w < workers; ++w) {
      end += std::exchange(cursors_[w * buckets.count + b], end);
    }
  }
  begin_[buckets.count] = end;
}

void PairOrder::sort(PairPieces pieces, std::size_t element_count, std::span<ContactPair> target,
                     std::size_t workers) {
  if (target.empty()) return;
  const Buckets buckets(element_count);
  count(pieces, buckets, workers);
  while (sorts_.size() < workers) sorts_.emplace_back(memory_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    std::uint64_t* const own = cursors_.data() + worker * buckets.count;
    for_each_piece(pieces, worker, workers, [&](std::size_t k) {
      for (const ContactPair& pair : pieces[k]) target[own[buckets.of(pair)]++] = pair;
    });
  });
  base::for_each_index(workers, buckets.count, [&](std::size_t worker, std::size_t b) {
    sorts_[worker].sort(target.subspan(begin_[b], begin_[b + 1] - begin_[b]), b << buckets.shift,
                        buckets.width());
  });
}

void PairOrder::sort(const ImagePieces& pieces, std::size_t element_count,
                     std::span<ContactPair> target, std::span<ImageShift> shifts,
                     std::size_t workers) {
  if (target.empty()) return;
  const Buckets buckets(element_count);
  count(pieces.pairs, buckets, workers);
  while (image_sorts_.size() < workers) image_sorts_.emplace_back(memory_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    std::uint64_t* const own = cursors_.data() + worker * buckets.count;
    for_each_piece(pieces.pairs, worker, workers, [&](std::size_t k) {
      const auto pairs = pieces.pairs[k];
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        const std::uint64_t place = own[buckets.of(pairs[p])]++;
        target[place] = pairs[p];
        shifts[place] = pieces.shifts[k][p];
      }
    });
  });
  base::for_each_index(workers, buckets.count, [&](std::size_t worker, std::size_t b) {
    const std::uint64_t size = begin_[b + 1] - begin_[b];
    image_sorts_[worker].sort(target.subspan(begin_[b], size), shifts.subspan(begin_[b], size),
                              b << buckets.shift, buckets.width());
  });
}

}  // namespace abut::api
