// The passes of periodic domains in vectors against plain C++.

#include "kernels/image_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace abut::kernels {
namespace {

using scenes::Random;

/// The longest step of any level.
constexpr std::size_t longest_step = 32;

/// Every count about the steps of all levels, and every place of the one number that is not below;
/// also numbers that would be negative if they had signs.
TEST(ImageKernels, CountUpToTheFirstNumberThatIsNotBelow) {
  Random random(3);
  for (const Simd level : testing::simd_levels_here()) {
    const auto count_below = image_kernels(level).count_below;
    const std::size_t step = level == Simd::scalar ? std::size_t{1} << 20 : longest_step;
    for (const std::uint32_t limit : {1U, 1000U, 0x80000000U, 0xFFFFFFFFU}) {
      for (std::size_t count = 0; count < 140; ++count) {
        std::vector<std::uint32_t> numbers(count);
        for (std::uint32_t& number : numbers) {
          number = static_cast<std::uint32_t>(random.below(limit));
        }
        for (std::size_t place = 0; place <= count; ++place) {
          std::vector<std::uint32_t> given = numbers;
          if (place < count) given[place] = limit;
          const std::size_t counted = count_below(given.data(), count, limit);
          ASSERT_LE(counted, place) << count << " numbers, limit " << limit;
          ASSERT_LT(place, counted + step) << count << " numbers, limit " << limit;
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::kernels
