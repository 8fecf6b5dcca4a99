// A periodic system that moves for 2,000 steps, with elements that come and go: each step of a
// Detector with a skin has the bytes of a fresh detection, and the history loses no contact.

#include "support/moving_system.hpp"

#include <abut/contact_history.hpp>
#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

struct Case {
  const char* name;
  Space space;
  int dimensions;
  Skin skin;
};

/// How long a contact has lasted.
using Ages = ContactHistory<std::uint32_t>;

class Soak : public ::testing::TestWithParam<Case> {};

TEST_P(Soak, TwoThousandStepsAreThoseOfFreshDetections) {
  constexpr std::uint64_t seed = 2004;
  constexpr int steps = 2000;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Case& now = GetParam();
  MovingSystem system(now.dimensions, 800,
                      {.space = now.space, .speed = 0.02, .growth = 1e-6, .wrapped = true}, seed);
  scenes::Random random(seed);
  std::vector<std::uint64_t> ids;
  for (std::uint64_t k = 0; k < system.scene.size(); ++k) ids.push_back(k);
  std::uint64_t next_id = ids.size();

  Detector detector({.shifts = Shifts::stored});
  detector.set_skin(now.skin);
  Ages history;
  PairCount total = 0, kept = 0;
  for (int step = 0; step < steps; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    const Domain domain = system.domain();
    const PairList fresh = find_contact_pairs(system.elements(), domain, detector.options());
    const PairList& pairs = detector.find_contact_pairs(system.elements(), domain);
    ASSERT_TRUE(std::ranges::equal(fresh.pairs(), pairs.pairs()));
    ASSERT_TRUE(std::ranges::equal(fresh.shifts(), pairs.shifts()));
    history.update(pairs, system.elements(), domain, ids);
    for (std::uint32_t& age : history.values()) ++age;
    total += pairs.size();
    kept += history.kept();
    system.step();
    if (step % 20 == 7) {
      system.add();
      ids.push_back(next_id++);
    }
    if (step % 25 == 9) {
      const std::size_t gone = random.below(ids.size());
      system.remove(gone);
      ids[gone] = ids.back();
      ids.pop_back();
    }
  }
  const SkinStatistics& statistics = detector.skin_statistics();
  EXPECT_EQ(statistics.detections + statistics.reuses, static_cast<std::uint64_t>(steps));
  EXPECT_GE(statistics.reuses, statistics.detections);
  EXPECT_GT(total, 100'000U);
  // Contacts last for tens of steps here: most are kept from one to the next.
  EXPECT_GT(kept, total / 10 * 8);
  EXPECT_GT(*std::ranges::max_element(history.values()), 20U);
}

INSTANTIATE_TEST_SUITE_P(Systems, Soak,
                         ::testing::Values(Case{"box", Space::periodic, 3, Skin::fixed(0.25)},
                                           Case{"automatic", Space::periodic, 3, Skin::automatic()},
                                           Case{"sheared", Space::lees_edwards, 3,
                                                Skin::fixed(0.3)},
                                           Case{"swelling", Space::swelling, 2, Skin::fixed(0.3)}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace abut::testing
