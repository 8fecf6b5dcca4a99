// The part of the device benchmark that needs no CUDA, over the host executor: two rows for each
// form of result, answers that are compared before they are timed, and bytes that are counted.

#include "benchmarks/device/device_forms.hpp"
#include "benchmarks/device/device_row.hpp"
#include "benchmarks/device/list_bytes.hpp"
#include "benchmarks/device/same_lists.hpp"
#include "scenes/scene.hpp"

#include <abut/neighbor_list.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/pair_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using Row = std::vector<std::string>;

/// Cells of comma-separated lines.
std::vector<Row> rows_of(const std::string& text) {
  std::vector<Row> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Row row;
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      row.push_back(line.substr(begin, end - begin));
      begin = end + 1;
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> measured(std::string_view scene, std::uint64_t elements) {
  ::testing::internal::CaptureStdout();
  benchmarks::print_heading();
  EXPECT_TRUE(benchmarks::measure_forms(scene, elements, {1, 1e10}));
  return rows_of(::testing::internal::GetCapturedStdout());
}

TEST(DeviceBenchmark, HasTwoRowsForEachForm) {
  for (const char* const scene : {"dense", "gas", "graded_1000"}) {
    const std::vector<Row> rows = measured(scene, 2000);
    const std::vector<std::string> forms{"gaps",      "half list",
                                         "full list", "full list with gaps",
                                         "periodic",  "periodic with shifts"};
    ASSERT_EQ(rows.size(), 1 + 2 * forms.size());
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const Row& row = rows[k];
      ASSERT_EQ(row.size(), rows[0].size()) << k;
      const std::string contestant = k % 2 == 1 ? "abut on the processor: " : "abut::device: ";
      EXPECT_EQ(row[0], contestant + forms[(k - 1) / 2]);
      EXPECT_EQ(row[1], scene);
      EXPECT_EQ(row[2], "2000");
      EXPECT_EQ(row[4], "right");
      // Both find the same; in the periodic block more than in open space.
      EXPECT_EQ(row[3], rows[k % 2 == 1 ? k + 1 : k - 1][3]);
      EXPECT_EQ(std::stoul(row[3]) > std::stoul(rows[1][3]), k > 8) << scene << ' ' << row[0];
      EXPECT_GT(std::stod(row[6]), 0.0);
      EXPECT_GT(std::stod(row[10]), 0.0);
      // Bytes of stages: of the device, in open space, where there is one level of sizes.
      EXPECT_EQ(row[11].empty(), k % 2 == 1 || k > 8 || row[1] == "graded_1000") << row[0];
      EXPECT_GT(std::stod(row.back()), 8.0);
    }
  }
}

TEST(DeviceBenchmark, TimesNoWrongAnswer) {
  ::testing::internal::CaptureStdout();
  benchmarks::print_heading();
  benchmarks::DeviceRow row;
  row.is_right = false;
  row.median = 3.0;
  benchmarks::print_row(row, {}, 1.0);
  const std::vector<Row> rows = rows_of(::testing::internal::GetCapturedStdout());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].size(), rows[0].size());
  EXPECT_EQ(rows[1][4], "WRONG");
  EXPECT_TRUE(std::all_of(rows[1].begin() + 5, rows[1].end(),
                          [](const std::string& cell) { return cell.empty(); }));
}

PairGeometry geometry_of(double gap) {
  PairGeometry geometry;
  geometry.gaps = {gap};
  return geometry;
}

PairList list_with_gap(double gap) {
  return {PairArray{{0, 1}}, ShiftArray{}, geometry_of(gap), Statistics{}};
}

NeighborList rows_with_gap(double gap) {
  return {NeighborList::Offsets{0, 1, 1}, NeighborList::Neighbors{1}, ShiftArray{},
          geometry_of(gap), Statistics{}};
}

TEST(DeviceBenchmark, ComparesGapsBitForBit) {
  EXPECT_TRUE(benchmarks::same(list_with_gap(-0.0), list_with_gap(-0.0)));
  EXPECT_FALSE(benchmarks::same(list_with_gap(-0.0), list_with_gap(0.0)));
  EXPECT_FALSE(benchmarks::same(list_with_gap(-0.0), PairList({{0, 1}}, Statistics{})));
  EXPECT_TRUE(benchmarks::same(rows_with_gap(-0.0), rows_with_gap(-0.0)));
  EXPECT_FALSE(benchmarks::same(rows_with_gap(-0.0), rows_with_gap(0.0)));
  EXPECT_FALSE(benchmarks::same(rows_with_gap(-0.0), NeighborList({0, 1, 1}, {1}, Statistics{})));
}

