// The look inside refuses what it cannot show, in one sentence, and never touches memory outside.

#include "support/algorithm_list.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/trace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using trace::CellSystem;

/// Counts candidate pairs and looks at every number that it is shown.
class CountingSink final : public trace::Sink {
 public:
  void stage(std::string_view, std::array<std::int32_t, 3>) override {}
  void array(const trace::Array& array) override {
    for (const std::int32_t value : array.values) sum += value;
  }
  void search_step(const trace::SearchStep&) override {}
  void candidate_pair(ElementIndex, ElementIndex) override { ++candidates; }

  std::int64_t sum = 0;
  std::uint64_t candidates = 0;
};

CellSystem system_of(int dimensions, std::array<std::int32_t, 3> cell_count,
                     std::vector<std::array<std::int32_t, 3>> cells) {
  return {dimensions, cell_count, std::move(cells)};
}

void expect_refused(ErrorCode code, std::initializer_list<std::string_view> words,
                    const CellSystem& system) {
  for (const AlgorithmInfo& row : traceable_algorithms()) {
    SCOPED_TRACE(std::string(row.name));
    CountingSink sink;
    expect_error(code, words, [&] { trace::run(row.algorithm, system, sink); });
    EXPECT_EQ(sink.candidates, 0U);
  }
}

TEST(Trace, RefusesCellsOutsideTheGrid) {
  for (const std::int32_t cell : {-1, 5, 1 << 30, std::numeric_limits<std::int32_t>::min()}) {
    const std::string value = std::to_string(cell);
    expect_refused(ErrorCode::wrong_usage, {"element 1", value, "0 to 4"},
                   system_of(2, {5, 5, 1}, {{0, 0, 0}, {cell, 0, 0}}));
    expect_refused(ErrorCode::wrong_usage, {"element 0", value, "0 to 4"},
                   system_of(3, {9, 9, 5}, {{0, 0, cell}}));
  }
}

TEST(Trace, RefusesGridsThatAreNone) {
  expect_refused(ErrorCode::wrong_usage, {"cell_count", "-5"}, system_of(2, {5, -5, 1}, {}));
  expect_refused(ErrorCode::wrong_usage, {"cell_count", "0"}, system_of(3, {5, 5, 0}, {}));
  expect_refused(ErrorCode::wrong_usage, {"dimensions", "4"}, system_of(4, {5, 5, 5}, {}));
}

TEST(Trace, RefusesTooManyElements) {
  expect_refused(ErrorCode::limit_exceeded, {"65537", "65536"},
                 system_of(2, {5, 5, 1}, std::vector<std::array<std::int32_t, 3>>(65537)));
}

TEST(Trace, RefusesArraysTooLongToRead) {
  CountingSink sink;
  constexpr std::int32_t many = std::numeric_limits<std::int32_t>::max() - 2;
  const CellSystem system = system_of(3, {many, many, many}, {{0, 0, 0}});
  for (const Algorithm algorithm : {Algorithm::screening_array, Algorithm::munjiza_nbs}) {
    expect_error(ErrorCode::limit_exceeded, {"16 MiB"},
                 [&] { trace::run(algorithm, system, sink); });
  }
}

TEST(Trace, RefusesAutomatic) {
  CountingSink sink;
  expect_error(ErrorCode::wrong_usage, {"auto"}, [&] {
    trace::run(Algorithm::automatic, system_of(2, {1, 1, 1}, {{0, 0, 0}}), sink);
  });
}

TEST(Trace, IntegeriseChecksAsADetectionDoes) {
  scenes::Scene scene = scenes::scene_named("dense").make(10, 1);
  Options options;
  options.margin = -1.0;
  expect_error(ErrorCode::invalid_input, {"margin = -1"},
               [&] { static_cast<void>(trace::integerise(view_of(scene), options)); });
  scene.y[3] = std::numeric_limits<double>::quiet_NaN();
  expect_error(ErrorCode::invalid_input, {"element 3", "y = nan"},
               [&] { static_cast<void>(trace::integerise(view_of(scene), {})); });
  scene.y[3] = 0.0;
  options.margin = 0.0;
  options.max_bytes = 100;
  expect_error(ErrorCode::limit_exceeded, {"memory bound is 100 bytes"},
               [&] { static_cast<void>(trace::integerise(view_of(scene), options)); });
}

/// All algorithms but direct checking meet the same candidates: those of the mask.
TEST(Trace, ShowsTheSameCandidates) {
  for (const char* name : {"hexagonal_2d", "dense"}) {
    const scenes::Scene scene = scenes::scene_named(name).make(300, 1);
    const CellSystem system = trace::integerise(view_of(scene), {});
    std::vector<std::uint64_t> counts;
    for (const AlgorithmInfo& row : traceable_algorithms()) {
      if (row.algorithm == Algorithm::direct_check) continue;
      CountingSink sink;
      trace::run(row.algorithm, system, sink);
      counts.push_back(sink.candidates);
    }
    EXPECT_GT(counts.front(), 0U);
    EXPECT_EQ(counts, std::vector<std::uint64_t>(counts.size(), counts.front())) << name;
  }
}

/// Stops the walk at the first candidate pair.
class StoppingSink final : public trace::Sink {
 public:
  void stage(std::string_view, std::array<std::int32_t, 3>) override {}
  void array(const trace::Array&) override {}
  void search_step(const trace::SearchStep&) override {}
  void candidate_pair(ElementIndex, ElementIndex) override { throw std::bad_alloc(); }
};

/// Lack of memory in the caller's sink stays what it is.
TEST(Trace, LetsExceptionsOfTheSinkThrough) {
  const CellSystem system = system_of(2, {5, 5, 1}, {{0, 0, 0}, {1, 0, 0}});
  for (const AlgorithmInfo& row : traceable_algorithms()) {
    SCOPED_TRACE(std::string(row.name));
    StoppingSink sink;
    EXPECT_THROW(trace::run(row.algorithm, system, sink), std::bad_alloc);
  }
}

TEST(Trace, OfNothing) {
  const CellSystem system = trace::integerise(view_of(scene_of(3, {})), {});
  EXPECT_TRUE(system.cells.empty());
  for (const AlgorithmInfo& row : traceable_algorithms()) {
    CountingSink sink;
    trace::run(row.algorithm, system, sink);
    EXPECT_EQ(sink.candidates, 0U);
  }
}

}  // namespace
}  // namespace abut::testing
