#include "scratch.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io::testing {
namespace {

TEST(ReadXyz, PlainWithFifthColumnAsRadius) {
  const std::string_view text = "2\nmade \"by hand, properties unknown\nSi 1 2 3 0.5\n14 4 5 6 1\n";
  for (const Snapshot& snapshot :
       {read_text("a.xyz", text), read_text("a.out", text), read_piped(text)}) {
    EXPECT_EQ(snapshot.format, "xyz");
    EXPECT_EQ(snapshot.x, (Numbers{1, 4}));
    EXPECT_EQ(snapshot.z, (Numbers{3, 6}));
    EXPECT_EQ(snapshot.radius, (Numbers{0.5, 1}));
    EXPECT_EQ(snapshot.periodic, (std::array{false, false, false}));
  }
}

TEST(ReadXyz, PlainWithoutRadius) {
  EXPECT_EQ(read_text("a.xyz", "1\n\nC 1 2 3\n", with_radius(2)).radius, Numbers{2});
  EXPECT_EQ(read_text("a.xyz", "1\n\nC 1 2 3 9 9 9\n", with_radius(2)).radius, Numbers{2});
}

TEST(ReadXyz, PropertiesNameTheColumns) {
  const Snapshot snapshot =
      read_text("a.extxyz",
                "1\nTime=0.5 Properties=species:S:1:velo:R:3:pos:R:3:Diameter:R:1:ids:I:1 "
                "comment=\"a b=c\"\nGe 9 9 9 1 2 3 4 77\n");
  EXPECT_EQ(snapshot.x, Numbers{1});
  EXPECT_EQ(snapshot.y, Numbers{2});
  EXPECT_EQ(snapshot.z, Numbers{3});
  EXPECT_EQ(snapshot.radius, Numbers{2});
  EXPECT_EQ(snapshot.ids, std::vector<std::int64_t>{77});
}

TEST(ReadXyz, PositionsOfTwoNumbersAreDiscs) {
  const Snapshot snapshot = read_text("a.xyz", "1\nProperties=pos:R:2:radius:R:1\n1 2 3\n");
  EXPECT_EQ(snapshot.dimensions, 2);
  EXPECT_EQ(snapshot.radius, Numbers{3});
}

TEST(ReadXyz, PeriodicAxesFromPbcElseFromTheLattice) {
  const auto periodic = [](std::string_view comment) {
    return read_text("a.xyz", "1\n" + std::string(comment) + "\nC 1 2 3 1\n").periodic;
  };
  const std::string lattice = "Lattice=\"9 0 0 0 9 0 0 0 9\" ";
  EXPECT_EQ(periodic(lattice), (std::array{true, true, true}));
  EXPECT_EQ(periodic(lattice + "pbc=\"T T F\""), (std::array{true, true, false}));
  EXPECT_EQ(periodic("PBC='true false 1'"), (std::array{true, false, true}));
  EXPECT_EQ(periodic("pbc=[F, T, F]"), (std::array{false, true, false}));
  EXPECT_EQ(periodic(lattice + "pbc={0 0 0}"), (std::array{false, false, false}));
  EXPECT_EQ(periodic("a comment"), (std::array{false, false, false}));
}

TEST(ReadXyz, TheLatticeIsKeptRowByRow) {
  const auto read = [](std::string_view comment) {
    return read_text("a.xyz", "1\n" + std::string(comment) + "\nC 1 2 3 1\n");
  };
  using Box = std::array<std::array<double, 3>, 3>;
  const Box expected{{{9, 0.5, 0}, {0, 8, 0}, {-1, 0, 7e-1}}};
  EXPECT_EQ(read("Lattice=\"9 .5 0 0 8 0 -1 0 7e-1\"").box, expected);
  EXPECT_EQ(read("lattice='[9, 0.5, 0], [0, 8, 0], [-1, 0, 0.7]' pbc=\"F F F\"").box, expected);
  EXPECT_FALSE(read("pbc=\"T T T\"").box.has_value());
}

TEST(ReadXyz, EveryFrameCanBeAskedFor) {
  const std::string text =
      "1\na\nC 10 0 0 1\n2\nb\nC 11 0 0 1\nC 0 0 0 1\n\n0\nc\n1\nd\nC 13 0 0 1";
  for (const std::int64_t k : {0, 1, 3}) {
    for (const std::int64_t asked : {k, k - 4}) {
      for (const Snapshot& snapshot :
           {read_text("a.xyz", text, at_frame(asked)), read_piped(text, at_frame(asked))}) {
        EXPECT_EQ(snapshot.frame, k);
        EXPECT_EQ(snapshot.frame_count, 4);
        EXPECT_EQ(snapshot.x.at(0), 10.0 + static_cast<double>(k));
      }
    }
  }
  EXPECT_EQ(read_text("a.xyz", text, at_frame(2)).size(), 0u);
  EXPECT_EQ(read_text("a.xyz", "0").size(), 0u);
  EXPECT_EQ(read_text("a.xyz", "0\n\n").size(), 0u);
}

}  // namespace
}  // namespace abut::io::testing
