// What calls for contacts of simplices refuse, and how they say so.

#include "simplices/simplex_systems.hpp"
#include "support/error_expectations.hpp"

#include <abut/simplex_contacts.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<int, 3>>;

const Points vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles two{{0, 1, 2}, {1, 2, 3}};

void expect_refused(std::initializer_list<std::string_view> words, const Options& options) {
  expect_error(ErrorCode::wrong_usage, words, [&] {
    static_cast<void>(find_simplex_contacts(simplices_3d(vertices, two), options));
  });
}

TEST(SimplexErrors, VerticesThatAreNotThere) {
  for (const int number : {-1, 4}) {
    const Triangles cells{{0, 1, 2}, {1, number, 3}};
    const SimplexView view = simplices_3d(vertices, cells);
    const auto words = {std::string_view("cell 1"), std::string_view("there are 4")};
    expect_error(ErrorCode::invalid_input, words,
                 [&] { static_cast<void>(find_simplex_contacts(view)); });
    expect_error(ErrorCode::invalid_input, {"cell 1", "in the second set"}, [&] {
      static_cast<void>(find_simplex_contacts(simplices_3d(vertices, two), view));
    });
    expect_error(ErrorCode::invalid_input, words, [&] {
      static_cast<void>(touching(view, view, {0, 1}));
    });
  }
}

TEST(SimplexErrors, VerticesThatAreNotFinite) {
  Points bad(5000, {0, 0, 0});
  Triangles cells(4000, {0, 1, 2});
  cells[2500] = {0, 1, 4000};
  cells[3500] = {0, 1, 4100};
  bad[4100][1] = std::numeric_limits<double>::quiet_NaN();
  bad[4000][2] = -std::numeric_limits<double>::infinity();
  bad[4999][0] = std::numeric_limits<double>::infinity();  // of no cell
  for (const int threads : {1, 3}) {
    expect_error(ErrorCode::invalid_input, {"vertex 4000 of cell 2500", "z = -inf", "finite"}, [&] {
      static_cast<void>(find_simplex_contacts(simplices_3d(bad, cells), {.threads = threads}));
    });
  }
  cells.resize(100);
  EXPECT_EQ(find_simplex_contacts(simplices_3d(bad, cells)).size(), 100U * 99 / 2);
}

TEST(SimplexErrors, CellsThatAreNoSimplices) {
  const std::vector<std::array<int, 4>> quadrilaterals{{0, 1, 2, 3}};
  const std::vector<std::array<double, 2>> flat(4);
  expect_error(ErrorCode::wrong_usage, {"cells of 4 vertices in 2 dimensions", "1 to 3"},
               [&] { static_cast<void>(simplices_2d(flat, quadrilaterals)); });
  const std::vector<std::array<int, 8>> hexahedra{{0, 1, 2, 3, 0, 1, 2, 3}};
  expect_error(ErrorCode::wrong_usage, {"cells of 8 vertices in 3 dimensions", "1 to 4"},
               [&] { static_cast<void>(simplices_3d(vertices, hexahedra)); });
  expect_error(ErrorCode::wrong_usage, {"boxes", "points"},
               [&] { static_cast<void>(SimplexView(boxes(vertices, vertices), two)); });
}

TEST(SimplexErrors, WhatSimplicesDoNotHave) {
  expect_refused({"margin = 0.5"}, {.margin = 0.5});
  expect_refused({"margin = nan"}, {.margin = std::numeric_limits<double>::quiet_NaN()});
  expect_refused({"nothing is measured"}, {.quantities = Quantity::gap});
  expect_refused({"threads = -1"}, {.threads = -1});
}

TEST(SimplexErrors, TwoSets) {
  const Points copy = vertices;
  const SimplexView first = simplices_3d(vertices, two);
  expect_error(ErrorCode::wrong_usage, {"share vertices", "same vertices"}, [&] {
    static_cast<void>(
        find_simplex_contacts(first, simplices_3d(copy, two), {}, SharedVertices::excluded));
  });
  const std::vector<std::array<double, 2>> flat(4);
  const SimplexView second = simplices_2d(flat, two);
  expect_error(ErrorCode::wrong_usage, {"3 dimensions", "the second 2"},
               [&] { static_cast<void>(find_simplex_contacts(first, second)); });
  expect_error(ErrorCode::wrong_usage, {"3 dimensions", "the second 2"}, [&] {
    static_cast<void>(touching(first, second, {0, 0}));
  });
  expect_error(ErrorCode::wrong_usage, {"simplex 2", "there are 2"}, [&] {
    static_cast<void>(touching(first, first, {0, 2}));
  });
}

TEST(SimplexErrors, LimitsAndHooks) {
  const auto system = random_system<3, 4>(2000, 21);
  const PairCount size = find_simplex_contacts(system.view()).size();
  EXPECT_EQ(find_simplex_contacts(system.view(), {.max_pairs = size}).size(), size);
  expect_error(ErrorCode::limit_exceeded, {std::to_string(size - 1)}, [&] {
    static_cast<void>(find_simplex_contacts(system.view(), {.max_pairs = size - 1}));
  });
  expect_error(ErrorCode::limit_exceeded, {"bytes"}, [&] {
    static_cast<void>(find_simplex_contacts(system.view(), {.max_bytes = 100000}));
  });
  expect_error(ErrorCode::cancelled, {}, [&] {
    static_cast<void>(find_simplex_contacts(
        system.view(), {.progress = [](const Progress&) { return ProgressAction::cancel; }}));
  });
  EXPECT_THROW(static_cast<void>(find_simplex_contacts(
                   system.view(), {.progress = [](const Progress&) -> ProgressAction {
                     throw std::out_of_range("mine");
                   }})),
               std::out_of_range);
}

/// Numbers for which nothing but the longest integers decide: the hook is asked in the meantime,
/// and a cancel ends the call long before all is decided.
TEST(SimplexErrors, LongDecisionsAreCancelled) {
  scenes::Random random(23);
  SimplexSystem<3, 4> system;
  for (int k = 0; k < 1200; ++k) {
    auto& vertex = system.vertices.emplace_back();
    for (double& x : vertex) x = random.uniform() < 0.5 ? 0x1p1000 : 0x1p-1000 * random.uniform();
    if (k % 4 == 3) system.cells.push_back({k - 3, k - 2, k - 1, k});
  }
  for (const int threads : {1, 3}) {
    int asked = 0;
    const auto hook = [&](const Progress& progress) {
      asked += progress.phase == std::string_view("search") ? 1 : 0;
      return asked > 20 ? ProgressAction::cancel : ProgressAction::proceed;
    };
    expect_error(ErrorCode::cancelled, {}, [&] {
      static_cast<void>(
          find_simplex_contacts(system.view(), {.threads = threads, .progress = hook}));
    });
  }
}

/// Bytes are counted, and those of the simplices are among them.
TEST(SimplexErrors, BytesAreCounted) {
  const auto system = random_system<3, 4>(2000, 22);
  const Statistics statistics = find_simplex_contacts(system.view()).statistics();
  EXPECT_GE(statistics.working_bytes, 2000U * (4 * 3 * 8 + 6 * 8));
  EXPECT_GT(statistics.peak_bytes, statistics.contact_pairs * sizeof(ContactPair));
}

}  // namespace
}  // namespace abut::testing
