#pragma once

#include "base/refuse_fast_math.hpp"

#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace abut::base {

/// Sets the default floating-point environment (round to nearest, no flush to zero) and restores
/// the caller's, exception flags included: the answer must not depend on it. Every entry point and
/// every worker holds one. On x86-64 that is MXCSR alone, which takes a few nanoseconds: nothing in
/// the library computes with the x87 unit, whose state takes a hundred times as long to save.
class FloatEnvironment {
 public:
  FloatEnvironment() noexcept {
#if defined(__x86_64__)
    caller_ = _mm_getcsr();
    // All exceptions masked, to nearest, flush-to-zero and denormals-are-zero off.
    _mm_setcsr(0x1F80);
#elif defined(__aarch64__)
    __asm__ volatile("mrs %0, fpcr" : "=r"(caller_));
    __asm__ volatile("mrs %0, fpsr" : "=r"(caller_flags_));
    __asm__ volatile("msr fpcr, %0" : : "r"(std::uint64_t{0}));
#else
    std::fegetenv(&caller_);
    std::fesetenv(FE_DFL_ENV);
#endif
  }
  ~FloatEnvironment() {
#if defined(__x86_64__)
    _mm_setcsr(caller_);
#elif defined(__aarch64__)
    __asm__ volatile("msr fpcr, %0" : : "r"(caller_));
    __asm__ volatile("msr fpsr, %0" : : "r"(caller_flags_));
#else
    std::fesetenv(&caller_);
#endif
  }

  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
#if defined(__x86_64__)
  unsigned caller_;
#elif defined(__aarch64__)
  std::uint64_t caller_;
  std::uint64_t caller_flags_;
#else
  std::fenv_t caller_;
#endif
};

}  // namespace abut::base
