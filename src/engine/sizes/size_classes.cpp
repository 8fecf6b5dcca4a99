#include "engine/sizes/size_classes.hpp"

#include <algorithm>

namespace abut::engine {

SizeClasses::SizeClasses(const RadiusHistogram& histogram, const SizeDistribution& sizes) {
  const std::size_t first = RadiusHistogram::class_of(sizes.smallest_radius);
  const std::size_t last = RadiusHistogram::class_of(sizes.largest_radius);
  const std::size_t width = (last - first) / most + 1;
  for (std::size_t k = first; k <= last; k += width) {
    double count = 0.0;
    for (std::size_t j = k; j < k + width && j <= last; ++j) count += histogram.count(j);
    if (count == 0.0) continue;
    const double upper_end = RadiusHistogram::upper_end(std::min(k + width - 1, last));
    classes_[size_++] = {count, std::min(upper_end, sizes.largest_radius) / sizes.reach(),
                         upper_end};
  }
}

}  // namespace abut::engine
