// The answer does not depend on the caller's rounding mode or flush-to-zero setting, and both are
// as before when the call returns or throws.

#include "support/algorithm_list.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <cfenv>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace abut::testing {
namespace {

/// What the caller may have set: a rounding mode, and denormals flushed or not.
struct Mode {
  const char* name;
  int rounding;
  bool flush;
};

#if defined(__x86_64__)
constexpr unsigned flush_bits = 0x8040;  // flush-to-zero, denormals-are-zero
bool flushes() {
  return (_mm_getcsr() & flush_bits) == flush_bits;
}
void set_flush(bool on) {
  _mm_setcsr((_mm_getcsr() & ~flush_bits) | (on ? flush_bits : 0));
}
#elif defined(__aarch64__)
constexpr unsigned long flush_bit = 1UL << 24;
unsigned long control() {
  unsigned long value;
  __asm__ volatile("mrs %0, fpcr" : "=r"(value));
  return value;
}
bool flushes() {
  return (control() & flush_bit) != 0;
}
void set_flush(bool on) {
  const unsigned long value = (control() & ~flush_bit) | (on ? flush_bit : 0);
  __asm__ volatile("msr fpcr, %0" : : "r"(value));
}
#else
bool flushes() {
  return false;
}
void set_flush(bool) {}
#endif

constexpr bool can_flush =
#if defined(__x86_64__) || defined(__aarch64__)
    true;
#else
    false;
#endif

/// Sets a mode for a scope.
class Caller {
 public:
  explicit Caller(const Mode& mode) {
    std::fegetenv(&before_);
    std::fesetround(mode.rounding);
    set_flush(mode.flush);
  }
  ~Caller() {
    set_flush(false);
    std::fesetenv(&before_);
  }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

 private:
  std::fenv_t before_;
};

void expect_mode(const Mode& mode, int rounding, bool flush) {
  EXPECT_EQ(rounding, mode.rounding);
  if (can_flush) {
    EXPECT_EQ(flush, mode.flush);
  }
}

scenes::Scene denormal_scene() {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<HandMade> elements;
  for (int k = 0; k < 100; ++k) {
    elements.push_back({k * (k % 3 == 0 ? 3 : 2) * tiny, 0, 0, (k % 4) * tiny});
  }
  return scene_of(3, elements);
}

class FloatEnvironment : public ::testing::TestWithParam<Mode> {
 protected:
  static void check(const scenes::Scene& scene) {
    const PairVector expected = oracle_pairs(scene);
    ASSERT_FALSE(expected.empty());
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      const Options options{.algorithm = algorithm};
      PairList found;
      int rounding = 0;
      bool flush = false;
      {
        const Caller caller(GetParam());
        found = find_contact_pairs(view_of(scene), Domain::open(), options);
        rounding = std::fegetround();
        flush = flushes();
      }
      EXPECT_TRUE(same_canonical_pairs(expected, found.pairs())) << name_of(algorithm);
      expect_mode(GetParam(), rounding, flush);
    }
    const Caller caller(GetParam());
    EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 2, 3, 7, 16}));
  }
};

TEST_P(FloatEnvironment, PairsAreTheSame) {
  for (const char* name :
       {"at_reach_2d", "at_reach", "near_faces", "touching_fcc", "log_uniform"}) {
    SCOPED_TRACE(name);
    check(scenes::scene_named(name).make(500, 17));
  }
}

TEST_P(FloatEnvironment, DenormalsAreSeen) {
  check(denormal_scene());
}

TEST_P(FloatEnvironment, GapsAreTheSame) {
  const scenes::Scene scene = scenes::scene_named("at_reach").make(200, 17);
  for (ElementIndex k = 0; k + 1 < scene.size(); ++k) {
    const double expected = gap(view_of(scene), {k, k + 1});
    double found = 0.0;
    {
      const Caller caller(GetParam());
      found = gap(view_of(scene), {k, k + 1});
    }
    EXPECT_EQ(found, expected) << "element " << k;
  }
}

TEST_P(FloatEnvironment, ModeIsRestoredWhenAVisitorThrows) {
  const scenes::Scene scene = scenes::scene_named("dense").make(200, 17);
  int rounding = 0;
  bool flush = false;
  {
    const Caller caller(GetParam());
    try {
      for_each_contact_pair(view_of(scene), Domain::open(), {},
                            [](ContactPair) { throw std::runtime_error("stop"); });
    } catch (const std::runtime_error&) {
      rounding = std::fegetround();
      flush = flushes();
    }
  }
  expect_mode(GetParam(), rounding, flush);
}

/// -denormal is a negative margin also where the caller's denormals count as zero.
TEST_P(FloatEnvironment, ValidationIsTheSame) {
  const scenes::Scene scene = scenes::scene_named("dense").make(20, 17);
  const Options options{.margin = -std::numeric_limits<double>::denorm_min()};
  bool refused = false;
  {
    const Caller caller(GetParam());
    try {
      static_cast<void>(count_contact_pairs(view_of(scene), Domain::open(), options));
    } catch (const Error&) {
      refused = true;
    }
  }
  EXPECT_TRUE(refused);
}

INSTANTIATE_TEST_SUITE_P(Modes, FloatEnvironment,
                         ::testing::Values(Mode{"to_nearest", FE_TONEAREST, false},
                                           Mode{"upward", FE_UPWARD, false},
                                           Mode{"downward", FE_DOWNWARD, false},
                                           Mode{"toward_zero", FE_TOWARDZERO, false},
                                           Mode{"flush_to_zero", FE_TONEAREST, true},
                                           Mode{"upward_and_flush", FE_UPWARD, true}),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
