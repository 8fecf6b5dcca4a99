// More pairs than 32 bits count. Two sets would take four times as long, and count in the same
// place.

#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

/// Of coincident elements each touches each.
scenes::Scene crowd_of(std::uint64_t count) {
  return scenes::scene_named("coincident").make(count, 1);
}

constexpr std::uint64_t elements = 92700;
constexpr std::uint64_t pairs = elements * (elements - 1) / 2;
static_assert(pairs > std::numeric_limits<std::uint32_t>::max());

TEST(ManyPairs, AreCounted) {
  const Statistics counted = count_contact_pairs(view_of(crowd_of(elements)), Domain::open(), {});
  EXPECT_EQ(counted.contact_pairs, pairs);
  EXPECT_GE(counted.candidate_tests, pairs);
}

TEST(ManyPairs, AreCountedInPeriodicDomains) {
  const Domain cell = Domain::periodic({1e6, 1e6, 1e6});
  const Statistics counted = count_contact_pairs(view_of(crowd_of(elements)), cell, {});
  EXPECT_EQ(counted.contact_pairs, pairs);
}

}  // namespace
}  // namespace abut::testing
