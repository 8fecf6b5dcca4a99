#include "base/float_environment.hpp"

#include <gtest/gtest.h>

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace abut::testing {
namespace {

/// 1 + 2^-60 and 1 - 2^-60: 1 to nearest, not all of them in any other direction. The x87 unit,
/// which std::fegetround asks on x86-64, is left alone.
bool rounds_to_nearest() {
  const volatile double one = 1.0;
  const volatile double grain = 0x1p-60;
  const volatile double up = one + grain;
  const volatile double down = -one - grain;
  const volatile double inward = one - grain;
  return up == 1.0 && down == -1.0 && inward == 1.0;
}

bool keeps_denormals() {
  const volatile double smallest_normal = 0x1p-1022;
  const volatile double half = 0.5;
  const volatile double denormal = smallest_normal * half;
  const volatile double again = denormal * 2.0;
  return again == 0x1p-1022;
}

TEST(FloatEnvironment, RoundsToNearestAndRestoresTheCallersMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    ASSERT_EQ(rounds_to_nearest(), mode == FE_TONEAREST) << "the test itself must notice";
    bool inside = false;
    {
      const base::FloatEnvironment environment;
      inside = rounds_to_nearest();
    }
    const int afterwards = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(inside) << mode;
    EXPECT_EQ(afterwards, mode);
  }
}

#if defined(__x86_64__)
TEST(FloatEnvironment, KeepsDenormalsAndRestoresTheCallersFlush) {
  constexpr unsigned flush_and_zero = 0x8040;
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flush_and_zero);
  const bool noticed = !keeps_denormals();
  bool inside = false;
  {
    const base::FloatEnvironment environment;
    inside = keeps_denormals();
  }
  const unsigned afterwards = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_TRUE(noticed) << "the test itself must notice";
  EXPECT_TRUE(inside);
  EXPECT_EQ(afterwards & flush_and_zero, flush_and_zero);
}
#elif defined(__aarch64__)
TEST(FloatEnvironment, KeepsDenormalsAndRestoresTheCallersFlush) {
  constexpr unsigned long flush = 1ul << 24;
  unsigned long before = 0;
  __asm__ volatile("mrs %0, fpcr" : "=r"(before));
  __asm__ volatile("msr fpcr, %0" : : "r"(before | flush));
  const bool noticed = !keeps_denormals();
  bool inside = false;
  {
    const base::FloatEnvironment environment;
    inside = keeps_denormals();
  }
  unsigned long afterwards = 0;
  __asm__ volatile("mrs %0, fpcr" : "=r"(afterwards));
  __asm__ volatile("msr fpcr, %0" : : "r"(before));
  EXPECT_TRUE(noticed) << "the test itself must notice";
  EXPECT_TRUE(inside);
  EXPECT_EQ(afterwards & flush, flush);
}
#endif

TEST(FloatEnvironment, WithoutOneDenormalsAreKeptToo) {
  EXPECT_TRUE(keeps_denormals());
}

}  // namespace
}  // namespace abut::testing
