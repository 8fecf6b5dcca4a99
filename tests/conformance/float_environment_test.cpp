// The answer does not depend on the caller's rounding mode or flush-to-zero setting, and both are
// as before when the call returns or throws.

#include "support/algorithm_list.hpp"
#include "support/caller_mode.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

void expect_mode(const CallerMode& mode, const SeenMode& seen) {
  EXPECT_EQ(seen.rounding, mode.rounding);
  if (can_flush) {
    EXPECT_EQ(seen.flush, mode.flush);
  }
}

scenes::Scene denormal_scene() {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<HandMade> elements;
  for (int k = 0; k < 100; ++k) {
    elements.push_back({k * (k % 3 == 0 ? 3 : 2) * tiny, 0, 0, (k % 4) * tiny});
  }
  return scene_of(3, elements);
}

class FloatEnvironment : public ::testing::TestWithParam<CallerMode> {
 protected:
  static void check(const scenes::Scene& scene) {
    const PairVector expected = oracle_pairs(scene);
    ASSERT_FALSE(expected.empty());
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      const Options options{.algorithm = algorithm};
      PairList found;
      SeenMode seen;
      {
        const Caller caller(GetParam());
        found = find_contact_pairs(view_of(scene), Domain::open(), options);
        seen = seen_mode();
      }
      EXPECT_TRUE(same_canonical_pairs(expected, found.pairs())) << name_of(algorithm);
      expect_mode(GetParam(), seen);
    }
    const Caller caller(GetParam());
    EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 2, 3, 7, 16}));
  }
};

TEST_P(FloatEnvironment, PairsAreTheSame) {
  for (const char* name :
       {"at_reach_2d", "at_reach", "near_faces", "touching_fcc", "log_uniform"}) {
    SCOPED_TRACE(name);
    check(scenes::scene_named(name).make(500, 17));
  }
}

TEST_P(FloatEnvironment, DenormalsAreSeen) {
  check(denormal_scene());
}

TEST_P(FloatEnvironment, GapsAreTheSame) {
  const scenes::Scene scene = scenes::scene_named("at_reach").make(200, 17);
  for (ElementIndex k = 0; k + 1 < scene.size(); ++k) {
    const double expected = gap(view_of(scene), {k, k + 1});
    double found = 0.0;
    {
      const Caller caller(GetParam());
      found = gap(view_of(scene), {k, k + 1});
    }
    EXPECT_EQ(found, expected) << "element " << k;
  }
}

TEST_P(FloatEnvironment, ModeIsRestoredWhenAVisitorThrows) {
  const scenes::Scene scene = scenes::scene_named("dense").make(200, 17);
  SeenMode seen;
  {
    const Caller caller(GetParam());
    try {
      for_each_contact_pair(view_of(scene), Domain::open(), {},
                            [](ContactPair) { throw std::runtime_error("stop"); });
    } catch (const std::runtime_error&) {
      seen = seen_mode();
    }
  }
  expect_mode(GetParam(), seen);
}

/// -denormal is a negative margin also where the caller's denormals count as zero.
TEST_P(FloatEnvironment, ValidationIsTheSame) {
  const scenes::Scene scene = scenes::scene_named("dense").make(20, 17);
  const Options options{.margin = -std::numeric_limits<double>::denorm_min()};
  bool refused = false;
  {
    const Caller caller(GetParam());
    try {
      static_cast<void>(count_contact_pairs(view_of(scene), Domain::open(), options));
    } catch (const Error&) {
      refused = true;
    }
  }
  EXPECT_TRUE(refused);
}

INSTANTIATE_TEST_SUITE_P(Modes, FloatEnvironment, ::testing::ValuesIn(caller_modes),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace abut::testing
