#include "scratch.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io::testing {
namespace {

using Groups = std::vector<std::uint32_t>;

ReadOptions grouped_by(std::string_view column) {
  ReadOptions options;
  options.groups = column;
  return options;
}

const std::string dump_top =
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n";
const std::string data_top = "a comment\n2 atoms\n0 4 xlo xhi\n0 4 ylo yhi\n0 4 zlo zhi\n";

TEST(ReadGroups, OfEveryFormat) {
  const Groups expected{7, 4294967295};
  for (const auto& [name, column, text] : std::initializer_list<std::array<std::string, 3>>{
           {"a.csv", "mol", "mol,x,y,radius\n7,0,0,1\n4294967295,0,0,1\n"},
           {"b.csv", "my mol", "x;y;radius;my mol\n0;0;1;\"7\"\n0;0;1;4294967295\n"},
           {"c.csv", "g", "x y r g\n0 0 1 7.0\n0 0 1 4.294967295e9\n"},
           {"d.csv", "g", "g,xmin,ymin,xmax,ymax\n7,0,0,1,1\n4294967295,0,0,1,1\n"},
           {"e.csv", "id", "id,x,y,r\n7,0,0,1\n4294967295,0,0,1\n"},
           {"a.dump", "mol",
            dump_top + "ITEM: ATOMS id mol x y z radius\n1 7 0 0 0 1\n2 4294967295 1 1 1 1\n"},
           {"a.data", "mol",
            data_top + "Atoms # bpm/sphere\n\n1 7 1 1 1 0 0 1\n2 4294967295 2 1 1 0 0 1\n"},
           {"b.data", "type",
            data_top + "Atoms # sphere\n\n1 7 1 1 0 0 1\n2 4294967295 1 1 0 0 1\n"},
           {"a.xyz", "Mol-Id",
            "2\nProperties=pos:R:3:Mol-Id:I:1:radius:R:1\n0 0 0 7 1\n1 1 1 4294967295 1\n"},
           {"b.xyz", "flags:1",
            "2\nProperties=pos:R:3:flags:I:2:radius:R:1\n0 0 0 9 7 1\n1 1 1 9 4294967295 1\n"},
       }) {
    SCOPED_TRACE(name);
    const Snapshot snapshot = read_text(name, text, grouped_by(column));
    EXPECT_EQ(snapshot.groups, expected);
    EXPECT_EQ(snapshot.size(), 2U);
    EXPECT_TRUE(read_text(name, text).groups.empty()) << "only where they are asked for";
  }
}

TEST(ReadGroups, DataWithoutAStyleNamesTypesOnlyWhereNothingElseCanStandThere) {
  ReadOptions options = grouped_by("type");
  options.radius = 1.0;
  EXPECT_EQ(read_text("a.data", data_top + "Atoms\n\n1 3 0 0 1\n2 4 1 1 1\n", options).groups,
            (Groups{3, 4}));
  const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
    static_cast<void>(
        read_text("a.data", data_top + "Atoms\n\n1 9 3 0 0 1\n2 9 4 1 1 1\n", options));
  });
  EXPECT_NE(sentence.find("no column 'type'"), std::string::npos) << sentence;
}

TEST(ReadGroups, ErrorsNameLineColumnAndValue) {
  const auto error_of = [](std::string_view column, std::string_view text) {
    const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
      static_cast<void>(read_text("a.csv", text, grouped_by(column)));
    });
    const std::size_t name = sentence.find("a.csv");
    return name == std::string::npos ? sentence : sentence.substr(name);
  };
  EXPECT_EQ(error_of("mol", "x,y,r\n0,0,1\n"),
            "a.csv, line 1: there is no column 'mol' to take groups from (the columns are 'x' 'y' "
            "'r'); name one that is there");
  EXPECT_EQ(error_of("mol", "mol,x,y,r,mol\n"),
            "a.csv, line 1: column 'mol' is there twice; rename one of them");
  for (const char* const value : {"-1", "1.5", "4294967296", "A", "", "nan", "1e999"}) {
    const std::string sentence =
        error_of("mol", "mol,x,y,r\n1,0,0,1\n" + std::string(value) + ",0,0,1\n");
    EXPECT_EQ(sentence.find("a.csv, line 3, column 'mol': '" + std::string(value) +
                            "' is no group, which is a whole number from 0 to 4294967295"),
              0U)
        << sentence;
  }
}

TEST(ReadGroups, ColumnsOfWholeNumbersAreTold) {
  ReadOptions options;
  options.group_columns = GroupColumns::sought;
  EXPECT_EQ(read_text("a.csv", "type,x,y,r,mol,name,v,late\n1,0,0,1,5,A,0.5,1\n2,0,0,1,6,B,1,-1\n",
                      options)
                .group_columns,
            (std::vector<std::string>{"type", "mol"}));
  EXPECT_TRUE(read_text("a.csv", "x,y,r,id\n0,0,1,5\n", options).group_columns.empty());
  EXPECT_TRUE(read_text("a.csv", "type,x,y,r\n1,0,0,1\n").group_columns.empty());
}

TEST(ReadGroups, AFileThatNamesRadiiKeepsThemWhereOthersTakeOne) {
  ReadOptions options = with_radius(5.0);
  options.radius_use = RadiusUse::where_none_is_named;
  const Snapshot own = read_text("a.csv", "x,y,diameter\n0,0,1\n", options);
  EXPECT_EQ(own.radius, Numbers{0.5});
  EXPECT_FALSE(own.radius_is_common);
  const Snapshot none = read_text("a.csv", "x,y\n0,0\n", options);
  EXPECT_EQ(none.radius, Numbers{5.0});
  EXPECT_TRUE(none.radius_is_common);
  const Snapshot boxes = read_text("a.csv", "xmin,ymin,xmax,ymax\n0,0,1,1\n", options);
  EXPECT_TRUE(boxes.holds_boxes());
  EXPECT_EQ(boxes.radius, Numbers{0.5});
  EXPECT_FALSE(boxes.radius_is_common);
}

TEST(ReadGroups, ALoneFrameStandsForAll) {
  const std::string one = "1\n\nC 1 2 3 1\n";
  const std::string two = one + "1\n\nC 4 5 6 1\n";
  for (const std::int64_t frame : {-7, -1, 0, 1, 5}) {
    ReadOptions options = at_frame(frame);
    options.lone_frame = LoneFrame::always_taken;
    EXPECT_EQ(read_text("a.csv", "x,y,r\n1,2,3\n", options).frame, 0) << frame;
    EXPECT_EQ(read_text("a.csv", "", options).size(), 0U) << frame;
    for (const Snapshot& snapshot : {read_text("a.xyz", one, options), read_piped(one, options)}) {
      EXPECT_EQ(snapshot.x, Numbers{1}) << frame;
      EXPECT_EQ(snapshot.frame, 0);
    }
    if (frame == -7 || frame == 5) {
      sentence_of(ErrorCode::invalid_input,
                  [&] { static_cast<void>(read_text("a.xyz", two, options)); });
      continue;
    }
    for (const Snapshot& snapshot : {read_text("a.xyz", two, options), read_piped(two, options)}) {
      EXPECT_EQ(snapshot.x, Numbers{frame == 0 ? 1.0 : 4.0}) << frame;
    }
  }
}

}  // namespace
}  // namespace abut::io::testing
