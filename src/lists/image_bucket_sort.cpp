#include "lists/image_bucket_sort.hpp"

#include "base/asking_sort.hpp"

#include <algorithm>
#include <utility>

namespace abut::lists {

void ImageBucketSort::sort(std::span<ContactPair> pairs, std::span<ImageShift> shifts,
                           std::size_t first_element, std::size_t width, base::WorkCounter& work) {
  base::make_room(by_first_, pairs.size());
  base::make_room(end_, width);
  const auto ends = std::span(end_).first(width);
  std::fill(ends.begin(), ends.end(), std::uint64_t{0});
  work.in_pieces(0, pairs.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) ++end_[pairs[k].first - first_element];
  });
  std::uint64_t begin = 0;
  for (std::uint64_t& end : ends) begin += std::exchange(end, begin);
  // Where an element's pairs begin becomes where they end.
  work.in_pieces(0, pairs.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      by_first_[end_[pairs[k].first - first_element]++] = {pairs[k].second, shifts[k]};
    }
  });
  std::uint64_t k = 0;
  for (std::size_t e = 0; e < width; ++e) {
    const auto partners = std::span(by_first_).subspan(k, ends[e] - k);
    base::sort_asking(partners.begin(), partners.end(), work);
    work.did(1 + partners.size());
    for (const Partner& partner : partners) {
      pairs[k] = {static_cast<ElementIndex>(first_element + e), partner.element};
      shifts[k] = partner.shift;
      ++k;
    }
  }
}

}  // namespace abut::lists
