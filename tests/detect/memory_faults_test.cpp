// Every public call with too little memory: allocation k is refused, or all from k on, for every k.
// Always an Error{limit_exceeded}, never std::bad_alloc nor a leak; and what was used works
// afterwards as if nothing had happened.

#include "detect/public_calls.hpp"
#include "support/allocation_faults.hpp"
#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::uint64_t most_allocations = 3000;

/// A call with too little memory.
struct Attempt {
  enum class End { done, error, bad_alloc } end = End::done;
  ErrorCode code = ErrorCode::unexpected;  ///< of the error
  bool was_refused = false;                ///< whether it asked for what it was not to have
  std::int64_t left_behind = 0;            ///< blocks
};

template <class Call>
Attempt attempted(const Call& call, std::uint64_t which, Refuse how) {
  Attempt attempt;
  const std::int64_t before = live_blocks();
  AllocationFault fault(which, how);
  try {
    call();
  } catch (const Error& error) {
    attempt.end = Attempt::End::error;
    attempt.code = error.code();
  } catch (const std::bad_alloc&) {
    attempt.end = Attempt::End::bad_alloc;
  }
  fault.disarm();
  attempt.was_refused = fault.requests() > which;
  attempt.left_behind = live_blocks() - before;
  return attempt;
}

/// Lack of memory is a limit that is met, unless the call can do without, as with candidates of a
/// skin; else the call ends as it does with memory.
void expect_right(const Attempt& attempt, std::optional<ErrorCode> refusal) {
  EXPECT_NE(attempt.end, Attempt::End::bad_alloc);
  if (attempt.end == Attempt::End::done) {
    EXPECT_FALSE(refusal.has_value()) << "the call was to be refused";
  } else if (attempt.end == Attempt::End::error) {
    const ErrorCode expected =
        attempt.was_refused || !refusal ? ErrorCode::limit_exceeded : *refusal;
    EXPECT_EQ(attempt.code, expected);
  }
}

class MemoryFaults : public ::testing::TestWithParam<Refuse> {};

TEST_P(MemoryFaults, OfEveryPublicCallAreErrors) {
  for (const PublicCall& row : public_calls()) {
    SCOPED_TRACE(row.name + ", " + row.what);
    std::uint64_t which = 0;
    for (bool refused = true; refused && which < most_allocations; ++which) {
      const Attempt attempt = attempted(row.call, which, GetParam());
      SCOPED_TRACE(which);
      expect_right(attempt, row.refusal);
      EXPECT_EQ(attempt.left_behind, 0);
      refused = attempt.was_refused;
    }
    EXPECT_GT(which, 1U) << "it allocates nothing: it tests nothing";
    EXPECT_LT(which, most_allocations);
  }
}

/// What a detector finds, with a skin and ids or without.
struct Detectors {
  const scenes::Scene scene = scenes::scene_named("dense").make(200, 1);
  ElementView elements = view_of(scene);
  Domain domain = Domain::periodic({5.0, 5.0, 5.0});
  PairVector expected;
  std::vector<std::uint64_t> ids;

  Detectors() {
    const PairList found = find_contact_pairs(elements, domain);
    expected.assign(found.begin(), found.end());
    for (std::uint64_t k = 0; k < scene.size(); ++k) ids.push_back(1000 - k);
  }
};

TEST_P(MemoryFaults, LeaveTheDetectorWorking) {
  const Detectors g;
  const std::vector<std::function<void(Detector&)>> uses{
      [&](Detector& d) { d.find_contact_pairs(g.elements, g.domain); },
      [&](Detector& d) { d.count_contact_pairs(g.elements); },
      [&](Detector& d) { d.build_neighbor_list(g.elements, g.domain, NeighborListKind::full); },
      [&](Detector& d) { d.find_contact_pairs(g.elements, g.elements, g.domain); },
      [&](Detector& d) { d.set_ids(g.ids); },
      [&](Detector& d) { d.set_skin(Skin::fixed(0.05)); },
  };
  for (const auto& use : uses) {
    for (const Skin skin : {Skin::none(), Skin::fixed(0.1)}) {
      bool refused = true;
      for (std::uint64_t which = 0; refused && which < most_allocations; ++which) {
        Detector detector;
        detector.set_skin(skin);
        const Attempt attempt = attempted([&] { use(detector); }, which, GetParam());
        expect_right(attempt, {});
        refused = attempt.was_refused;
        ASSERT_TRUE(same_canonical_pairs(g.expected,
                                         detector.find_contact_pairs(g.elements, g.domain).pairs()))
            << which;
      }
      EXPECT_FALSE(refused);
    }
  }
}

