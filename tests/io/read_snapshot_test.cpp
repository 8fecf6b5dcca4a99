#include "scratch.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace abut::io::testing {
namespace {

TEST(ReadSnapshot, FormatsHaveDifferentNamesAndSuffixes) {
  std::string suffixes;
  for (const FormatInfo& format : readable_formats()) {
    EXPECT_FALSE(format.holds.empty());
    suffixes += std::string(format.suffixes) + " ";
  }
  EXPECT_EQ(suffixes, ".csv .tsv .txt .dump .lammpstrj .lammps .data .lmp .xyz .extxyz ");
}

TEST(ReadSnapshot, NamedFormatWinsOverTheSuffix) {
  ReadOptions options;
  for (const char* name : {"xyz", "extxyz"}) {
    options.format = name;
    EXPECT_EQ(read_text("a.csv", "1\n\nC 1 2 3 4\n", options).format, "xyz");
  }
  options.format = "vtk";
  const std::string sentence = sentence_of(
      ErrorCode::wrong_usage, [&] { static_cast<void>(read_text("a.csv", "x,y,r\n", options)); });
  EXPECT_NE(sentence.find("'vtk'"), std::string::npos);
  EXPECT_NE(sentence.find("csv lammps_dump lammps_data xyz"), std::string::npos);
}

TEST(ReadSnapshot, ContentDecidesWhereTheSuffixSaysNothing) {
  EXPECT_EQ(read_text("a", "\n 1 \n\nC 1 2 3 4\n").format, "xyz");
  EXPECT_EQ(read_text("a.7", "x,y,r\n").format, "csv");
  EXPECT_EQ(read_text(".csv", "0\n").format, "xyz") << "a name that begins with its dot";
}

TEST(ReadSnapshot, RadiusForAllMustBeARadius) {
  for (const double radius :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    sentence_of(ErrorCode::wrong_usage,
                [&] { static_cast<void>(read_text("a.csv", "x,y\n", with_radius(radius))); });
  }
}

TEST(ReadSnapshot, AnInputWithoutALineIsAnEmptySystem) {
  for (const char* name : {"a.csv", "a.dump", "a.xyz", "a"}) {
    for (const char* text : {"", "\n\n"}) {
      EXPECT_EQ(read_text(name, text).size(), 0u) << name;
      EXPECT_EQ(read_text(name, text, at_frame(0)).size(), 0u) << name;
      sentence_of(ErrorCode::invalid_input,
                  [&] { static_cast<void>(read_text(name, text, at_frame(1))); });
    }
  }
  EXPECT_EQ(read_text("a.dump", "").format, "lammps_dump");
}

TEST(ReadSnapshot, FramesThatAreNotThere) {
  const std::string_view two = "0\n\n0\n\n";
  for (const std::int64_t frame : {std::int64_t{2}, std::int64_t{-3}, INT64_MIN, INT64_MAX}) {
    const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
      static_cast<void>(read_text("a.xyz", two, at_frame(frame)));
    });
    EXPECT_NE(sentence.find("2 frames, numbers 0 to 1"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(std::to_string(frame)), std::string::npos) << sentence;
  }
  const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
    static_cast<void>(read_text("a.csv", "x,y,r\n", at_frame(1)));
  });
  EXPECT_NE(sentence.find("one frame, number 0"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace abut::io::testing
