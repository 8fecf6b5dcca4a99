#include "scratch.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace abut::io::testing {
namespace {

using namespace std::string_literals;

/// A text that no reader may accept, with the line it must name (0: none, the whole file is meant)
/// and words that its sentence must hold: column, value, what to do.
struct Malformed {
  const char* what;
  const char* suffix;
  std::string text;
  int line;
  std::initializer_list<const char*> words;
};

const std::string dump_top = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\n";
const std::string dump_box = "ITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n";
const std::string dump_head = dump_top + dump_box + "ITEM: ATOMS id x y z radius\n";

std::string dump_counting(const std::string& count) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n" + count + "\n" + dump_box +
         "ITEM: ATOMS id x y z radius\n1 0 0 0 1\n";
}

std::string csv(const std::string& row) {
  return "x,y,radius\n0,0,1\n" + row + "\n2,0,1\n";
}

const Malformed malformed_csv[] = {
    {"only comments", ".csv", "\n \n#\n", 0, {"is empty", "x,y,z,radius"}},
    {"no header",
     ".csv",
     "1,2,3\n4,5,6\n",
     1,
     {"header", "'1' is a number", "3 columns", "--columns x,y,z,radius"}},
    {"no x", ".csv", "a,y,radius\n", 1, {"column x is missing", "'a' 'y' 'radius'"}},
    {"no y", ".csv", "# c\nx,z,radius\n", 2, {"column y is missing"}},
    {"no radius", ".csv", "x,y\n1,2\n", 1, {"no column radius", "--radius"}},
    {"x twice", ".csv", "x,y,x,radius\n", 1, {"column 'x' is there twice"}},
    {"box without an end", ".csv", "xmin,ymin,xmax\n", 1, {"column ymax is missing", "'xmax'"}},
    {"box without depth", ".csv", "xmin,ymin,zmin,xmax,ymax\n", 1, {"column zmax is missing"}},
    {"box end twice", ".csv", "xmin,ymin,xmax,xmax,ymax\n", 1, {"'xmax' is there twice"}},
    {"box inside out",
     ".csv",
     "xmin,ymin,xmax,ymax\n0,0,1,1\n0,2,1,1.5\n",
     3,
     {"ymin = 2 above ymax = 1.5", "exchange"}},
    {"radius twice", ".csv", "x,y,radius,radius\n", 1, {"'radius' is there twice"}},
    {"word", ".csv", csv("1,abc,1"), 3, {"column 'y'", "'abc' is not a number"}},
    {"missing value", ".csv", csv("1,,1"), 3, {"column 'y'", "missing"}},
    {"blank value", ".csv", csv("1, ,1"), 3, {"column 'y'", "missing"}},
    {"rest behind", ".csv", csv("1,2.5m,1"), 3, {"'2.5m' is not a number"}},
    {"decimal comma", ".csv", "x;y;radius\n1,5;2;3\n", 2, {"column 'x'", "'1,5'"}},
    {"two signs", ".csv", csv("+-1,0,1"), 3, {"'+-1' is not a number"}},
    {"sign alone", ".csv", csv("+,0,1"), 3, {"'+' is not a number"}},
    {"hexadecimal", ".csv", csv("0x1p3,0,1"), 3, {"'0x1p3' is not a number"}},
    {"nan", ".csv", csv("nan,0,1"), 3, {"column 'x'", "'nan' is not a finite number"}},
    {"minus infinity", ".csv", csv("0,-inf,1"), 3, {"'-inf' is not a finite number"}},
    {"infinite radius", ".csv", csv("0,0,Infinity"), 3, {"column 'radius'", "'Infinity'"}},
    {"overflow", ".csv", csv("1e999,0,1"), 3, {"'1e999' is too large"}},
    {"overflow without exponent", ".csv", csv(std::string(400, '9') + ",0,1"), 3, {"too large"}},
    {"overflow of the exponent", ".csv", csv("-1e99999999999999999999,0,1"), 3, {"too large"}},
    {"negative radius", ".csv", csv("0,0,-1e-300"), 3, {"'radius'", "'-1e-300' is negative"}},
    {"negative diameter", ".csv", "x,y,diameter\n0,0,-1\n", 2, {"'diameter'", "negative"}},
    {"few fields", ".csv", csv("1,2"), 3, {"2 fields", "3 columns"}},
    {"many fields", ".csv", csv("1,2,3,4"), 3, {"4 fields", "3 columns"}},
    {"NUL", ".csv", csv("1,\0002,3"s), 3, {"NUL byte"}},
    {"NUL in the header", ".csv", "x,y\0,radius\n"s, 1, {"NUL byte"}},
    {"open quote", ".csv", csv("1,\"2,3"), 3, {"'\"2,3' is not a number"}},
    {"text behind a quote", ".csv", csv("1,\"2\"3,1"), 3, {"'\"2\"3' is not a number"}},
    {"control bytes shown", ".csv", csv("1,\x1b[2J\xff,1"), 3, {"'\\x1b[2J\\xff'"}},
    {"long value cut", ".csv", csv("1," + std::string(99, 'q') + ",1"), 3, {"qqq...'"}},
    {"long line", ".csv", csv(std::string(3 << 20, '1')), 3, {"longer than 1 MiB"}},
    {"long line without end", ".csv", "x,y,r\n" + std::string(2 << 20, '1'), 2, {"1 MiB"}},
    {"open quote in a column left out", ".csv", "x,y,r,n\n0,0,1,\"a\n1,1,1,b\"\n", 2, {"quote"}},
    {"open quote in the header", ".csv", "x,y,radius,\"n\n0,0,1,2\n", 1, {"quote"}},
    {"lines of an old Macintosh", ".csv", "x,y,radius,n\r0,0,1,2\r", 1, {"carriage return"}},
    {"the same with blanks", ".csv", "x y radius\r0 0 1\r", 1, {"carriage return"}},
    {"Z twice", ".csv", "x,y,Z,Z,radius\n", 1, {"column 'z' is there twice but for capitals"}},
    {"a capital ZMIN alone", ".csv", "xmin,ymin,xmax,ymax,ZMIN\n", 1, {"column zmax is missing"}},
    {"red", ".csv", "x,y,z,r,g,b\n", 1, {"no column radius", "'g' 'b'"}},
    {"names of another number", ".csv", "# x,y,radius\n1,2,3,4\n", 2, {"'1' is a number", "4 col"}},
    {"a second header", ".csv", csv("x,y,radius"), 3, {"'x' is not a number"}},
    {"two byte order marks", ".csv", "\xEF\xBB\xBF\xEF\xBB\xBFx,y,r\n", 1, {"'\\u{feff}x'"}},
    {"end of file of DOS", ".csv", csv("\x1A"), 3, {"\\x1a"}},
    {"UTF-16", ".csv", "\xFF\xFEx\0,\0"s, 0, {"UTF-16", "UTF-8"}},
    {"gzip", ".csv", "\x1F\x8B\x08\x00 and so on"s, 0, {"compressed", "gzip -dc"}},
};

