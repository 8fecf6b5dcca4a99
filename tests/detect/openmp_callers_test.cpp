// Callers that run parallel regions of OpenMP: the library does as OpenMP would.

#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <array>
#include <atomic>

#include <omp.h>

namespace abut::testing {
namespace {

const scenes::Scene& scene() {
  static const scenes::Scene made = scenes::scene_named("gas").make(60000, 1);
  return made;
}

Statistics found_with(int threads) {
  return count_contact_pairs(view_of(scene()), Domain::open(), {.threads = threads});
}

class OpenMpCallers : public ::testing::Test {
 protected:
  OpenMpCallers() : threads_(omp_get_max_threads()), levels_(omp_get_max_active_levels()) {}
  ~OpenMpCallers() override {
    omp_set_num_threads(threads_);
    omp_set_max_active_levels(levels_);
  }

 private:
  int threads_;
  int levels_;
};

TEST_F(OpenMpCallers, SetTheDefault) {
  for (const int threads : {1, 3, 5}) {
    omp_set_num_threads(threads);
    EXPECT_EQ(found_with(0).threads, threads);
  }
  omp_set_num_threads(100000);
  EXPECT_EQ(found_with(0).threads, static_cast<int>(scene().size() / 8192));
}

/// Several of the caller's threads at once, each with the right answer and no threads of its own,
/// as OpenMP has it; with nested regions allowed, as many as each asks for.
TEST_F(OpenMpCallers, DetectInRegionsOfTheirOwn) {
  const PairCount expected = found_with(1).contact_pairs;
  for (const int levels : {1, 2}) {
    omp_set_max_active_levels(levels);
    std::array<Statistics, 3> found{};
    std::atomic<int> callers = 0;
#pragma omp parallel num_threads(3)
    {
      ++callers;
      found.at(static_cast<std::size_t>(omp_get_thread_num())) = found_with(4);
    }
    for (int k = 0; k < callers; ++k) {
      const Statistics& one = found.at(static_cast<std::size_t>(k));
      EXPECT_EQ(one.contact_pairs, expected);
      EXPECT_EQ(one.threads, levels == 1 && callers > 1 ? 1 : 4);
    }
  }
}

/// A region of one thread is none.
TEST_F(OpenMpCallers, MayStandInARegionOfOneThread) {
  omp_set_max_active_levels(1);
  int threads = 0;
#pragma omp parallel num_threads(1)
  threads = found_with(4).threads;
  EXPECT_EQ(threads, 4);
}

}  // namespace
}  // namespace abut::testing
