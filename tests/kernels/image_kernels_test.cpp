// The passes of periodic domains in vectors against plain C++.

#include "kernels/image_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// The longest step of any level.
constexpr std::size_t longest_step = 32;

/// What a level lists of a block of pairs, its rest in plain C++.
std::vector<std::uint32_t> listed(Simd level, const std::vector<ContactPair>& pairs,
                                  std::uint32_t limit) {
  kernels::BlockList list;
  std::size_t k = kernels::image_kernels(level).list_from(pairs.data(), pairs.size(), limit, list);
  EXPECT_LE(k, pairs.size());
  if (level != Simd::scalar) {
    EXPECT_LT(pairs.size(), k + longest_step) << name_of(level);
  }
  for (; k < pairs.size(); ++k) {
    if (pairs[k].second >= limit) list.push(k);
  }
  return {list.number, list.number + list.count};
}

/// Every count about the steps of all levels, and a full block; few, many or all of the pairs; some
/// of them at the limit, and numbers that would be negative if they had signs.
TEST(ImageKernels, ListThePairsWhoseSecondNumberReachesTheLimit) {
  Random random(3);
  for (const std::uint32_t limit : {1U, 1000U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
    for (const std::uint64_t one_in : {1U, 2U, 60U}) {
      for (std::size_t count = 0; count <= kernels::BlockList::room;
           count += count < 140 ? 1 : 93) {
        std::vector<ContactPair> pairs(count);
        std::vector<std::uint32_t> expected;
        for (std::size_t k = 0; k < count; ++k) {
          const bool reaches = random.below(one_in) == 0;
          const auto second = reaches ? limit + random.below(std::uint64_t{0xFFFFFFFF} - limit + 1)
                                      : random.below(limit);
          pairs[k].second = static_cast<std::uint32_t>(second);
          pairs[k].first = static_cast<std::uint32_t>(random.below(second + 1));
          if (reaches && k % 2 == 0) pairs[k] = {0, limit};
          if (reaches) expected.push_back(static_cast<std::uint32_t>(k));
        }
        for (const Simd level : testing::simd_levels_here()) {
          ASSERT_EQ(listed(level, pairs, limit), expected)
              << name_of(level) << ", " << count << " pairs, limit " << limit;
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
