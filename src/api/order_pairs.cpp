#include "api/order_pairs.hpp"

#include "base/array.hpp"
#include "base/workers.hpp"

#include <algorithm>
#include <cstdint>

namespace abut::api {
namespace {

/// Few partners: insertion is faster than anything that must be called.
void sort_partners(std::span<ContactPair> pairs) {
  constexpr std::size_t few = 24;
  if (pairs.size() > few) {
    std::sort(pairs.begin(), pairs.end(),
              [](const ContactPair& a, const ContactPair& b) { return a.second < b.second; });
    return;
  }
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    const ContactPair pair = pairs[k];
    std::size_t place = k;
    for (; place > 0 && pairs[place - 1].second > pair.second; --place) {
      pairs[place] = pairs[place - 1];
    }
    pairs[place] = pair;
  }
}

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
  // begin[e] .. begin[e + 1]: where the pairs of e lie; filled from the front, one place ahead.
  auto begin = base::make_array<std::uint64_t>(memory, element_count + 2, 0);
  for (const auto piece : pieces) {
    for (const ContactPair& pair : piece) ++begin[std::size_t{pair.first} + 2];
  }
  for (std::size_t e = 2; e < begin.size(); ++e) begin[e] += begin[e - 1];
  for (const auto piece : pieces) {
    for (const ContactPair& pair : piece) target[begin[std::size_t{pair.first} + 1]++] = pair;
  }
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, element_count);
    for (std::size_t e = first; e < last; ++e) {
      sort_partners(target.subspan(begin[e], begin[e + 1] - begin[e]));
    }
  });
}

}  // namespace abut::api
