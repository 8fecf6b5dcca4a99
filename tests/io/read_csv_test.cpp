#include "scratch.hpp"

#include <abut/detect.hpp>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io::testing {
namespace {

void expect_two_discs(const Snapshot& snapshot) {
  EXPECT_EQ(snapshot.format, "csv");
  EXPECT_EQ(snapshot.dimensions, 2);
  EXPECT_EQ(snapshot.x, (Numbers{0.5, -1e-3}));
  EXPECT_EQ(snapshot.y, (Numbers{2.0, 4.0}));
  EXPECT_TRUE(snapshot.z.empty());
  EXPECT_EQ(snapshot.radius, (Numbers{0.25, 0.0}));
}

TEST(ReadCsv, ColumnsInAnyOrderOthersIgnored) {
  const Snapshot snapshot =
      read_text("a.csv", "name,radius,z,velocity,y,x\nsand,0.5,3,nan,2,1\n\"a, b\",1,-6,,-5,-4\n");
  EXPECT_EQ(snapshot.dimensions, 3);
  EXPECT_EQ(snapshot.x, (Numbers{1, -4}));
  EXPECT_EQ(snapshot.y, (Numbers{2, -5}));
  EXPECT_EQ(snapshot.z, (Numbers{3, -6}));
  EXPECT_EQ(snapshot.radius, (Numbers{0.5, 1}));
  EXPECT_TRUE(snapshot.ids.empty());
  EXPECT_EQ(snapshot.frame, 0);
  EXPECT_EQ(snapshot.frame_count, 1);
  EXPECT_EQ(snapshot.periodic, (std::array{false, false, false}));
}

/// In columns that nobody reads; a quote within quotes is written twice.
TEST(ReadCsv, QuotedFieldsHoldSeparatorsAndQuotes) {
  const Snapshot snapshot = read_text(
      "a.csv", "x,note,y,radius\n1,\"a, \"\"b\"\", c\",2,3\n4,\"\"\"\",5,6\n7,\"\",8,9\n");
  EXPECT_EQ(snapshot.x, (Numbers{1, 4, 7}));
  EXPECT_EQ(snapshot.y, (Numbers{2, 5, 8}));
  EXPECT_EQ(snapshot.radius, (Numbers{3, 6, 9}));
}

ReadOptions with_columns(std::vector<std::string> names) {
  ReadOptions options;
  options.columns = std::move(names);
  return options;
}

TEST(ReadCsv, NamesOfColumnsFromTheCaller) {
  const ReadOptions options = with_columns({"", "y", "radius", "x"});
  for (const std::string_view text : {
           "7,2,0.25,0.5\n7,4,0,-1e-3\n",
           "# x,y,z,radius\n7 2 0.25 0.5\n7 4 0 -1e-3\n",
           "a;b;c;d\n7;2;0.25;0.5\n7;4;0;-1e-3\n",
           "Ar 2 0.25 0.5\nAr 4 0 -1e-3\n",
       }) {
    SCOPED_TRACE(text);
    expect_two_discs(read_text("a.csv", text, options));
    expect_two_discs(read_text("a.dat", text, options));
  }
  EXPECT_EQ(read_text("a.csv", "# nothing\n", options).size(), 0);
  EXPECT_EQ(sentence_of(
                ErrorCode::invalid_input,
                [&] {
                  static_cast<void>(read_text("a.csv", "1 2 3\n", options));
                }).find("3 fields, but there are 4 columns") == std::string::npos,
            false);
  const std::string other = sentence_of(ErrorCode::wrong_usage, [&] {
    static_cast<void>(read_text("a.xyz", "1\n\nX 0 0 0 1\n", options));
  });
  EXPECT_NE(other.find("--format csv"), std::string::npos) << other;
}

/// Three axes of each kind: none is lost for its capitals.
TEST(ReadCsv, AxesOfOtherNames) {
  for (const std::string_view header :
       {"X,Y,Z,Radius", "x,y,Z,radius", "Points:0,Points:1,Points:2,r",
        "XMIN,YMIN,Zmin,Xmax,Ymax,Zmax"}) {
    SCOPED_TRACE(header);
    EXPECT_EQ(read_text("a.csv", std::string(header) + "\n").dimensions, 3);
  }
}

TEST(ReadCsv, FormsOfTheSameTable) {
  for (const std::string_view text : {
           "# x,y,radius\n0.5,2,0.25\n-1e-3,4,0\n",  // numpy.savetxt
           "# x,y,radius\n5.0e-01 2.0e+00 2.5e-01\n-1e-3 4 0\n",
           "# a run\n#x\ty\tr\n# of sand, x and y in m\n0.5\t2\t0.25\n-1e-3\t4\t0\n",
           "#format x_y_r\n0.5\t2\t0.25\n-1e-3\t4\t0\n",  // YADE
           "X,Y,Radius\n0.5,2,0.25\n-1e-3,4,0\n",
           "X,y,R,x\n9,2,0.25,0.5\n9,4,0,-1e-3\n",  // the same capitals come first
           "\"Points:0\",\"Points:1\",\"radius\"\n0.5,2,0.25\n-1e-3,4,0\n",  // ParaView
           "Points_0,Points_1,Diameter\n0.5,2,0.5\n-1e-3,4,0\n",
           "x,y,radius\n0.5,2,0.25\n-1e-3,4,0\n",
           "x,y,r\r\n0.5,2,0.25\r\n-1e-3,4,0\r\n",           // CR LF
           "x,y,diameter\n0.5,2,0.5\n-1e-3,4,0",             // no last line end
           "\xEF\xBB\xBFx;y;radius\n0.5;2;0.25\n-1e-3;4;0",  // byte order mark
           "x\ty\tradius\n0.5\t2\t0.25\n-1e-3\t4\t0\n\n \n\t\n",
           "  x , y,\tradius \n +0.5 ,+2, 0.25\n\n# half\n -0.001 , 4.0e0 ,0\n",
           "# made by hand\n  # twice\nx y radius\n0.5 2 0.25\n -1E-03  4\t0 \n",
           "\"x\",\"y\",\"radius\"\n\"0.5\",2,\"0.25\"\n-1e-3, \"4\" ,0\n",
           "x,y,radius,\n0.5,2,0.25,\n-1e-3,4,0,\n",
           "x,y,radius,r,diameter\n0.5,2,0.25,9,9\n-1e-3,4,0,9,9\n",
       }) {
    SCOPED_TRACE(text);
    expect_two_discs(read_text("a.csv", text));
    expect_two_discs(read_text("a.tsv", text));
    expect_two_discs(read_text("a.TXT", text));
    expect_two_discs(read_piped(text));
    ReadOptions named;
    named.format = "csv";
    expect_two_discs(read_text("a.xyz", text, named));
  }
}

TEST(ReadCsv, Boxes) {
  const Snapshot boxes =
      read_text("a.csv", "id,xmin,ymin,zmin,xmax,ymax,zmax\n7,0,0,0,1,2,3\n8,-1,0.1,3,0,0.1,4\n");
  EXPECT_EQ(boxes.dimensions, 3);
  EXPECT_TRUE(boxes.holds_boxes());
  EXPECT_EQ(boxes.size(), 2U);
  EXPECT_EQ(boxes.lower, (std::array<Numbers, 3>{{{0, -1}, {0, 0.1}, {0, 3}}}));
  EXPECT_EQ(boxes.upper, (std::array<Numbers, 3>{{{1, 0}, {2, 0.1}, {3, 4}}}));
  EXPECT_EQ(boxes.z, (Numbers{1.5, 3.5}));
  EXPECT_EQ(boxes.radius, (Numbers{1.5, 0.5}));
  EXPECT_EQ(boxes.ids, (std::vector<std::int64_t>{7, 8}));
  EXPECT_EQ(find_contact_pairs(boxes.elements()).size(), 1U);

  const Snapshot flat = read_text("a.csv", "ymax,xmax,ymin,xmin\n4,3,2,1\n");
  EXPECT_EQ(flat.dimensions, 2);
  EXPECT_EQ(flat.elements().shape(), Shape::box);
  EXPECT_EQ(flat.upper[1], (Numbers{4}));
  const Snapshot discs = read_text("a.csv", "xmin,x,y,radius\n4,3,2,1\n");
  EXPECT_FALSE(discs.holds_boxes()) << "where there are centers, other columns are ignored";
}

TEST(ReadCsv, OneRadiusForAllWinsOverTheFilesOwn) {
  for (const std::string_view text : {"x,y\n0,0\n1,1\n", "x,y,radius\n0,0,abc\n1,1,-7\n"}) {
    EXPECT_EQ(read_text("a.csv", text, with_radius(0.75)).radius, (Numbers{0.75, 0.75}));
  }
}

TEST(ReadCsv, HeaderAloneIsAnEmptySystem) {
  EXPECT_EQ(read_text("a.csv", "x,y,z,radius\n").size(), 0u);
  EXPECT_EQ(read_piped("x,y,z,radius").dimensions, 3);
  EXPECT_EQ(read_text("a.csv", "x,y,radius").dimensions, 2);
}

TEST(ReadCsv, IdsAreKeptIfTheyAreWholeNumbers) {
  const std::string header = "id,x,y,r\n";
  EXPECT_EQ(read_text("a.csv", header + "9,0,0,1\n-4,0,0,1\n").ids,
            (std::vector<std::int64_t>{9, -4}));
  EXPECT_TRUE(read_text("a.csv", header + "9,0,0,1\nb7,0,0,1\n5,0,0,1\n").ids.empty());
}

TEST(ReadCsv, TheOnlyFrameIsTheLastAndTheFirst) {
  const std::string_view text = "x,y,r\n1,2,3\n";
  EXPECT_EQ(read_text("a.csv", text, at_frame(0)).size(), 1u);
  EXPECT_EQ(read_text("a.csv", text, at_frame(-1)).size(), 1u);
}

TEST(ReadCsv, NoLocaleChangesTheNumbers) {
  const char* const before = std::setlocale(LC_ALL, nullptr);
  const std::string kept = before == nullptr ? "C" : before;
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // without effect where it is not installed
  const Snapshot snapshot = read_text("a.csv", "x,y,r\n1.5,2,3\n");
  std::setlocale(LC_ALL, kept.c_str());
  EXPECT_EQ(snapshot.x, Numbers{1.5});
}

TEST(ReadCsv, RealPacking) {
  const Snapshot snapshot = read_snapshot(ABUT_EXAMPLE_DATA "/yade_settled_5000.csv");
  ASSERT_EQ(snapshot.size(), 5000u);
  EXPECT_EQ(snapshot.x[0], 0.22821384051467988);
  EXPECT_EQ(snapshot.radius[1], 0.044193881223755248);
  EXPECT_EQ(snapshot.source, ABUT_EXAMPLE_DATA "/yade_settled_5000.csv");
}

}  // namespace
}  // namespace abut::io::testing
