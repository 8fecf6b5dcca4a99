#include "io/read/read_pairs.hpp"

#include "scratch.hpp"

#include "io/write/write_contacts.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace abut::io::testing {
namespace {

using Pairs = std::vector<ContactPair>;

Pairs pairs_of(std::string_view text, const ElementCounts& elements) {
  const Scratch scratch;
  return read_pairs(scratch.file("pairs.csv", text), elements);
}

TEST(ReadPairs, ColumnsInAnyOrderOthersIgnored) {
  const Pairs expected{{4, 0}, {1, 1}};
  for (const std::string_view text : {
           "i,j\n4,0\n1,1\n",
           "gap,j,note,i\r\n-1e-3,0,\"a, b\",4\r\n,1,,1\r\n",
           "# bonds\n\n i ; j \n4; 0\n# a break\n 1;1",
           "j\ti\n0\t4\n1\t1\n",
           "i j\n4 0\n\n1   1\n",
       }) {
    EXPECT_EQ(pairs_of(text, {5, 5}), expected) << text;
  }
  EXPECT_EQ(pairs_of("i,j\n", {0, 0}), Pairs{});
}

TEST(ReadPairs, WhatContactsAreWrittenAs) {
  const Scratch scratch;
  Snapshot discs;
  discs.dimensions = 2;
  discs.x = discs.y = discs.radius = {0, 1, 2};
  discs.ids = {7, 8, 9};
  const Pairs pairs{{0, 1}, {1, 2}, {0, 2}};
  write_contacts({scratch.path("out.csv"), ContactFormat::csv, IdColumns::with, {}}, discs, pairs);
  EXPECT_EQ(read_pairs(scratch.path("out.csv"), {3, 3}), pairs);
}

TEST(ReadPairs, EachNumberHasItsOwnSet) {
  EXPECT_EQ(pairs_of("i,j\n1,8\n", {2, 9}), (Pairs{{1, 8}}));
  sentence_of(ErrorCode::invalid_input, [] { static_cast<void>(pairs_of("i,j\n8,1\n", {2, 9})); });
}

TEST(ReadPairs, ErrorsNameLineColumnAndValue) {
  const auto error_of = [](std::string_view text) {
    const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
      static_cast<void>(pairs_of(text, {5, 5}));
    });
    const std::size_t name = sentence.find("pairs.csv");
    return name == std::string::npos ? sentence : sentence.substr(name);
  };
  EXPECT_EQ(error_of(""),
            "pairs.csv: is empty; a header line such as i,j is needed even without pairs");
  EXPECT_EQ(error_of("0,1\n"),
            "pairs.csv, line 1: a header line is missing: '0' is a number; begin the file with a "
            "line such as i,j");
  EXPECT_EQ(
      error_of("i,k\n"),
      "pairs.csv, line 1: column j is missing (the header is 'i,k'); a CSV file of pairs names "
      "i and j");
  EXPECT_EQ(error_of("i,j,i\n"), "pairs.csv, line 1: column i is there twice; rename one of them");
  EXPECT_EQ(error_of("i,j,gap\n1,2\n"),
            "pairs.csv, line 2: has 2 fields, but there are 3 columns; write one field for each "
            "column");
  for (const char* const number : {"5", "-1", "1.0", "x", "", "99999999999999999999"}) {
    EXPECT_EQ(error_of("i,j\n0,1\n2," + std::string(number) + "\n"),
              "pairs.csv, line 3, column 'j': '" + std::string(number) +
                  "' is no element: there are 5, numbered from 0; correct or remove this pair");
  }
  const std::string sentence = sentence_of(ErrorCode::invalid_input, [] {
    static_cast<void>(read_pairs("nowhere/pairs.csv", {5, 5}));
  });
  EXPECT_NE(sentence.find("cannot be opened"), std::string::npos) << sentence;
}

TEST(ReadPairs, CanBeCancelled) {
  const Scratch scratch;
  const std::string path = scratch.file("pairs.csv", "i,j\n0,1\n");
  const auto cancel = [](const Progress&) { return ProgressAction::cancel; };
  sentence_of(ErrorCode::cancelled, [&] { static_cast<void>(read_pairs(path, {5, 5}, cancel)); });
}

}  // namespace
}  // namespace abut::io::testing
