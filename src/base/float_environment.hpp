#pragma once

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace abut::base {

/// Sets the default floating-point environment (round to nearest, no flush to zero) and restores
/// the caller's: the answer must not depend on it. Every entry point and every worker holds one.
class FloatEnvironment {
 public:
  FloatEnvironment() noexcept {
    std::fegetenv(&caller_);
    std::fesetenv(FE_DFL_ENV);
#if defined(__x86_64__)
    // All exceptions masked, to nearest, flush-to-zero and denormals-are-zero off: glibc leaves
    // the last two alone.
    _mm_setcsr(0x1F80);
#elif defined(__aarch64__)
    const unsigned long default_control = 0;
    __asm__ volatile("msr fpcr, %0" : : "r"(default_control));
#endif
  }
  ~FloatEnvironment() {
    std::fesetenv(&caller_);
  }

  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
  std::fenv_t caller_;
};

}  // namespace abut::base