const Malformed malformed_dump[] = {
    {"no section", ".dump", "x,y,radius\n", 1, {"'x,y,radius' is not a section"}},
    {"other section", ".dump", "ITEM: TIMESTEP\n0\nITEM: ENTRIES a\n", 3, {"'ITEM: ENTRIES a'"}},
    {"ends in the header", ".dump", "ITEM: TIMESTEP\n0\n", 0, {"cut off"}},
    {"ends at a title", ".dump", "ITEM: TIMESTEP\n", 0, {"cut off"}},
    {"ends in the box", ".dump", dump_top + "ITEM: BOX BOUNDS\n0 1\n", 0, {"cut off"}},
    {"no count", ".dump", dump_box + "ITEM: ATOMS x y radius\n", 5, {"ITEM: NUMBER OF ATOMS"}},
    {"no box", ".dump", dump_top + "ITEM: ATOMS x y radius\n0 0 1\n", 5, {"ITEM: BOX BOUNDS"}},
    {"negative count", ".dump", dump_counting("-1"), 4, {"'-1'", "whole number from 0"}},
    {"count not whole", ".dump", dump_counting("1.5"), 4, {"'1.5'"}},
    {"count a word", ".dump", dump_counting("many"), 4, {"'many'"}},
    {"no number there", ".dump", dump_counting("1 2"), 4, {"not one number"}},
    {"count beyond 64 bits", ".dump", dump_counting("99999999999999999999"), 4, {"whole number"}},
    {"huge count", ".dump", dump_counting("9000000000000000000"), 9, {"announced", "cut off"}},
    {"count too large", ".dump", dump_counting("3"), 9, {"3 elements", "at most 1"}},
    {"atoms missing", ".dump", dump_counting("2") + "\n", 9, {"2 elements", "at most 1"}},
    {"atoms blank", ".dump", dump_counting("2") + std::string(40, '\n'), 11, {"0 fields"}},
    {"count too small", ".dump", dump_counting("0"), 10, {"is not a section"}},
    {"next frame too early",
     ".dump",
     dump_counting("2") + dump_head + "1 0 0 0 1\n",
     11,
     {"a section begins after 1 of the 2 atoms"}},
    {"words behind a section", ".dump", "ITEM: TIMESTEP now\n0\n", 1, {"has words behind"}},
    {"count beside its title", ".dump", "ITEM: NUMBER OF ATOMS 1\n", 1, {"has words behind"}},
    {"time missing", ".dump", "ITEM: TIMESTEP\nITEM: NUMBER OF ATOMS\n1\n", 2, {"one number"}},
    {"time a word", ".dump", "ITEM: TIMESTEP\nnoon\n", 2, {"'noon' is not a number"}},
    {"time not finite", ".dump", "ITEM: TIME\nnan\n", 2, {"'nan'"}},
    {"count twice", ".dump", dump_top + "ITEM: NUMBER OF ATOMS\n2\n", 5, {"comes twice"}},
    {"box twice", ".dump", dump_top + dump_box + dump_box, 9, {"BOX BOUNDS' comes twice"}},
    {"atoms of a frame missing", ".dump", dump_top + dump_box + dump_head, 9, {"comes twice"}},
    {"frame in a frame that is passed over",
     ".dump",
     dump_counting("13") + dump_head + "1 0 0 0 1\n" + dump_head + "1 0 0 0 1\n",
     11,
     {"after 1 of the 13"}},
    {"boundary of a word", ".dump", dump_top + "ITEM: BOX BOUNDS p p p\n", 5, {"boundaries"}},
    {"half periodic", ".dump", dump_top + "ITEM: BOX BOUNDS pp pf pp\n", 5, {"boundaries"}},
    {"tilts of other names", ".dump", dump_top + "ITEM: BOX BOUNDS xy yz xz pp pp pp\n", 5, {"xy"}},
    {"box of words", ".dump", dump_top + "ITEM: BOX BOUNDS\n0 big\n", 6, {"'big'"}},
    {"box not finite", ".dump", dump_top + "ITEM: BOX BOUNDS\n0 inf\n", 6, {"'inf'"}},
    {"box of one number", ".dump", dump_top + "ITEM: BOX BOUNDS\n0\n", 6, {"1 field", "has 2"}},
    {"box inverted", ".dump", dump_top + "ITEM: BOX BOUNDS\n0 1\n0 1\n2 1\n", 8, {"axis z"}},
    {"two boundaries", ".dump", dump_top + "ITEM: BOX BOUNDS pp pp\n0 1\n", 5, {"boundaries"}},
    {"no columns", ".dump", dump_top + dump_box + "ITEM: ATOMS\n0 0 1\n", 9, {"x is missing"}},
    {"x without y",
     ".dump",
     dump_top + dump_box + "ITEM: ATOMS x ys zs radius\n0 0 0 1\n",
     9,
     {"y is missing"}},
    {"mixed axes",
     ".dump",
     dump_top + dump_box + "ITEM: ATOMS x y zs radius\n0 0 0 1\n",
     9,
     {"without z", "zs"}},
    {"no radius",
     ".dump",
     dump_top + dump_box + "ITEM: ATOMS id x y z\n1 0 0 0\n",
     9,
     {"--radius"}},
    {"bad id", ".dump", dump_head + "1.5 0 0 0 1\n", 10, {"column 'id'", "'1.5'"}},
    {"bad value", ".dump", dump_head + "1 0 0 zero 1\n", 10, {"column 'z'", "'zero'"}},
    {"negative radius", ".dump", dump_head + "1 0 0 0 -1\n", 10, {"'radius'", "negative"}},
    {"few fields", ".dump", dump_head + "1 0 0 0 \n", 10, {"4 fields", "5 columns"}},
    {"many fields", ".dump", dump_head + "1 0 0 0 1 9\n", 10, {"6 fields", "5 columns"}},
    {"scaled overflow",
     ".dump",
     dump_top + "ITEM: BOX BOUNDS\n-1e308 1e308\n0 1\n0 1\nITEM: ATOMS xs ys zs radius\n2 0 0 1\n",
     10,
     {"beyond the range"}},
    {"scaled, general box",
     ".dump",
     dump_top + "ITEM: BOX BOUNDS abc origin\n1 0 0 0\n0 1 0 0\n0 0 1 0\nITEM: ATOMS xs ys radius\n"
                "2 0 1\n",
     9,
     {"general triclinic", "x y z"}},
};

