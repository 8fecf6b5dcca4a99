#pragma once

#include <abut/export.hpp>

#include <cstdint>
#include <functional>
#include <string_view>

namespace abut {

/// State of a long detection.
struct Progress {
  std::string_view phase;   ///< "gather", "search" or "order"
  std::uint64_t done = 0;   ///< elements treated in this phase
  std::uint64_t total = 0;  ///< elements to treat in this phase
};

/// Answer of a progress hook.
enum class ProgressAction {
  proceed,  ///< go on
  cancel,   ///< stop: the detection throws Error{cancelled}
};

/// Function that is called now and then from the calling thread. If it returns `cancel`, the
/// detection throws Error{cancelled} and returns nothing. An exception that it throws passes
/// through.
using ProgressHook = std::function<ProgressAction(const Progress&)>;

}  // namespace abut
