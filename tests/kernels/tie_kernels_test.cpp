// Decisions in vectors against the one function that decides the contract.

#include "kernels/tie_kernels.hpp"

#include "exact/exact_stages.hpp"
#include "exact/hard_pairs.hpp"
#include "exact/sphere_predicate.hpp"
#include "support/dimensions.hpp"
#include "support/rows_variants.hpp"
#include "support/sphere_layouts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

namespace abut::testing {
namespace {

using testing::HardPair;
using testing::Random;

struct Count {
  std::uint64_t pairs = 0;
  std::uint64_t within = 0;
  std::uint64_t open = 0;
};

/// Each sphere with each, in an order that puts different decisions beside each other.
constexpr std::array<std::array<std::uint32_t, 2>, 4> encounters{{{0, 1}, {0, 0}, {1, 0}, {1, 1}}};

/// A vector at least, and some that are left over.
constexpr std::size_t listed = 11;

template <int Dim>
class OnePair {
 public:
  explicit OnePair(const HardPair<Dim>& pair) : pair_(pair), spheres_{pair.a, pair.b} {
    hits_->undecided_count = listed;
    hits_->found = 2 * listed;
    for (std::uint32_t k = 0; k < listed; ++k) {
      hits_->undecided[k] = 2 * k + 1;
      hits_->element[2 * k] = hits_->partner[2 * k] = 1000000;
      hits_->element[2 * k + 1] = encounters[k % 4][0];
      hits_->partner[2 * k + 1] = encounters[k % 4][1];
    }
  }

  void decide(Simd level, Layout layout, Count& count) {
    const LaidOut<Dim> laid_out(spheres_, layout);
    std::uint64_t exact_decisions = 7;
    const std::size_t treated = kernels::tie_kernels(level).decide(
        laid_out.columns(), Dim, pair_.margin, *hits_, exact_decisions);
    ASSERT_LE(treated, listed);
    ASSERT_GE(treated, level == Simd::scalar ? 0 : listed - 3);
    std::uint64_t expected_decisions = 7;
    for (std::size_t k = 0; k < treated; ++k) {
      const exact::Sphere<Dim>& first = spheres_[encounters[k % 4][0]];
      const exact::Sphere<Dim>& second = spheres_[encounters[k % 4][1]];
      const bool within = exact::within_reach(first, second, pair_.margin, expected_decisions);
      ++count.pairs;
      if (hits_->verdict[k] == kernels::Verdict::open) {
        ++count.open;
        ASSERT_FALSE(exact::decide_if_nothing_rounded(first, second, pair_.margin)) << pair_;
        ASSERT_FALSE(exact::decide_in_double_double(first, second, pair_.margin)) << pair_;
      } else {
        ASSERT_EQ(hits_->verdict[k] == kernels::Verdict::within_reach, within)
            << k << ": " << pair_;
        count.within += within ? 1 : 0;
      }
    }
    ASSERT_EQ(exact_decisions, expected_decisions) << pair_;
  }

 private:
  HardPair<Dim> pair_;
  std::array<exact::Sphere<Dim>, 2> spheres_;
  std::unique_ptr<kernels::HitBuffer> hits_ = std::make_unique<kernels::HitBuffer>();
};

template <class Dimension>
class TieKernelsTest : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;

  template <class Make>
  static Count decide(Simd level, std::uint64_t seed, int pairs, Make make) {
    SCOPED_TRACE(std::string(name_of(level)) + ", seed " + std::to_string(seed));
    Random random(seed);
    Count count;
    for (int k = 0; k < pairs && !::testing::Test::HasFatalFailure(); ++k) {
      const Layout layout = all_layouts[static_cast<std::size_t>(k) % all_layouts.size()];
      OnePair<dim>(make(random)).decide(level, layout, count);
    }
    return count;
  }
};

using testing::Dimensions;
TYPED_TEST_SUITE(TieKernelsTest, Dimensions);

TYPED_TEST(TieKernelsTest, DecideTies) {
  for (const Simd level : testing::simd_levels_here()) {
    const Count count = TestFixture::decide(level, 81, 4000, [](Random& random) {
      auto tie =
          testing::exact_tie<TypeParam::value>(random, 1 + static_cast<int>(random.below(8)));
      if (random.below(2) == 0) tie.a.radius = std::nextafter(tie.a.radius, 0.0);
      return tie;
    });
    EXPECT_EQ(count.open, 0u) << "short numbers";
    EXPECT_GE(count.within, count.pairs / 2) << "an element is within reach of itself";
    EXPECT_TRUE(count.within < count.pairs || level == Simd::scalar) << "radii an ulp too short";
  }
}

TYPED_TEST(TieKernelsTest, DecideWhatIsCloseToATie) {
  for (const Simd level : testing::simd_levels_here()) {
    const Count count = TestFixture::decide(level, 82, 4000, [](Random& random) {
      return testing::borderline_pair<TypeParam::value>(random, 3);
    });
    EXPECT_LE(count.open, count.pairs / 10);
  }
}

TYPED_TEST(TieKernelsTest, DecideAtEveryScaleOrLeaveOpen) {
  for (const Simd level : testing::simd_levels_here()) {
    int exponent = -1074;
    const Count count = TestFixture::decide(level, 83, 4000, [&](Random& random) {
      auto pair = testing::borderline_pair<TypeParam::value>(random, 3);
      testing::scale(pair, exponent);
      exponent = exponent > 1014 ? -1074 : exponent + 6;
      return pair;
    });
    EXPECT_GE(count.open, count.pairs / 10) << "beyond the range of doubled precision";
  }
}

TYPED_TEST(TieKernelsTest, DecideOrdinaryPairs) {
  for (const Simd level : testing::simd_levels_here()) {
    const Count count = TestFixture::decide(level, 84, 1000, [](Random& random) {
      return testing::ordinary_pair<TypeParam::value>(random);
    });
    EXPECT_EQ(count.open, 0u);
  }
}

TYPED_TEST(TieKernelsTest, DecideExtremeNumbersOrLeaveOpen) {
  for (const Simd level : testing::simd_levels_here()) {
    const Count count = TestFixture::decide(level, 85, 4000, [](Random& random) {
      return testing::extreme_pair<TypeParam::value>(random);
    });
    EXPECT_LT(count.open, count.pairs + (level == Simd::scalar ? 1 : 0));
  }
}

}  // namespace
}  // namespace abut::testing