const Malformed malformed_xyz[] = {
    {"no count", ".xyz", "C 0 0 0 1\n", 1, {"number of its elements"}},
    {"count a word", ".xyz", "one\nc\nC 0 0 0 1\n", 1, {"'one'", "whole number"}},
    {"negative count", ".xyz", "-3\nc\n", 1, {"'-3'"}},
    {"huge count", ".xyz", "9223372036854775807\nc\nC 0 0 0 1\n", 2, {"announced"}},
    {"count too large", ".xyz", "2\nc\nC 0 0 0 1\n", 2, {"announced"}},
    {"count too small", ".xyz", "1\nc\nC 0 0 0 1\nC 0 0 0 1\n", 4, {"number of its elements"}},
    {"no comment", ".xyz", "1", 0, {"ends after 0 of the 1"}},
    {"no element", ".xyz", "1\nc\n", 0, {"ends after 0 of the 1"}},
    {"few fields", ".xyz", "1\nc\nC 0.00 0.00\n", 3, {"--radius"}},
    {"few fields later", ".xyz", "2\nc\nC 0 0 0 1\nC 0.0 0.0 0.0\n", 4, {"4 fields", "5"}},
    {"no radius", ".xyz", "1\nc\nC 0 0 0\n", 3, {"--radius"}},
    {"which radius", ".xyz", "1\nc\nC 0 0 0 1 2 3\n", 3, {"--radius", "'column 5'"}},
    {"bad value", ".xyz", "1\nc\nC 0 nan 0 1\n", 3, {"column 'y'", "'nan'"}},
    {"pbc of two", ".xyz", "1\npbc=\"T T\"\nC 0 0 0 1\n", 2, {"pbc 'T T'"}},
    {"pbc of words", ".xyz", "1\npbc=\"T T maybe\"\nC 0 0 0 1\n", 2, {"pbc"}},
    {"lattice of eight",
     ".xyz",
     "1\nLattice=\"9 0 0 0 9 0 0 0\"\nC 0 0 0 1\n",
     2,
     {"Lattice '9 0 0 0 9 0 0 0'", "nine"}},
    {"lattice of a word",
     ".xyz",
     "1\nLattice=\"9 0 0 0 nine 0 0 0 9\"\nC 0 0 0 1\n",
     2,
     {"'nine'"}},
    {"lattice twice",
     ".xyz",
     "1\nLattice=\"9 0 0 0 9 0 0 0 9\" lattice=\"8 0 0 0 8 0 0 0 8\"\nC 0 0 0 1\n",
     2,
     {"'lattice' is there twice"}},
    {"pbc twice", ".xyz", "1\npbc=\"T T T\" pbc=\"F F F\"\nC 0 0 0 1\n", 2, {"twice"}},
    {"properties twice",
     ".xyz",
     "1\nProperties=pos:R:3:radius:R:1 Properties=radius:R:1:pos:R:3\n0 0 0 1\n",
     2,
     {"twice"}},
    {"properties with blanks",
     ".xyz",
     "1\nProperties = species:S:1:pos:R:3:mass:R:1\nC 0 0 0 1\n",
     2,
     {"'mass'", "--radius"}},
    {"type of a property", ".xyz", "1\nProperties=pos:X:3\n0 0 0\n", 2, {"name:type:count"}},
    {"quoted key", ".xyz", "1\nc=\"a \\\" pbc=\" pbc=maybe\nC 0 0 0 1\n", 2, {"pbc 'maybe'"}},
    {"rows beyond the count", ".xyz", "1\nc\nC 0 0 0 1\n\nC 0 0 0 1\n", 5, {"number of its"}},
    {"open quote", ".xyz", "1\npbc=\"T T F\nC 0 0 0 1\n", 2, {"closing"}},
    {"odd properties", ".xyz", "1\nProperties=pos:R\n0 0 0\n", 2, {"name:type:count"}},
    {"empty properties", ".xyz", "1\nProperties=\n0 0 0\n", 2, {"name:type:count"}},
    {"properties of none", ".xyz", "1\nProperties=pos:R:0\n0 0 0\n", 2, {"name:type:count"}},
    {"huge properties", ".xyz", "1\nProperties=pos:R:3:a:R:2000000000\n0\n", 2, {"name:type"}},
    {"no positions", ".xyz", "1\nProperties=radius:R:1\n0\n", 2, {"column x is missing"}},
    {"positions twice",
     ".xyz",
     "1\nProperties=pos:R:3:pos:R:3:radius:R:1\n0 0 0 0 0 0 1\n",
     2,
     {"'x' is there twice"}},
    {"NUL", ".xyz", "1\nc\nC 0 0 \0 1\n"s, 3, {"NUL byte"}},
};

