// The passes of periodic domains in vectors against plain C++.

#include "kernels/images/image_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// The longest step of any level.
constexpr std::size_t longest_step = 32;

struct Kept {
  std::vector<ContactPair> pairs;
  std::vector<std::uint32_t> with_ghost;  ///< places in `pairs`

  friend bool operator==(const Kept&, const Kept&) = default;
};

/// The same in plain C++, from pair k on.
void keep_rest(const std::vector<ContactPair>& pairs, std::size_t k, std::uint32_t locals,
               Kept& kept) {
  for (; k < pairs.size(); ++k) {
    if (pairs[k].first >= locals) continue;
    if (pairs[k].second >= locals) {
      kept.with_ghost.push_back(static_cast<std::uint32_t>(kept.pairs.size()));
    }
    kept.pairs.push_back(pairs[k]);
  }
}

/// What a level keeps of a block of pairs that lies `gap` pairs behind where they are moved.
Kept kept_by(Simd level, const std::vector<ContactPair>& pairs, std::uint32_t locals,
             std::size_t gap) {
  std::vector<ContactPair> moved(gap);
  moved.insert(moved.end(), pairs.begin(), pairs.end());
  kernels::BlockList list;
  const auto [treated, count] = kernels::image_kernels(level).keep_with_local(
      moved.data() + gap, pairs.size(), locals, moved.data(), list);
  EXPECT_LE(treated, pairs.size());
  if (level != Simd::scalar) {
    EXPECT_LT(pairs.size(), treated + longest_step) << name_of(level);
  }
  EXPECT_TRUE(std::equal(pairs.begin() + static_cast<std::ptrdiff_t>(treated), pairs.end(),
                         moved.begin() + static_cast<std::ptrdiff_t>(gap + treated)))
      << name_of(level) << " wrote over pairs that it did not treat";
  moved.resize(count);
  Kept kept{moved, {list.number, list.number + list.count}};
  keep_rest(pairs, treated, locals, kept);
  return kept;
}

/// Pairs of which one in so many has a ghost, and every other of those has two; some of them at the
/// limit, and numbers that would be negative if they had signs.
std::vector<ContactPair> some_pairs(Random& random, std::size_t count, std::uint32_t locals,
                                    std::uint64_t one_in) {
  std::vector<ContactPair> pairs(count);
  for (std::size_t k = 0; k < count; ++k) {
    const bool reaches = random.below(one_in) == 0;
    const auto second = reaches ? locals + random.below(std::uint64_t{0xFFFFFFFF} - locals + 1)
                                : random.below(locals);
    pairs[k].second = static_cast<std::uint32_t>(second);
    const bool two = reaches && random.below(2) == 0;
    const std::uint64_t first = two ? locals + random.below(second - locals + 1)
                                    : random.below(std::min<std::uint64_t>(locals, second + 1));
    pairs[k].first = static_cast<std::uint32_t>(first);
    if (reaches && k % 5 == 0) pairs[k] = {two ? locals : locals - 1, locals};
  }
  return pairs;
}

/// Every count about the steps of all levels, and a full block; few, many or all of the pairs with
/// ghosts; in place, and moved down by less and by more than a vector.
TEST(ImageKernels, KeepThePairsThatHaveALocalElement) {
  Random random(3);
  for (const std::uint32_t locals : {1U, 1000U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
    for (const std::uint64_t one_in : {1U, 2U, 60U}) {
      for (std::size_t count = 0; count <= kernels::BlockList::room;
           count += count < 140 ? 1 : 93) {
        const std::vector<ContactPair> pairs = some_pairs(random, count, locals, one_in);
        Kept expected;
        keep_rest(pairs, 0, locals, expected);
        for (const Simd level : testing::simd_levels_here()) {
          for (const std::size_t gap : {0U, 1U, 3U, 40U}) {
            ASSERT_EQ(kept_by(level, pairs, locals, gap), expected)
                << name_of(level) << ", " << count << " pairs, " << locals << " locals, gap "
                << gap;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
