#include "io/write/write_elements.hpp"

#include "scenes/random.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace abut::io::testing {
namespace {

using limits = std::numeric_limits<double>;

double random_finite(scenes::Random& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random.next());
    if (std::isfinite(value)) return value;
  }
}

/// Numbers of every size, and those that careless writers lose.
Snapshot awkward(int dimensions, bool ids) {
  scenes::Random random(11);
  Snapshot snapshot;
  snapshot.dimensions = dimensions;
  const double special[] = {
      0.0,       -0.0, limits::denorm_min(), -limits::min(), limits::max(), limits::lowest(), 0.1,
      1.0 / 3.0, 1e22, 123456789012345680.0};
  for (std::size_t k = 0; k < 500; ++k) {
    const auto pick = [&] { return k < 10 ? special[k] : random_finite(random); };
    snapshot.x.push_back(pick());
    snapshot.y.push_back(pick());
    if (dimensions == 3) snapshot.z.push_back(pick());
    snapshot.radius.push_back(k < 2 ? special[k] : std::abs(pick()));
    if (ids) snapshot.ids.push_back(static_cast<std::int64_t>(random.next()));
  }
  return snapshot;
}

bool same_bits(const Numbers& a, const Numbers& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::ranges::equal(a, b, {}, bits, bits);
}

void expect_same(const Snapshot& read, const Snapshot& written) {
  EXPECT_EQ(read.dimensions, written.dimensions);
  EXPECT_TRUE(same_bits(read.x, written.x));
  EXPECT_TRUE(same_bits(read.y, written.y));
  EXPECT_TRUE(same_bits(read.z, written.z));
  EXPECT_TRUE(same_bits(read.radius, written.radius));
  EXPECT_EQ(read.ids, written.ids);
}

TEST(WriteElements, ReadingGivesTheSameBits) {
  const Scratch scratch;
  for (const char* name : {"a.csv", "a.dump", "a.lammpstrj", "a.xyz", "a.extxyz", "a"}) {
    for (const int dimensions : {2, 3}) {
      for (const bool ids : {false, true}) {
        SCOPED_TRACE(std::string(name) + std::to_string(dimensions) + (ids ? " ids" : ""));
        const Snapshot written = awkward(dimensions, ids);
        write_elements(scratch.path(name), "", written);
        expect_same(read_snapshot(scratch.path(name)), written);
      }
    }
  }
}

TEST(WriteElements, AnUnknownSuffixIsRefused) {
  const Scratch scratch;
  const std::string sentence = sentence_of(ErrorCode::wrong_usage, [&] {
    write_elements(scratch.path("a.pdf"), "", awkward(3, false));
  });
  EXPECT_NE(sentence.find("'pdf'"), std::string::npos) << sentence;
}

TEST(WriteElements, NoElements) {
  const Scratch scratch;
  for (const char* name : {"a.csv", "a.dump", "a.xyz"}) {
    write_elements(scratch.path(name), "", Snapshot{});
    EXPECT_EQ(read_snapshot(scratch.path(name)).size(), 0u);
  }
}

TEST(WriteElements, FormatByNameElseBySuffixElseCsv) {
  const Scratch scratch;
  const auto begins = [&](const char* name, const char* format) {
    write_elements(scratch.path(name), format, awkward(3, false));
    return text_of(scratch.path(name)).substr(0, 4);
  };
  EXPECT_EQ(begins("a.csv", "lammps_dump"), "ITEM");
  EXPECT_EQ(begins("a.csv", "xyz"), "500\n");
  EXPECT_EQ(begins("a.dump", "csv"), "x,y,");
  EXPECT_EQ(begins("a", ""), "x,y,");
  sentence_of(ErrorCode::wrong_usage, [&] { begins("b.csv", "vtk"); });
  EXPECT_FALSE(std::filesystem::exists(scratch.path("b.csv")));
}

TEST(WriteElements, RefusesWhatNoReaderAccepts) {
  const Scratch scratch;
  Snapshot snapshot = awkward(3, false);
  snapshot.z[7] = limits::infinity();
  const std::string sentence = sentence_of(
      ErrorCode::invalid_input, [&] { write_elements(scratch.path("a.csv"), "", snapshot); });
  EXPECT_NE(sentence.find("element 7"), std::string::npos);
  EXPECT_EQ(scratch.file_count(), 0u);
}

}  // namespace
}  // namespace abut::io::testing
