// Every allocation of a detection fails once, in turn: always an Error{limit_exceeded}, never a
// leak, and the next detection works.

#include "support/algorithm_list.hpp"
#include "support/allocation_faults.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/trace.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <new>
#include <string>
#include <string_view>

namespace abut::testing {
namespace {

enum class Outcome { done, error, bad_alloc };

Outcome outcome_of(const std::function<void()>& call, AllocationFault& fault) {
  try {
    call();
    fault.disarm();
    return Outcome::done;
  } catch (const Error& error) {
    fault.disarm();
    EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
    return Outcome::error;
  } catch (const std::bad_alloc&) {
    fault.disarm();
    return Outcome::bad_alloc;
  }
}

/// Number of allocations refused before the call went through.
std::uint64_t sweep(const std::function<void()>& call, Refuse how) {
  const std::int64_t before = live_blocks();
  for (std::uint64_t which = 0; which < 1000; ++which) {
    AllocationFault fault(which, how);
    const Outcome outcome = outcome_of(call, fault);
    EXPECT_EQ(live_blocks(), before) << "allocation " << which;
    if (outcome == Outcome::done) {
      EXPECT_LE(fault.requests(), which) << "a refused allocation went unnoticed";
      return which;
    }
    EXPECT_EQ(outcome, Outcome::error) << "allocation " << which;
  }
  ADD_FAILURE() << "never went through";
  return 0;
}

class EveryAllocation : public ::testing::TestWithParam<Refuse> {};

TEST_P(EveryAllocation, OfEveryAlgorithmAndForm) {
  for (const char* name : {"hexagonal_2d", "dense", "two_far_clusters"}) {
    const scenes::Scene scene = scenes::scene_named(name).make(700, 1);
    for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
      SCOPED_TRACE(std::string(name) + ", " + std::string(name_of(algorithm)));
      const bool refused =
          std::string_view(name) == "two_far_clusters" &&
          (algorithm == Algorithm::screening_array || algorithm == Algorithm::munjiza_nbs);
      if (refused) continue;
      const ElementView elements = view_of(scene);
      Options options;
      options.algorithm = algorithm;
      EXPECT_GT(
          sweep([&] { static_cast<void>(find_contact_pairs(elements, Domain::open(), options)); },
                GetParam()),
          2U);
      sweep([&] { static_cast<void>(count_contact_pairs(elements, Domain::open(), options)); },
            GetParam());
      options.order = Order::as_found;
      sweep([&] { static_cast<void>(find_contact_pairs(elements, Domain::open(), options)); },
            GetParam());
    }
  }
}

TEST_P(EveryAllocation, InPeriodicDomains) {
  const scenes::Scene scene = scenes::scene_named("dense").make(300, 1);
  const ElementView elements = view_of(scene);
  const Domain domain = Domain::lattice({6, 0, 0}, {3, 6, 0}, {0, 1, 6});
  for (const AlgorithmInfo& row : algorithms()) {
    if (!row.periodic) continue;
    SCOPED_TRACE(row.name);
    const Options options{.algorithm = row.algorithm, .shifts = Shifts::stored};
    EXPECT_GT(sweep([&] { static_cast<void>(find_contact_pairs(elements, domain, options)); },
                    GetParam()),
              2U);
    sweep(
        [&] {
          static_cast<void>(build_neighbor_list(elements, domain, NeighborListKind::full, options));
        },
        GetParam());
  }
}

TEST_P(EveryAllocation, OfTheCellsOfATrace) {
  for (const char* name : {"hexagonal_2d", "dense"}) {
    const scenes::Scene scene = scenes::scene_named(name).make(700, 1);
    EXPECT_GT(sweep([&] { static_cast<void>(trace::integerise(view_of(scene), {})); }, GetParam()),
              2U);
  }
}

TEST_P(EveryAllocation, LeavesTheNextDetectionRight) {
  const scenes::Scene scene = scenes::scene_named("dense").make(300, 1);
  const PairVector expected = oracle_pairs(scene);
  for (std::uint64_t which = 0; which < 12; ++which) {
    AllocationFault fault(which, GetParam());
    static_cast<void>(
        outcome_of([&] { static_cast<void>(find_contact_pairs(view_of(scene))); }, fault));
    EXPECT_TRUE(same_canonical_pairs(expected, find_contact_pairs(view_of(scene)).pairs()));
  }
}

INSTANTIATE_TEST_SUITE_P(Refusals, EveryAllocation,
                         ::testing::Values(Refuse::one, Refuse::all_from_there_on),
                         [](const auto& parameter) {
                           return std::string(parameter.param == Refuse::one ? "one" : "all");
                         });

}  // namespace
}  // namespace abut::testing
