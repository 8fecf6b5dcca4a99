#pragma once

#include "scenes/scene.hpp"

#include <abut/progress.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace abut::testing {

/// Spheres at the same place, one scene for each count.
inline const scenes::Scene& crowd(std::size_t count) {
  static std::map<std::size_t, scenes::Scene> made;
  if (!made.contains(count)) made[count] = scenes::scene_named("coincident").make(count, 1);
  return made[count];
}

/// Questions by phase; says yes to all but one.
struct Hook {
  std::map<std::string, std::uint64_t> asked;
  std::uint64_t all = 0;
  std::uint64_t cancelled_at = 0;  ///< 0: never

  [[nodiscard]] ProgressHook hook() {
    return [this](const Progress& progress) {
      EXPECT_LE(progress.done, progress.total);
      ++asked[std::string(progress.phase)];
      ++all;
      EXPECT_TRUE(cancelled_at == 0 || all <= cancelled_at) << "asked again";
      return all == cancelled_at ? ProgressAction::cancel : ProgressAction::proceed;
    };
  }
};

}  // namespace abut::testing
