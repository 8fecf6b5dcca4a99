#include "kernels/wide_vectors.hpp"

namespace abut::kernels {
namespace {

/// Tells whether the processor is of AMD's family 19h. Those of it that have vectors of 512 bits
/// are Zen 4.
bool is_of_family_of_zen_4() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_cpu_init();
  return __builtin_cpu_is("amdfam19h") != 0;
#else
  return false;
#endif
}

}  // namespace

WideVectors wide_vectors_here() noexcept {
  static const WideVectors here =
      is_of_family_of_zen_4() ? WideVectors::in_halves : WideVectors::whole;
  return here;
}

}  // namespace abut::kernels