/// A list that is to grow while pairs are found, and cannot, is filled when all are found.
TEST_P(MemoryFaults, OfAListThatGrowsLoseNoPair) {
  const scenes::Scene scene = scenes::scene_named("dense").make(25000, 1);
  const Options options{.order = Order::as_found, .threads = 1};
  const PairList expected = find_contact_pairs(view_of(scene), Domain::open(), options);
  std::size_t done_without = 0;
  bool refused = true;
  for (std::uint64_t which = 0; refused && which < most_allocations; ++which) {
    PairList found;
    const Attempt attempt =
        attempted([&] { found = find_contact_pairs(view_of(scene), Domain::open(), options); },
                  which, GetParam());
    refused = attempt.was_refused;
    EXPECT_NE(attempt.end, Attempt::End::bad_alloc);
    if (attempt.end != Attempt::End::done) continue;
    if (refused) ++done_without;
    ASSERT_TRUE(std::ranges::equal(expected.pairs(), found.pairs())) << which;
  }
  EXPECT_FALSE(refused);
  EXPECT_EQ(done_without > 0, GetParam() == Refuse::one);
}

/// On an error nothing has changed, and the update may be tried again.
void expect_history_as_it_was(const Detectors& g, const PairList& before, const PairList& now,
                              const Options& options, Refuse how) {
  const auto first_step = [&](ContactHistory<double>& history) {
    history.update(before, g.elements, Domain::open(), g.ids);
    for (std::size_t k = 0; k < before.size(); ++k) history.values()[k] = static_cast<double>(k);
  };
  ContactHistory<double> expected(options);
  first_step(expected);
  expected.update(now, g.elements);
  bool refused = true;
  for (std::uint64_t which = 0; refused && which < most_allocations; ++which) {
    ContactHistory<double> history(options);
    first_step(history);
    const Attempt attempt = attempted([&] { history.update(now, g.elements); }, which, how);
    expect_right(attempt, {});
    refused = attempt.was_refused;
    if (attempt.end == Attempt::End::error) {
      ASSERT_EQ(history.values().size(), before.size());
      for (std::size_t k = 0; k < before.size(); ++k) ASSERT_EQ(history.values()[k], k);
      ASSERT_EQ(history.kept(), 0U);
      history.update(now, g.elements);
    }
    ASSERT_TRUE(std::ranges::equal(history.values(), expected.values()));
    ASSERT_TRUE(std::ranges::equal(history.born(), expected.born()));
    ASSERT_EQ(history.kept(), expected.kept());
    ASSERT_EQ(history.lost().size(), expected.lost().size());
  }
  EXPECT_FALSE(refused);
}

TEST_P(MemoryFaults, LeaveTheHistoryAsItWas) {
  const Detectors g;
  const PairList many = find_contact_pairs(g.elements, Domain::open(), {.margin = 0.1});
  const PairList few = find_contact_pairs(g.elements);
  ASSERT_LT(few.size(), many.size());
  for (const int threads : {1, 3}) {
    SCOPED_TRACE(threads);
    const Options options{.threads = threads};
    expect_history_as_it_was(g, many, few, options, GetParam());
    expect_history_as_it_was(g, few, many, options, GetParam());
  }
}

