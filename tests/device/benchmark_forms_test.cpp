// The part of the device benchmark that needs no CUDA, over the host executor: two rows for each
// form of result, and answers that are compared before they are timed.

#include "benchmarks/device/device_forms.hpp"
#include "benchmarks/device/device_row.hpp"

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
    ASSERT_EQ(rows.size(), 11U);
    const std::vector<std::string> forms{"gaps", "half list", "full list", "periodic",
                                         "periodic with shifts"};
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
      EXPECT_EQ(std::stoul(row[3]) > std::stoul(rows[1][3]), k > 6) << scene << ' ' << row[0];
      EXPECT_GT(std::stod(row[6]), 0.0);
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

}  // namespace
}  // namespace abut::testing