void expect_refused(const Malformed& row) {
  SCOPED_TRACE(std::string(row.suffix) + ": " + row.what);
  const Scratch scratch;
  const std::string path = scratch.file(std::string("bad") + row.suffix, row.text);
  const std::string sentence =
      sentence_of(ErrorCode::invalid_input, [&] { static_cast<void>(read_snapshot(path)); });
  const std::string place =
      row.line == 0 ? path + ": " : path + ", line " + std::to_string(row.line);
  EXPECT_TRUE(sentence.starts_with(place)) << sentence << "\nshould begin with " << place;
  for (const char* word : row.words) {
    EXPECT_NE(sentence.find(word), std::string::npos) << sentence << "\nshould hold " << word;
  }
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_LT(sentence.size(), path.size() + 400) << sentence;
}

TEST(MalformedInput, Csv) {
  for (const Malformed& row : malformed_csv) expect_refused(row);
}
TEST(MalformedInput, LammpsDump) {
  for (const Malformed& row : malformed_dump) expect_refused(row);
}
TEST(MalformedInput, Xyz) {
  for (const Malformed& row : malformed_xyz) expect_refused(row);
}

/// The same texts without a known size: refused too, and a count alone allocates nothing.
TEST(MalformedInput, PipedAsWell) {
  ReadOptions options;
  const auto refuse = [&](const Malformed& row, const char* format) {
    SCOPED_TRACE(std::string(format) + ": " + row.what);
    options.format = format;
    sentence_of(ErrorCode::invalid_input,
                [&] { static_cast<void>(read_piped(row.text, options)); });
  };
  for (const Malformed& row : malformed_csv) refuse(row, "csv");
  for (const Malformed& row : malformed_dump) refuse(row, "lammps_dump");
  for (const Malformed& row : malformed_xyz) refuse(row, "xyz");
}

}  // namespace
}  // namespace abut::io::testing
