#include "scratch.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io::testing {
namespace {

std::string data_file(std::string_view header, std::string_view atoms_line,
                      std::initializer_list<std::string_view> atoms) {
  std::string text = "LAMMPS data file via write_data, version 29 Aug 2024, timestep = 0\n\n";
  text += std::to_string(atoms.size()) + " atoms\n2 atom types\n\n";
  text += std::string(header) + "\nMasses\n\n1 1.0\n2 3.5 # heavy\n\n";
  text += std::string(atoms_line) + "\n\n";
  for (const std::string_view atom : atoms) text += std::string(atom) + "\n";
  return text + "\nVelocities\n\n1 0 0 0 0 0 0\n";
}

/// The sentence of the error, without the folder of the file.
std::string error_text(std::string_view name, std::string_view text) {
  const Scratch scratch;
  const std::string path = scratch.file(name, text);
  const std::string sentence =
      sentence_of(ErrorCode::invalid_input, [&] { static_cast<void>(read_snapshot(path)); });
  const std::size_t folder = path.size() - name.size();
  return sentence.substr(0, folder) == path.substr(0, folder) ? sentence.substr(folder) : sentence;
}

const std::string block = "0 4 xlo xhi\n-1 2 ylo yhi\n0.5 3 zlo zhi\n";

TEST(ReadLammpsData, SpheresWithImageFlags) {
  const std::string text =
      data_file(block, "Atoms # sphere", {"7 1 0.5 2500 1 2 3 0 0 0", "3 2 0.25 1 4 5 6 -1 0 2"});
  for (const Snapshot& snapshot : {read_text("a.data", text), read_text("a.lmp", text),
                                   read_text("a.lammps", text), read_piped(text)}) {
    EXPECT_EQ(snapshot.format, "lammps_data");
    EXPECT_EQ(snapshot.dimensions, 3);
    EXPECT_EQ(snapshot.x, (Numbers{1, 4}));
    EXPECT_EQ(snapshot.y, (Numbers{2, 5}));
    EXPECT_EQ(snapshot.z, (Numbers{3, 6}));
    EXPECT_EQ(snapshot.radius, (Numbers{0.25, 0.125}));
    EXPECT_EQ(snapshot.ids, (std::vector<std::int64_t>{7, 3}));
    EXPECT_EQ(snapshot.periodic, (std::array{true, true, true}));
    EXPECT_TRUE(snapshot.periodicity_is_assumed);
    EXPECT_EQ((*snapshot.box)[0], (std::array{4.0, 0.0, 0.0}));
    EXPECT_EQ((*snapshot.box)[1], (std::array{0.0, 3.0, 0.0}));
    EXPECT_EQ((*snapshot.box)[2], (std::array{0.0, 0.0, 2.5}));
  }
}

TEST(ReadLammpsData, TiltsAndGeneralBoxes) {
  const Snapshot tilted = read_text("a.data", data_file(block + "0.5 -0.25 0.75 xy xz yz\n",
                                                        "Atoms # sphere", {"1 1 1 1 0 0 1"}));
  EXPECT_EQ((*tilted.box)[0], (std::array{4.0, 0.0, 0.0}));
  EXPECT_EQ((*tilted.box)[1], (std::array{0.5, 3.0, 0.0}));
  EXPECT_EQ((*tilted.box)[2], (std::array{-0.25, 0.75, 2.5}));
  const Snapshot general =
      read_text("a.data", data_file("1 2 3 avec\n-2 1 0 bvec\n0 0.5 9 cvec\n0 0 0 abc origin\n",
                                    "Atoms # sphere", {"1 1 1 1 0 0 1"}));
  EXPECT_EQ((*general.box)[0], (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ((*general.box)[1], (std::array{-2.0, 1.0, 0.0}));
  EXPECT_EQ((*general.box)[2], (std::array{0.0, 0.5, 9.0}));
}

TEST(ReadLammpsData, OtherStylesTakeOneRadius) {
  ReadOptions options;
  options.radius = 0.75;
  const auto expect_at = [&](std::string_view atoms_line, std::string_view atom) {
    const Snapshot snapshot = read_text("a.data", data_file(block, atoms_line, {atom}), options);
    EXPECT_EQ(snapshot.x, Numbers{10}) << atoms_line;
    EXPECT_EQ(snapshot.y, Numbers{20}) << atoms_line;
    EXPECT_EQ(snapshot.z, Numbers{30}) << atoms_line;
    EXPECT_EQ(snapshot.radius, Numbers{0.75}) << atoms_line;
  };
  expect_at("Atoms # atomic", "1 1 10 20 30");
  expect_at("Atoms # atomic", "1 1 10 20 30 0 0 0");
  expect_at("Atoms  # charge", "1 1 -0.5 10 20 30");
  expect_at("Atoms # molecular", "1 4 1 10 20 30 1 -1 0");
  expect_at("Atoms # full", "1 4 1 0.5 10 20 30  # the first");
  expect_at("Atoms # sphere", "1 1 2.5 1 10 20 30");
  expect_at("Atoms # bpm/sphere", "1 1 1 2.5 1 10 20 30");
  expect_at("Atoms", "1 1 10 20 30");
  expect_at("Atoms", "1 4 1 10 20 30 0 0 0");
  expect_at("Atoms", "1 4 1 0.5 10 20 30 0 0 0");
}

TEST(ReadLammpsData, APlaneIsNotPeriodicAcrossIt) {
  const Snapshot snapshot =
      read_text("a.data", data_file("0 4 xlo xhi\n0 4 ylo yhi\n-0.5 0.5 zlo zhi\n",
                                    "Atoms # sphere", {"1 1 1 1 0 1 0", "2 1 1 1 2 1 0.0"}));
  EXPECT_EQ(snapshot.periodic, (std::array{true, true, false}));
}

TEST(ReadLammpsData, NoAtoms) {
  const std::string text = "# by hand\n0 atoms\n0 2 xlo xhi\n0 2 ylo yhi\n0 2 zlo zhi\n";
  const Snapshot snapshot = read_text("a.data", text);
  EXPECT_EQ(snapshot.size(), 0u);
  EXPECT_EQ((*snapshot.box)[2], (std::array{0.0, 0.0, 2.0}));
}

TEST(ReadLammpsData, ABlankFirstLineIsItsComment) {
  const std::string text = "\n1 atoms\n" + block + "\nAtoms # sphere\n\n1 1 1 1 0 0 1\n";
  EXPECT_EQ(read_text("a.data", text).size(), 1u);
}

TEST(ReadLammpsData, ErrorsNameLineFieldAndValue) {
  const auto atoms = [&](std::string_view line, std::initializer_list<std::string_view> rows) {
    return data_file(block, line, rows);
  };
  // Line 17 is that of the first atom.
  EXPECT_EQ(
      error_text("a.data", atoms("Atoms # sphere", {"1 1 0.5 1 0 nan 1"})),
      "a.data, line 17, column 'y': 'nan' is not a finite number; correct or remove this element");
  EXPECT_EQ(error_text("a.data", atoms("Atoms # sphere", {"1 1 -0.5 1 0 0 1"})),
            "a.data, line 17, column 'diameter': '-0.5' is negative; correct or remove this "
            "element");
  EXPECT_EQ(error_text("a.data", atoms("Atoms # sphere", {"1 1 0.5 1 0 0"})),
            "a.data, line 17: has 6 fields, but there are 7 columns; write one field for each "
            "column");
  EXPECT_EQ(error_text("a.data", atoms("Atoms # spheer", {"1 1 0.5 1 0 0 1"}))
                .find("a.data, line 17: atom style 'spheer' is none that is read here; there are "
                      "sphere "),
            0u);
  EXPECT_EQ(error_text("a.data", atoms("Atoms", {"1 1 0.5 1 0 0 1"})),
            "a.data, line 17: the section Atoms names no atom style, and 7 columns do not tell it; "
            "write 'Atoms # sphere', or what it is, above the atoms, or give one radius for all "
            "with --radius");
  EXPECT_EQ(error_text("a.data", atoms("Atoms # atomic", {"1 1 0 0 1"}))
                .find("a.data, line 17: there is no column radius, r or diameter"),
            0u);
  EXPECT_EQ(error_text("a.data",
                       "x\n2 atoms\n" + block + "Atoms # sphere\n\n1 1 1 1 0 0 1\n\n\n\n\n\n\n\n"),
            "a.data: ends after 1 of the 2 atoms; the file is cut off");
  EXPECT_EQ(error_text("a.data",
                       "x\n2 atoms\n" + block + "Atoms # sphere\n\n1 1 1 1 0 0 1\n\nVelocities\n"),
            "a.data, line 10: 'Velocities' comes after 1 of the 2 atoms; the number of atoms is "
            "wrong or lines are missing");
  EXPECT_EQ(error_text("a.data", "x\n2 atoms\n" + block),
            "a.data: announces 2 atoms and has no section Atoms; the file is cut off");
  EXPECT_EQ(error_text("a.data", "x\n-2 atoms\n"),
            "a.data, line 2: '-2' is no number of elements; it must be a whole number from 0");
  EXPECT_EQ(error_text("a.data", "x\n1 atoms\n0 4x xlo xhi\n"),
            "a.data, line 3: '4x' is not a number; write it like 0.5 or 1e-3");
  EXPECT_EQ(error_text("a.data", "x\n0 atoms\n4 0 xlo xhi\n"),
            "a.data: the box ends before it begins on axis x; correct xlo xhi");
  EXPECT_EQ(error_text("a.data", "x,y,radius\n1,2,3\n"),
            "a.data: has neither a line 'N atoms' nor a box; it is no LAMMPS data file: name its "
            "format with --format");
}

/// Rows that the number of atoms does not cover, and headers that do not tell it.
TEST(ReadLammpsData, OtherThanCountRowsIsAnError) {
  const std::string rows = "\nAtoms # sphere\n\n1 1 1 1 0 0 1\n2 1 1 1 1 0 1\n";
  const auto expect = [&](std::string_view header, std::string_view body, std::string_view told) {
    const std::string text = "comment\n" + std::string(header) + block + std::string(body);
    const std::string sentence = error_text("a.data", text);
    EXPECT_NE(sentence.find(told), std::string::npos) << sentence << "\nof\n" << text;
  };
  expect("NaN atoms\n", rows, "line 2: 'NaN' is no number of elements");
  expect("2 2 atoms\n", rows,
         "line 2: '2 2 atoms' is no line of a header; write it like 'N atoms'");
  expect("two atoms\n", rows, "line 2: 'two' is no number of elements");
  expect("2 atoms more\n", rows, "line 2: '2 atoms more' is no line of a header");
  expect("atoms 2\n", rows, "line 2: 'atoms 2' is no line of a header");
  expect("2.0 atoms\n", rows, "line 2: '2.0'");
  expect("18446744073709551618 atoms\n", rows, "line 2: '18446744073709551618'");
  expect("", rows, "line 6: the section Atoms comes without a line 'N atoms'");
  expect("", "", "has no line 'N atoms' in its header");
  expect("1 atoms\n", rows, "line 10: '2 1 1 1 1 0 1' comes after the 1 atoms");
  expect("0 atoms\n", rows, "line 9: '1 1 1 1 0 0 1' comes after the 0 atoms");
  expect("1 atoms\n", rows + "\nVelocities\n\n1 0 0 0\n", "line 10: '2 1 1 1 1 0 1'");
  expect("3 atoms\n", rows + "\nVelocities\n\n1 0 0 0\n", "line 12: 'Velocities' comes after 2 of");
  expect("2 atoms\n2 atoms\n", rows, "line 3: '2 atoms' comes after a line like 'N atoms'");
  expect("2 atoms\n", rows + rows, "line 12: a second section Atoms");
  expect("2 atoms\n", rows + "\nVelocities\n\n1 0 0 0\n\nAtoms\n\n", "a second section Atoms");
  expect("2 atoms\n1 2 3\n", rows, "'1 2 3' stands in the header");
  EXPECT_NE(error_text("a.data", "x\n2 atoms\njunk\n" + block + rows)
                .find("line 4: '0 4 xlo xhi' comes after the header"),
            std::string::npos)
      << "the box would be lost";
  EXPECT_EQ(error_text("a.data", "2 atoms\n" + block + rows).find("a.data, line 6"), 0u)
      << "the first line is a comment";
}

TEST(ReadLammpsData, BoxesGivenTwice) {
  const auto sentence = [](std::string_view box) {
    return error_text("a.data", "comment\n0 atoms\n" + std::string(box));
  };
  EXPECT_EQ(
      sentence("0 1 xlo xhi\n0 2 xlo xhi\n"),
      "a.data, line 4: '0 2 xlo xhi' comes after a line like '0 1 xlo xhi'; leave one of them "
      "out");
  EXPECT_NE(sentence("0 0 0 xy xz yz\n0 0 0 xy xz yz\n").find("line 4"), std::string::npos);
  EXPECT_NE(sentence("0 1 xlo\n").find("write it like '0 1 xlo xhi'"), std::string::npos);
  EXPECT_NE(sentence("0 1 xlo xhi 3\n").find("write it like '0 1 xlo xhi'"), std::string::npos);
  EXPECT_NE(sentence("0 1 xhi xlo\n").find("write it like '0 1 xlo xhi'"), std::string::npos);
  EXPECT_NE(sentence("0 inf xlo xhi\n").find("'inf' is not a finite number"), std::string::npos);
  EXPECT_NE(sentence("1 0 0 avec\n0 1 0 bvec\n").find("needs all three"), std::string::npos);
  EXPECT_NE(sentence("1 0 0 avec\n0 1 0 bvec\n0 0 1 cvec\n0 1 xlo xhi\n").find("box twice"),
            std::string::npos);
}

TEST(ReadLammpsData, WhatMayStandBesideTheAtoms) {
  const std::string text =
      "comment: 5 atoms\n2  atoms # two\n7 bonds\n 1 atom types\n 2 extra bond per atom\n"
      "3 crossterms\n" +
      block +
      "\nMasses\n\nC 12.0\n\nPair Coeffs # lj/cut\n\n1 1 1\n\nAtoms # sphere\n\n"
      "1 1 1 1 0 0 1 # first\n\n2 1 1 1 1 0 1\n\nSection of a fix\n\n1 2 3\n9 9 9\n\nBonds\n\n1 1 "
      "1 2\n";
  EXPECT_EQ(read_text("a.data", text).size(), 2u);
}

TEST(ReadLammpsData, WithoutAStyleEightColumnsAreNotGuessed) {
  const auto sentence = [](std::string_view line, std::string_view row) {
    const Scratch scratch;
    const std::string path = scratch.file("a.data", data_file(block, line, {row}));
    return sentence_of(ErrorCode::invalid_input,
                       [&] { static_cast<void>(read_snapshot(path, with_radius(1))); });
  };
  const std::string told =
      "names no atom style, and 8 columns do not tell it; write 'Atoms # sphere'";
  EXPECT_NE(sentence("Atoms", "1 1 10 20 30 0 0 0").find(told), std::string::npos);
  EXPECT_NE(sentence("Atoms", "1 1 1 0.5 2500 10 20 30").find(told), std::string::npos);
  // Nine are six and image flags, which are whole numbers.
  EXPECT_NE(sentence("Atoms", "1 1 10 20 30 0.5 0 0.5 2").find("'0.5' is no image flag"),
            std::string::npos);
  EXPECT_NE(sentence("Atoms # atomic", "1 1 1 0.5 2500 10.5 20 30").find("'10.5' is no image flag"),
            std::string::npos);
}

}  // namespace
}  // namespace abut::io::testing
