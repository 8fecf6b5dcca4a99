#pragma once

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

/// Rounding modes and flushing of denormals as callers may have set them. What includes this is
/// compiled with -frounding-math, so that no arithmetic is moved across a change of the mode.
namespace abut::testing {

/// A rounding mode, and denormals flushed or not.
struct CallerMode {
  const char* name;
  int rounding;
  bool flush;
};

inline constexpr CallerMode caller_modes[] = {
    {"to_nearest", FE_TONEAREST, false},   {"upward", FE_UPWARD, false},
    {"downward", FE_DOWNWARD, false},      {"toward_zero", FE_TOWARDZERO, false},
    {"flush_to_zero", FE_TONEAREST, true}, {"upward_and_flush", FE_UPWARD, true}};

#if defined(__x86_64__)
inline constexpr unsigned flush_bits = 0x8040;  // flush-to-zero, denormals-are-zero
inline void set_flush(bool on) {
  _mm_setcsr((_mm_getcsr() & ~flush_bits) | (on ? flush_bits : 0));
}
#elif defined(__aarch64__)
inline constexpr unsigned long flush_bit = 1UL << 24;
inline unsigned long control() {
  unsigned long value;
  __asm__ volatile("mrs %0, fpcr" : "=r"(value));
  return value;
}
inline void set_flush(bool on) {
  const unsigned long value = (control() & ~flush_bit) | (on ? flush_bit : 0);
  __asm__ volatile("msr fpcr, %0" : : "r"(value));
}
#else
inline void set_flush(bool) {}
#endif

inline constexpr bool can_flush =
#if defined(__x86_64__) || defined(__aarch64__)
    true;
#else
    false;
#endif

/// Sets a mode for a scope.
class Caller {
 public:
  explicit Caller(const CallerMode& mode) {
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

/// What the arithmetic of this thread shows of its mode. std::fegetround would not do: on x86-64 it
/// asks the x87 unit, which nothing in the library touches.
struct SeenMode {
  int rounding = FE_TONEAREST;
  bool flush = false;
};

/// The mode of this thread now.
[[nodiscard]] inline SeenMode seen_mode() {
  const volatile double one = 1.0, grain = 0x1p-60, smallest_normal = 0x1p-1022, half = 0.5;
  const volatile double up = one + grain, down = -one - grain, inward = one - grain;
  SeenMode seen;
  if (up > 1.0) {
    seen.rounding = FE_UPWARD;
  } else if (down < -1.0) {
    seen.rounding = FE_DOWNWARD;
  } else if (inward < 1.0) {
    seen.rounding = FE_TOWARDZERO;
  }
  const volatile double denormal = smallest_normal * half;
  const volatile double again = denormal * 2.0;
  seen.flush = again != smallest_normal;
  return seen;
}

}  // namespace abut::testing
