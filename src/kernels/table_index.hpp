#pragma once

#include <hwy/targets.h>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Index of a target, as Highway numbers it, in the tables of HWY_EXPORT. Where a single target is
/// compiled, as NEON on ARM, these hold nothing but its function.
[[nodiscard]] inline std::size_t table_index(std::int64_t target) {
  if constexpr ((HWY_TARGETS & (HWY_TARGETS - 1)) == 0) {
    static_cast<void>(target);
    return 0;
  } else {
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    return chosen.GetIndex();
  }
}

}  // namespace abut::kernels
