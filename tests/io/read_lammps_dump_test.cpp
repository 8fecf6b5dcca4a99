#include "scratch.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io::testing {
namespace {

const std::string unit_box = "ITEM: BOX BOUNDS pp ff fm\n0 1\n0 1\n0 1\n";

std::string frame(std::string_view box, std::string_view columns,
                  std::initializer_list<std::string_view> atoms) {
  std::string text = "ITEM: TIMESTEP\n15000\nITEM: NUMBER OF ATOMS\n";
  text += std::to_string(atoms.size()) + "\n";
  text += box;
  text += "ITEM: ATOMS " + std::string(columns) + "\n";
  for (const std::string_view atom : atoms) text += std::string(atom) + "\n";
  return text;
}

TEST(ReadLammpsDump, PlainColumnsIdsAndBoundaries) {
  const std::string text =
      frame(unit_box, "id type radius x y z", {"7 1 0.5 1 2 3 ", "3 1 0.25 4 5 6"});
  for (const Snapshot& snapshot : {read_text("a.dump", text), read_text("a.lammpstrj", text),
                                   read_text("a.gran", text), read_piped(text)}) {
    EXPECT_EQ(snapshot.format, "lammps_dump");
    EXPECT_EQ(snapshot.dimensions, 3);
    EXPECT_EQ(snapshot.x, (Numbers{1, 4}));
    EXPECT_EQ(snapshot.y, (Numbers{2, 5}));
    EXPECT_EQ(snapshot.z, (Numbers{3, 6}));
    EXPECT_EQ(snapshot.radius, (Numbers{0.5, 0.25}));
    EXPECT_EQ(snapshot.ids, (std::vector<std::int64_t>{7, 3}));
    EXPECT_EQ(snapshot.periodic, (std::array{true, false, false}));
  }
}

TEST(ReadLammpsDump, UnwrappedDiameterAndExtraSections) {
  const std::string text =
      "ITEM: UNITS\nlj\nITEM: TIME\n0.5\n" + frame(unit_box, "xu yu zu diameter", {"1 2 3 4"});
  const Snapshot snapshot = read_text("a.dump", text);
  EXPECT_EQ(snapshot.x, Numbers{1});
  EXPECT_EQ(snapshot.radius, Numbers{2});
  EXPECT_TRUE(snapshot.ids.empty());
}

TEST(ReadLammpsDump, WithoutZTwoDimensions) {
  const Snapshot snapshot = read_text("a.dump", frame(unit_box, "x y radius", {"1 2 3"}));
  EXPECT_EQ(snapshot.dimensions, 2);
  EXPECT_TRUE(snapshot.z.empty());
  const std::string plane = "ITEM: BOX BOUNDS ff pp pp\n0 1\n0 1\n-0.5 0.5\n";
  EXPECT_EQ(read_text("a.dump", frame(plane, "x y radius", {"1 2 3"})).periodic,
            (std::array{false, true, false}));
}

TEST(ReadLammpsDump, ScaledCoordinatesAreUndone) {
  const std::string box = "ITEM: BOX BOUNDS pp pp pp\n-2 2\n10 18\n0 0.5\n";
  for (const std::string_view columns : {"xs ys zs radius", "xsu ysu zsu radius"}) {
    const Snapshot snapshot =
        read_text("a.dump", frame(box, columns, {"0 0 0 1", "0.25 0.5 1 1", "1.5 -0.25 2 1"}));
    EXPECT_EQ(snapshot.x, (Numbers{-2, -1, 4}));
    EXPECT_EQ(snapshot.y, (Numbers{10, 14, 8}));
    EXPECT_EQ(snapshot.z, (Numbers{0, 0.5, 1}));
  }
  const Snapshot flat = read_text("a.dump", frame(box, "xs ys radius", {"0.25 0.5 1"}));
  EXPECT_EQ(flat.x, Numbers{-1});
  EXPECT_EQ(flat.y, Numbers{14});
}

using Box = std::array<std::array<double, 3>, 3>;

/// Edges a = (4, 0, 0), b = (xy, 2, 0), c = (xz, yz, 1) at the corner (1, 2, 3); the bounds are
/// worked out by hand from the eight corners.
TEST(ReadLammpsDump, TiltsOfATriclinicBoxAreUndone) {
  struct Case {
    const char* bounds;
    double xy, xz, yz;
  };
  for (const Case& c : {Case{"1 6.5 1\n2 4.5 0.5\n3 4 0.5\n", 1, 0.5, 0.5},
                        Case{"-0.5 5 -1\n1.5 4 -0.5\n3 4 -0.5\n", -1, -0.5, -0.5},
                        Case{"0.5 6 1\n2 4.25 -0.5\n3 4 0.25\n", 1, -0.5, 0.25}}) {
    const std::string box = std::string("ITEM: BOX BOUNDS xy xz yz ff pp ff\n") + c.bounds;
    const Snapshot snapshot =
        read_text("a.dump", frame(box, "xs ys zs radius",
                                  {"0 0 0 1", "1 0 0 1", "0 1 0 1", "0 0 1 1", "0.5 0.5 0.5 1"}));
    SCOPED_TRACE(c.bounds);
    EXPECT_EQ(snapshot.x, (Numbers{1, 5, 1 + c.xy, 1 + c.xz, 3 + (c.xy + c.xz) / 2}));
    EXPECT_EQ(snapshot.y, (Numbers{2, 2, 4, 2 + c.yz, 3 + c.yz / 2}));
    EXPECT_EQ(snapshot.z, (Numbers{3, 3, 3, 4, 3.5}));
    EXPECT_EQ(snapshot.periodic, (std::array{false, true, false}));
    EXPECT_EQ(snapshot.box, (Box{{{4, 0, 0}, {c.xy, 2, 0}, {c.xz, c.yz, 1}}}));
  }
}

TEST(ReadLammpsDump, GeneralTriclinicBoxWithPlainCoordinates) {
  const std::string box = "ITEM: BOX BOUNDS abc origin pp pp ff\n1 2 3 7\n0 1 0 8\n0 0.5 1 9\n";
  const Snapshot snapshot = read_text("a.dump", frame(box, "x y z radius", {"1 2 3 4"}));
  EXPECT_EQ(snapshot.z, Numbers{3});
  EXPECT_EQ(snapshot.periodic, (std::array{true, true, false}));
  EXPECT_EQ(snapshot.box, (Box{{{1, 2, 3}, {0, 1, 0}, {0, 0.5, 1}}}));
}

TEST(ReadLammpsDump, EveryFrameCanBeAskedFor) {
  std::string text;
  for (const std::string_view x : {"10 0 0 1", "11 0 0 1", "12 0 0 1"}) {
    text += frame(unit_box, "x y z radius", {x});
  }
  text += frame(unit_box, "x y z radius", {});
  const auto check = [](const Snapshot& snapshot, std::int64_t number) {
    EXPECT_EQ(snapshot.frame, number);
    EXPECT_EQ(snapshot.frame_count, 4);
    EXPECT_EQ(snapshot.x, number == 3 ? Numbers{} : Numbers{10.0 + static_cast<double>(number)});
  };
  for (std::int64_t k = 0; k < 4; ++k) {
    for (const std::int64_t asked : {k, k - 4}) {
      check(read_text("a.dump", text, at_frame(asked)), k);
      check(read_piped(text, at_frame(asked)), k);
    }
  }
  check(read_text("a.dump", text), 3);
  check(read_piped(text + "\n\n"), 3);
}

TEST(ReadLammpsDump, AFrameWithoutAtomsIsAnEmptySystem) {
  EXPECT_EQ(read_text("a.dump", frame(unit_box, "id x y z", {})).size(), 0u);
  EXPECT_EQ(read_text("a.dump", frame(unit_box, "x y", {})).dimensions, 2);
  EXPECT_EQ(read_text("a.dump", frame(unit_box, "", {})).dimensions, 3);
}

/// A run that is still writing, or was killed: what is complete can be read.
TEST(ReadLammpsDump, FramesBeforeATruncatedOneCanBeRead) {
  const std::string whole = frame(unit_box, "x y z radius", {"1 2 3 4", "5 6 7 8"});
  const std::string text = whole + whole.substr(0, whole.size() - 5);
  EXPECT_EQ(read_text("a.dump", text, at_frame(0)).size(), 2u);
  EXPECT_EQ(read_text("a.dump", text, at_frame(-2)).size(), 2u);
  EXPECT_EQ(read_piped(text, at_frame(-2)).size(), 2u);
  EXPECT_THROW(static_cast<void>(read_text("a.dump", text)), Error);
}

/// Whether the frame itself is asked for or one behind it.
TEST(ReadLammpsDump, AFrameWithTooFewAtomsIsTold) {
  const std::string whole = frame(unit_box, "x y z radius", {"1 2 3 4", "5 6 7 8"});
  const std::string text = whole.substr(0, whole.find("5 6 7 8")) + whole;
  for (const std::int64_t asked : {0, 1, -1}) {
    const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
      static_cast<void>(read_text("a.dump", text, at_frame(asked)));
    });
    EXPECT_NE(sentence.find("a section begins after 1 of the 2 atoms"), std::string::npos)
        << sentence;
  }
}

TEST(ReadLammpsDump, RealPour) {
  const std::string path = ABUT_EXAMPLE_DATA "/lammps_pour.dump";
  const Snapshot snapshot = read_snapshot(path);
  ASSERT_EQ(snapshot.size(), 2500u);
  EXPECT_EQ(snapshot.ids.size(), 2500u);
  EXPECT_EQ(snapshot.radius[0], 0.59588254983345168);
  EXPECT_EQ(snapshot.x[0], -1.7448150626538756);
  EXPECT_EQ(snapshot.periodic, (std::array{true, true, false}));
  EXPECT_EQ(snapshot.frame, 1);
  EXPECT_EQ(snapshot.frame_count, 2);
  EXPECT_EQ(read_snapshot(path, at_frame(0)).size(), 0u);
  EXPECT_EQ(read_piped(text_of(path)).x, snapshot.x);
}

}  // namespace
}  // namespace abut::io::testing
