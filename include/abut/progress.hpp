#pragma once

#include <abut/export.hpp>

#include <cstdint>
#include <functional>
#include <string_view>

namespace abut {

/// Where a long detection stands.
struct Progress {
  std::string_view phase;  ///< "gather", "search" or "order"
  std::uint64_t done = 0;  ///< elements treated in this phase
  std::uint64_t total = 0;
};

enum class ProgressAction { proceed, cancel };

/// Called now and then from the calling thread. `cancel` makes the detection throw
/// Error{cancelled}; nothing is returned. An exception thrown by the hook passes through.
using ProgressHook = std::function<ProgressAction(const Progress&)>;

}  // namespace abut