using benchmarks::compulsory_bytes;
using benchmarks::DetectionSize;
using benchmarks::moved_bytes;
using benchmarks::RadiiGiven;
using benchmarks::ResultForm;

/// Sums of docs: 10^6 elements of three columns are sorted in three passes of 8 bits, and so are
/// their pairs.
TEST(DeviceBenchmark, CountsBytesOfEachForm) {
  constexpr double million = 1e6;
  DetectionSize size{.elements = 1'000'000, .pairs = 3'000'000};
  EXPECT_EQ(compulsory_bytes(size), million * (24 + 3 * 8));
  // check, place, sort, gather, directory, count, tests, scans, write; then a pair's write and
  // order
  const double search = 24 + (24 + 24) + 52 + 52 + 16 + (24 + 8) + (8 + 8) + 16 + (24 + 8);
  const double order = (3 * 16 + 8) + 8 + 16;
  EXPECT_EQ(moved_bytes(size), million * (search + 3 * (8 + order)));

  size.form = ResultForm::count;
  EXPECT_EQ(compulsory_bytes(size), million * 24);
  EXPECT_EQ(moved_bytes(size), million * search);

  size.form = ResultForm::half_list;
  EXPECT_EQ(compulsory_bytes(size), million * (24 + 8 + 3 * 4) + 8);
  EXPECT_EQ(moved_bytes(size), million * (search + 3 * (8 + order) + 8 + 3 * 20) + 8);

  size.form = ResultForm::full_list;
  EXPECT_EQ(compulsory_bytes(size), million * (24 + 8 + 6 * 4) + 8);
  EXPECT_EQ(moved_bytes(size), million * (search + 3 * (8 + 32) + 6 * (order + 20) + 8) + 8);

  size = {.elements = 1'000'000, .pairs = 3'000'000, .has_gaps = true};
  EXPECT_EQ(compulsory_bytes(size), million * (24 + 3 * 16));
  EXPECT_EQ(moved_bytes(size), million * (search + 3 * (8 + order + 8 + 3 * 40 + 16)));

  size = {.elements = 1'000'000, .pairs = 3'000'000, .exact_decisions = 3'000'000};
  EXPECT_EQ(moved_bytes(size), million * (search + 3 * (order + 8 + (16 + 6 * 32) + 8)));
  size.form = ResultForm::count;
  EXPECT_EQ(moved_bytes(size), million * (search + 3 * (8 + (16 + 6 * 32) + 8 + 8)));
}

TEST(DeviceBenchmark, CountsNoBytesThatAreNotKnown) {
  const DetectionSize known{.elements = 1000, .pairs = 3000};
  EXPECT_TRUE(moved_bytes(known).has_value());
  DetectionSize size = known;
  size.is_periodic = true;
  EXPECT_FALSE(moved_bytes(size).has_value());
  size = known;
  size.radii = RadiiGiven::different;
  EXPECT_FALSE(moved_bytes(size).has_value());
  // A column of radii is read, and each size is brought to its place.
  size.radii = RadiiGiven::equal_in_column;
  EXPECT_EQ(compulsory_bytes(size) - compulsory_bytes(known), 8000.0);
  EXPECT_EQ(*moved_bytes(size) - *moved_bytes(known), 1000.0 * (8 + 8 + 40 + 4 + 4));
  size.has_shifts = true;
  EXPECT_EQ(compulsory_bytes(size) - compulsory_bytes(known), 8000.0 + 3000.0 * 12);

  const auto radii_of = [](const char* scene) {
    return benchmarks::size_of(scenes::scene_named(scene).make(100, 1)).radii;
  };
  EXPECT_EQ(radii_of("dense"), RadiiGiven::equal_in_column);
  EXPECT_EQ(radii_of("graded"), RadiiGiven::different);
}

}  // namespace
}  // namespace abut::testing
