// Candidates that a Detector with a skin keeps are decided exactly: in vectors of any width,
// whatever their magnitude and number, ties included.

#include "support/moving_system.hpp"

#include <abut/detector.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

/// More candidates of one element than a word has bits, and more elements than a unit of work.
TEST(Candidates, LargeAndLopsidedSystems) {
  for (const char* name : {"one_giant", "dense", "clusters", "gas_2d", "ordered"}) {
    const scenes::Scene scene = scenes::scene_named(name).make(20000, 1);
    for (const int threads : {1, 3}) {
      SCOPED_TRACE(std::string(name) + ", threads " + std::to_string(threads));
      const PairList fresh = find_contact_pairs(view_of(scene));
      Detector detector({.threads = threads});
      detector.set_skin(Skin::fixed(0.1));
      for (int call = 0; call < 3; ++call) {
        ASSERT_TRUE(
            std::ranges::equal(fresh.pairs(), detector.find_contact_pairs(view_of(scene)).pairs()));
      }
      EXPECT_EQ(detector.skin_statistics().reuses, 2U);
      EXPECT_GT(detector.skin_statistics().candidates, fresh.size());
    }
  }
}

/// In vectors and in plain C++ the same candidates are left to the exact decision.
TEST(Candidates, EveryLevelOfVectorsSaysTheSame) {
  for (const Space space : {Space::open, Space::triclinic}) {
    for (const int dimensions : {2, 3}) {
      MovingSystem system(dimensions, 1000, {.space = space, .wrapped = true}, 23);
      const Domain domain = system.domain();
      std::uint64_t exact_decisions = 0;
      for (const Simd level : simd_levels()) {
        if (!available(level)) continue;
        SCOPED_TRACE(std::string(name_of(level)));
        Detector detector({.shifts = Shifts::stored, .simd = level});
        detector.set_skin(Skin::fixed(0.2));
        const PairList fresh = find_contact_pairs(system.elements(), domain, detector.options());
        detector.find_contact_pairs(system.elements(), domain);
        const PairList& kept = detector.find_contact_pairs(system.elements(), domain);
        ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
        ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
        EXPECT_EQ(detector.skin_statistics().reuses, 1U);
        if (level == Simd::scalar) exact_decisions = kept.statistics().exact_decisions;
        EXPECT_EQ(kept.statistics().exact_decisions, exact_decisions);
      }
    }
  }
}

/// Elements far apart for their size, and of any size: to whole numbers of 32 bits most pairs are
/// alike, or nothing is.
TEST(Candidates, LengthsOfAnyMagnitude) {
  for (const char* name : {"two_far_clusters", "graded_1000", "sparse", "at_reach", "gas_2d"}) {
    for (const double scale : {1.0, 1e-300, 1e-30, 1e30, 1e250}) {
      SCOPED_TRACE(std::string(name) + " times " + std::to_string(scale));
      scenes::Scene scene = scenes::scene_named(name).make(600, 1);
      for (auto* numbers : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
        for (double& number : *numbers) number *= scale;
      }
      const PairList fresh = find_contact_pairs(view_of(scene));
      Detector detector;
      detector.set_skin(Skin::fixed(0.05 * scene.radius[0]));
      for (int call = 0; call < 2; ++call) {
        ASSERT_TRUE(
            std::ranges::equal(fresh.pairs(), detector.find_contact_pairs(view_of(scene)).pairs()));
      }
      // Displacements so small that their squares may be lost are not trusted.
      EXPECT_EQ(detector.skin_statistics().reuses, scale < 1e-100 ? 0U : 1U);
    }
  }
}

/// Every pair of a lattice touches exactly: what doubles cannot decide is decided on the caller's
/// numbers, in the call that detects and in those that reuse.
TEST(Candidates, TiesAreDecidedOnTheNumbersGiven) {
  scenes::Scene scene;
  scene.dimensions = 3;
  for (int k = 0; k < 512; ++k) {
    scene.x.push_back(k % 8);
    scene.y.push_back(k / 8 % 8);
    scene.z.push_back(k / 64);
    scene.radius.push_back(0.5);
  }
  for (const Domain& domain : {Domain::open(), Domain::periodic({8.0, 8.0, 8.0})}) {
    Detector detector({.shifts = Shifts::stored});
    detector.set_skin(Skin::fixed(0.3));
    const PairList fresh = find_contact_pairs(view_of(scene), domain, detector.options());
    for (int call = 0; call < 2; ++call) {
      const PairList& kept = detector.find_contact_pairs(view_of(scene), domain);
      EXPECT_GE(kept.statistics().exact_decisions, fresh.size());
      ASSERT_TRUE(std::ranges::equal(fresh.pairs(), kept.pairs()));
      ASSERT_TRUE(std::ranges::equal(fresh.shifts(), kept.shifts()));
    }
    EXPECT_EQ(detector.skin_statistics().reuses, 1U);
  }
}

}  // namespace
}  // namespace abut::testing
