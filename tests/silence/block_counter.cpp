#include "silence/block_counter.hpp"

namespace {

std::uint64_t blocks = 0;

}  // namespace

/// Called by the compiler's own instructions at the beginning of each basic block. One thread only.
extern "C" __attribute__((no_sanitize_coverage)) void __sanitizer_cov_trace_pc() {
  ++blocks;
}

__attribute__((no_sanitize_coverage)) std::uint64_t abut::testing::entered_blocks() noexcept {
  return blocks;
}
