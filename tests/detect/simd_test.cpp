// A forced SIMD level is the one that runs; one that cannot run is an error naming those that can.

#include "support/error_expectations.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

/// Sets the variable of the environment for a scope.
class ForcedByEnvironment {
 public:
  explicit ForcedByEnvironment(const std::string& value) {
    if (const char* before = std::getenv(simd_variable)) {
      before_ = before;
      was_set_ = true;
    }
    ::setenv(simd_variable, value.c_str(), 1);
  }
  ~ForcedByEnvironment() {
    if (was_set_) {
      ::setenv(simd_variable, before_.c_str(), 1);
    } else {
      ::unsetenv(simd_variable);
    }
  }
  ForcedByEnvironment(const ForcedByEnvironment&) = delete;
  ForcedByEnvironment& operator=(const ForcedByEnvironment&) = delete;

 private:
  std::string before_;
  bool was_set_ = false;
};

Statistics run(Simd asked, Algorithm algorithm = Algorithm::rows) {
  static const scenes::Scene scene = scenes::scene_named("dense").make(500, 1);
  return count_contact_pairs(view_of(scene), Domain::open(),
                             {.algorithm = algorithm, .simd = asked});
}

std::vector<Simd> lacking() {
  std::vector<Simd> levels;
  std::ranges::copy_if(simd_levels(), std::back_inserter(levels),
                       [](Simd level) { return !available(level); });
  return levels;
}

TEST(Simd, TheOptionForces) {
  std::cout << told_simd_levels() << '\n';
  for (const Simd level : simd_levels_here()) EXPECT_EQ(run(level).simd, level);
}

TEST(Simd, TheEnvironmentForces) {
  for (const Simd level : simd_levels_here()) {
    const ForcedByEnvironment forced{std::string(name_of(level))};
    EXPECT_EQ(run(Simd::automatic).simd, level);
  }
}

TEST(Simd, TheOptionGoesBeforeTheEnvironment) {
  const ForcedByEnvironment forced{"scalar"};
  for (const Simd level : simd_levels_here()) EXPECT_EQ(run(level).simd, level);
}

TEST(Simd, AutomaticTakesTheWidest) {
  for (const char* nothing : {"", "auto"}) {
    const ForcedByEnvironment forced{nothing};
    EXPECT_EQ(run(Simd::automatic).simd, simd_levels_here().back());
  }
}

/// A processor runs x86's vectors or ARM's, never both: there is always one to try.
TEST(Simd, WhatCannotRunIsAnErrorThatNamesWhatCan) {
  ASSERT_FALSE(lacking().empty());
  for (const Simd level : lacking()) {
    for (const Simd here : simd_levels_here()) {
      expect_error(ErrorCode::unavailable, {name_of(level), name_of(here)}, [&] { run(level); });
    }
    const ForcedByEnvironment forced{std::string(name_of(level))};
    expect_error(ErrorCode::unavailable, {name_of(level), simd_variable},
                 [&] { run(Simd::automatic); });
  }
}

TEST(Simd, ANameThatIsNoneIsAnErrorThatNamesAll) {
  for (const Simd level : simd_levels()) {
    EXPECT_EQ(simd_named(name_of(level)), level);
    expect_error(ErrorCode::wrong_usage, {"sse5", name_of(level)},
                 [] { static_cast<void>(simd_named("sse5")); });
  }
  EXPECT_EQ(simd_named("auto"), Simd::automatic);
  EXPECT_EQ(name_of(Simd::automatic), "auto");
  const ForcedByEnvironment forced{"sse5"};
  expect_error(ErrorCode::wrong_usage, {"sse5"}, [] { run(Simd::automatic); });
}

/// They have no kernels to force.
TEST(Simd, TheBooksAlgorithmsAreScalar) {
  const ForcedByEnvironment forced{std::string(name_of(simd_levels_here().back()))};
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::munjiza_nbs}) {
    EXPECT_EQ(run(Simd::automatic, algorithm).simd, Simd::scalar);
  }
}

}  // namespace
}  // namespace abut::testing