/// Spheres that have rolled on over a floor of triangles, one of them gone.
struct Rolling {
  std::vector<std::array<double, 3>> corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
  std::vector<std::array<int, 3>> faces{{0, 1, 2}, {1, 2, 3}};
  TriangleMesh floor{corners, faces};
  std::vector<std::array<double, 3>> first{{1.5, 2, 1}, {1, 1, 1}, {2.5, 2, 1}, {3, 3, 1}};
  std::vector<std::array<double, 3>> second{{2.5, 2, 1}, {1, 1, 9}, {1.5, 2, 1}, {3, 3, 1}};
  MeshContactList before = find_mesh_contacts(spheres(first, 1.0), floor);
  MeshContactList now = find_mesh_contacts(spheres(second, 1.0), floor);
};

TEST_P(MemoryFaults, LeaveTheHistoryOfWallsAsItWas) {
  const Rolling g;
  const auto first_step = [&](MeshContactHistory<double>& history) {
    history.update(g.before, spheres(g.first, 1.0), g.floor);
    for (std::size_t k = 0; k < 4; ++k) history.values()[k] = static_cast<double>(k);
  };
  bool refused = true;
  for (std::uint64_t which = 0; refused && which < most_allocations; ++which) {
    MeshContactHistory<double> history;
    first_step(history);
    const auto update = [&] { history.update(g.now, spheres(g.second, 1.0), g.floor); };
    const Attempt attempt = attempted(update, which, GetParam());
    expect_right(attempt, {});
    refused = attempt.was_refused;
    if (refused) {
      ASSERT_TRUE(std::ranges::equal(history.values(), std::array{0.0, 1.0, 2.0, 3.0}));
      ASSERT_EQ(history.born().size(), 4U);
      ASSERT_TRUE(history.passed_on().empty() && history.lost().empty());
      update();
    }
    ASSERT_TRUE(std::ranges::equal(history.values(), std::array{0.0, 2.0, 3.0}));
    ASSERT_TRUE(std::ranges::equal(history.passed_on(), std::array{0U, 1U}));
    ASSERT_EQ(history.lost().size(), 1U);
  }
  EXPECT_FALSE(refused);
}

/// Lack of memory in the caller's own code stays what it is.
TEST(MemoryFaultsOfTheCaller, PassThrough) {
  const Detectors g;
  const auto fail = [](ContactPair) { throw std::bad_alloc(); };
  EXPECT_THROW(for_each_contact_pair(g.elements, Domain::open(), {}, fail), std::bad_alloc);
  Options options;
  options.progress = [](const Progress&) -> ProgressAction { throw std::bad_alloc(); };
  EXPECT_THROW((void)find_contact_pairs(g.elements, g.domain, options), std::bad_alloc);
  const std::vector<std::array<double, 3>> corners{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}};
  const std::vector<std::array<int, 3>> faces{{0, 1, 2}};
  const TriangleMesh mesh(corners, faces);
  EXPECT_THROW((void)find_mesh_contacts(g.elements, mesh, options), std::bad_alloc);
}

/// Also what the library itself would take for lack of memory or for an error of its own.
TEST(ExceptionsOfTheCaller, PassThrough) {
  const Detectors g;
  const auto too_long = [](ContactPair) { throw std::length_error("the caller's"); };
  EXPECT_THROW(for_each_contact_pair(g.elements, Domain::open(), {}, too_long), std::length_error);
  const auto refuse = [](ContactPair) { throw Error(ErrorCode::output_failed, "the caller's"); };
  expect_error(ErrorCode::output_failed, {"the caller's"},
               [&] { for_each_contact_pair(g.elements, Domain::open(), {}, refuse); });
  Options options;
  options.progress = [](const Progress&) -> ProgressAction {
    throw Error(ErrorCode::limit_exceeded, "the caller's");
  };
  Detector detector(options);
  detector.set_skin(Skin::fixed(0.1));
  expect_error(ErrorCode::limit_exceeded, {"the caller's"},
               [&] { detector.find_contact_pairs(g.elements, g.domain); });
}

INSTANTIATE_TEST_SUITE_P(Refusals, MemoryFaults,
                         ::testing::Values(Refuse::one, Refuse::all_from_there_on),
                         [](const auto& parameter) {
                           return std::string(parameter.param == Refuse::one ? "one" : "all");
                         });

}  // namespace
}  // namespace abut::testing
