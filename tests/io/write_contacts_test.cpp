#include "io/write/write_contacts.hpp"

#include "scratch.hpp"

#include <abut/detect.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <random>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

namespace abut::io::testing {
namespace {

Snapshot three_in_a_row() {
  Snapshot snapshot;
  snapshot.dimensions = 2;
  snapshot.x = {0, 1, 2.1};
  snapshot.y = {0, 0, 0};
  snapshot.radius = {0.5, 0.5, 0.75};
  snapshot.ids = {70, -5, 9};
  snapshot.source = "three";
  return snapshot;
}

const std::vector<ContactPair> two_pairs{{0, 1}, {1, 2}};

const std::vector<ContactPair> three_pairs{{0, 1}, {0, 1}, {2, 2}};
const std::vector<ImageShift> three_shifts{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};

std::string written(ContactFormat format, IdColumns ids, const Snapshot& snapshot,
                    std::span<const ContactPair> pairs) {
  const Scratch scratch;
  write_contacts({scratch.path("out"), format, ids, {}}, snapshot, pairs);
  return text_of(scratch.path("out"));
}

TEST(WriteContacts, Csv) {
  EXPECT_EQ(written(ContactFormat::csv, IdColumns::without, three_in_a_row(), two_pairs),
            "i,j,gap\n0,1,0\n1,2,-0.14999999999999991\n");
  EXPECT_EQ(written(ContactFormat::csv, IdColumns::with, three_in_a_row(), two_pairs),
            "i,j,id_i,id_j,gap\n0,1,70,-5,0\n1,2,-5,9,-0.14999999999999991\n");
  EXPECT_EQ(written(ContactFormat::csv, IdColumns::without, Snapshot{}, {}), "i,j,gap\n");
}

TEST(WriteContacts, Json) {
  EXPECT_EQ(written(ContactFormat::json, IdColumns::without, three_in_a_row(), two_pairs),
            "{\n\"elements\": 3,\n\"dimensions\": 2,\n\"contact_pairs\": 2,\n"
            "\"columns\": [\"i\", \"j\", \"gap\"],\n"
            "\"pairs\": [\n[0, 1, 0],\n[1, 2, -0.1499999999999999]\n]\n}\n");
  EXPECT_EQ(written(ContactFormat::json, IdColumns::with, three_in_a_row(), {two_pairs.data(), 1}),
            "{\n\"elements\": 3,\n\"dimensions\": 2,\n\"contact_pairs\": 1,\n"
            "\"columns\": [\"i\", \"j\", \"id_i\", \"id_j\", \"gap\"],\n"
            "\"pairs\": [\n[0, 1, 70, -5, 0]\n]\n}\n");
  EXPECT_EQ(written(ContactFormat::json, IdColumns::without, Snapshot{}, {}),
            "{\n\"elements\": 0,\n\"dimensions\": 3,\n\"contact_pairs\": 0,\n"
            "\"columns\": [\"i\", \"j\", \"gap\"],\n\"pairs\": []\n}\n");
}

TEST(WriteContacts, ImageShiftsOfPeriodicDomains) {
  const Scratch scratch;
  const ContactImages images{std::span(three_shifts), Domain::periodic({2.0, unbounded})};
  const auto text = [&](ContactFormat format, IdColumns ids) {
    write_contacts({scratch.path("out"), format, ids, {}}, three_in_a_row(), three_pairs, images);
    return text_of(scratch.path("out"));
  };
  EXPECT_EQ(text(ContactFormat::csv, IdColumns::without),
            "i,j,nx,ny,nz,gap\n0,1,-1,0,0,0\n0,1,0,0,0,0\n2,2,1,0,0,0.5\n");
  EXPECT_EQ(text(ContactFormat::csv, IdColumns::with),
            "i,j,id_i,id_j,nx,ny,nz,gap\n0,1,70,-5,-1,0,0,0\n0,1,70,-5,0,0,0,0\n"
            "2,2,9,9,1,0,0,0.5\n");
  EXPECT_EQ(
      text(ContactFormat::json, IdColumns::without),
      "{\n\"elements\": 3,\n\"dimensions\": 2,\n\"contact_pairs\": 3,\n"
      "\"columns\": [\"i\", \"j\", \"nx\", \"ny\", \"nz\", \"gap\"],\n"
      "\"pairs\": [\n[0, 1, -1, 0, 0, 0],\n[0, 1, 0, 0, 0, 0],\n[2, 2, 1, 0, 0, 0.5]\n]\n}\n");
  const std::string sentence = sentence_of(ErrorCode::wrong_usage, [&] {
    write_contacts({scratch.path("a"), ContactFormat::csv, IdColumns::without, {}},
                   three_in_a_row(), three_pairs, {{}, images.domain});
  });
  EXPECT_NE(sentence.find("0 image shifts for 3 contact pairs"), std::string::npos) << sentence;
}

/// Three different numbers, whose places tell the axes apart.
TEST(WriteContacts, ShiftsStandInTheOrderOfTheAxes) {
  Snapshot one;
  one.dimensions = 3;
  one.x = one.y = one.z = {0.0};
  one.radius = {0.5};
  const std::vector<ContactPair> pairs{{0, 0}};
  const std::vector<ImageShift> shifts{{2, -3, 6}};
  const ContactImages images{std::span(shifts), Domain::periodic({1.0, 1.0, 1.0})};
  const Scratch scratch;
  const auto text = [&](ContactFormat format) {
    write_contacts({scratch.path("out"), format, IdColumns::without, {}}, one, pairs, images);
    return text_of(scratch.path("out"));
  };
  EXPECT_EQ(text(ContactFormat::csv), "i,j,nx,ny,nz,gap\n0,0,2,-3,6,6\n");
  EXPECT_NE(text(ContactFormat::json).find("\n[0, 0, 2, -3, 6, 6]\n"), std::string::npos);
}

TEST(WriteContacts, QuantitiesStandBehindTheGap) {
  const std::vector<double> gaps{-0.5, 0.25};
  const std::vector<Vector> normals{{1, 0, 0}, {0, 0.5, -1}};
  const std::vector<double> distances{3, 4};
  const Scratch scratch;
  const auto text = [&](ContactFormat format, const ContactQuantities& quantities) {
    write_contacts({scratch.path("out"), format, IdColumns::without, {}}, three_in_a_row(),
                   two_pairs, {}, quantities);
    return text_of(scratch.path("out"));
  };
  EXPECT_EQ(text(ContactFormat::csv, {gaps, normals, {}, distances, {}}),
            "i,j,gap,normal_x,normal_y,normal_z,distance\n"
            "0,1,-0.5,1,0,0,3\n1,2,0.25,0,0.5,-1,4\n");
  EXPECT_EQ(text(ContactFormat::csv, {gaps, {}, normals, {}, normals}),
            "i,j,gap,point_x,point_y,point_z,vector_x,vector_y,vector_z\n"
            "0,1,-0.5,1,0,0,1,0,0\n1,2,0.25,0,0.5,-1,0,0.5,-1\n");
  const std::string json = text(ContactFormat::json, {gaps, normals, {}, {}, {}});
  EXPECT_NE(json.find("\"gap\", \"normal_x\", \"normal_y\", \"normal_z\"]"), std::string::npos);
  EXPECT_NE(json.find("\n[0, 1, -0.5, 1, 0, 0],\n[1, 2, 0.25, 0, 0.5, -1]\n]"), std::string::npos);
  const std::string sentence = sentence_of(ErrorCode::wrong_usage, [&] {
    text(ContactFormat::csv, {gaps, {normals.data(), 1}, {}, {}, {}});
  });
  EXPECT_NE(sentence.find("1 numbers of a quantity for 2"), std::string::npos) << sentence;
}

/// i of the first set and j of the second, whose gaps and ids are its own.
TEST(WriteContacts, TwoSets) {
  Snapshot other = three_in_a_row();
  other.x = {-1.5, 3.0};
  other.y = {0, 0};
  other.radius = {1.0, 0.0};
  other.ids = {40, 50};
  const Snapshot first = three_in_a_row();
  const std::vector<ContactPair> pairs{{0, 0}, {2, 1}};
  const Scratch scratch;
  const auto text = [&](ContactFormat format, IdColumns ids, const ContactImages& images = {}) {
    write_contacts({scratch.path("out"), format, ids, {}}, {first, other}, pairs, images);
    return text_of(scratch.path("out"));
  };
  EXPECT_EQ(text(ContactFormat::csv, IdColumns::without),
            "i,j,gap\n0,0,0\n2,1,0.14999999999999991\n");
  EXPECT_EQ(text(ContactFormat::csv, IdColumns::with),
            "i,j,id_i,id_j,gap\n0,0,70,40,0\n2,1,9,50,0.14999999999999991\n");
  EXPECT_EQ(text(ContactFormat::json, IdColumns::without),
            "{\n\"elements\": 5,\n\"sets\": [3, 2],\n\"dimensions\": 2,\n\"contact_pairs\": 2,\n"
            "\"columns\": [\"i\", \"j\", \"gap\"],\n"
            "\"pairs\": [\n[0, 0, 0],\n[2, 1, 0.1499999999999999]\n]\n}\n");
  const std::vector<ImageShift> shifts{{0, 0, 0}, {-1, 0, 0}};
  EXPECT_EQ(text(ContactFormat::csv, IdColumns::without,
                 {std::span(shifts), Domain::periodic({1.0, unbounded})}),
            "i,j,nx,ny,nz,gap\n0,0,0,0,0,0\n2,1,-1,0,0,-0.64999999999999991\n");

  const std::vector<ContactPair> beyond{{0, 2}};
  const std::string sentence = sentence_of(ErrorCode::wrong_usage, [&] {
    write_contacts({scratch.path("a"), ContactFormat::csv, IdColumns::without, {}}, {first, other},
                   beyond);
  });
  EXPECT_NE(sentence.find("(0, 2) names an element beyond the 2 there are"), std::string::npos)
      << sentence;
  other.ids.clear();
  other.source = "walls.csv";
  EXPECT_NE(sentence_of(ErrorCode::invalid_input,
                        [&] { static_cast<void>(text(ContactFormat::csv, IdColumns::with)); })
                .find("walls.csv has no ids"),
            std::string::npos);
}

TEST(WriteContacts, OrderIsKept) {
  const std::vector<ContactPair> backwards{two_pairs[1], two_pairs[0]};
  EXPECT_EQ(written(ContactFormat::csv, IdColumns::without, three_in_a_row(), backwards),
            "i,j,gap\n1,2,-0.14999999999999991\n0,1,0\n");
}

/// Every gap as printf's %.17g writes it, and reading it gives its bits back.
TEST(WriteContacts, GapsOfARealPacking) {
  const Snapshot snapshot = read_snapshot(ABUT_EXAMPLE_DATA "/yade_settled_5000.csv");
  const PairList pairs = find_contact_pairs(snapshot.elements());
  std::istringstream lines(
      written(ContactFormat::csv, IdColumns::without, snapshot, pairs.pairs()));
  std::string line;
  std::getline(lines, line);
  for (const ContactPair& pair : pairs) {
    char expected[80];
    std::snprintf(expected, sizeof expected, "%u,%u,%.17g", pair.first, pair.second,
                  gap(snapshot.elements(), pair));
    ASSERT_TRUE(std::getline(lines, line));
    ASSERT_EQ(line, expected);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(WriteContacts, FormatByNameElseBySuffix) {
  EXPECT_EQ(contact_format("", "a.csv"), ContactFormat::csv);
  EXPECT_EQ(contact_format("", "dir.d/A.VTP"), ContactFormat::vtp);
  EXPECT_EQ(contact_format("", "-"), ContactFormat::csv);
  EXPECT_EQ(contact_format("json", "-"), ContactFormat::json);
  EXPECT_EQ(contact_format("vtp", "a.csv"), ContactFormat::vtp);
  for (const auto& asked : {std::pair{"", "a.xlsx"}, {"", "out"}, {"xlsx", "a.csv"}}) {
    const std::string sentence = sentence_of(ErrorCode::wrong_usage, [&] {
      static_cast<void>(contact_format(asked.first, asked.second));
    });
    EXPECT_NE(sentence.find("csv, json and vtp"), std::string::npos) << sentence;
  }
}

TEST(WriteContacts, RefusesIdsThatAreNotThereAndElementsBeyondTheLast) {
  const Scratch scratch;
  Snapshot snapshot = three_in_a_row();
  const std::vector<ContactPair> beyond{{0, 3}};
  for (const ContactFormat format : {ContactFormat::csv, ContactFormat::json, ContactFormat::vtp}) {
    sentence_of(ErrorCode::wrong_usage, [&] {
      write_contacts({scratch.path("a"), format, IdColumns::without, {}}, snapshot, beyond);
    });
  }
  snapshot.ids.clear();
  const std::string sentence = sentence_of(ErrorCode::invalid_input, [&] {
    write_contacts({scratch.path("a"), ContactFormat::csv, IdColumns::with, {}}, snapshot, {});
  });
  EXPECT_NE(sentence.find("three has no ids"), std::string::npos) << sentence;
  EXPECT_EQ(scratch.file_count(), 0u);
}

/// Of VTP the numbers of all arrays: 18 for three points with ids, four a pair.
TEST(WriteContacts, ProgressCountsPairsAndCancelLeavesNoFile) {
  const Snapshot snapshot = three_in_a_row();
  const std::vector<ContactPair> many(200'000, ContactPair{0, 1});
  for (const ContactFormat format : {ContactFormat::csv, ContactFormat::json, ContactFormat::vtp}) {
    const Scratch scratch;
    const bool is_vtp = format == ContactFormat::vtp;
    std::vector<std::uint64_t> done;
    const auto output = [&](ProgressAction second) {
      return ContactOutput{scratch.path("a"), format, IdColumns::without,
                           [&done, second, is_vtp](const Progress& progress) {
                             EXPECT_EQ(progress.phase, "write");
                             EXPECT_EQ(progress.total, is_vtp ? 800'018u : 200'000u);
                             // Before each system call it is asked once more.
                             const std::uint64_t last = done.empty() ? 0 : done.back();
                             if (progress.done != last) done.push_back(progress.done);
                             return done.size() == 2 ? second : ProgressAction::proceed;
                           }};
    };
    sentence_of(ErrorCode::cancelled,
                [&] { write_contacts(output(ProgressAction::cancel), snapshot, many); });
    EXPECT_EQ(scratch.file_count(), 0u);
    done.clear();
    write_contacts(output(ProgressAction::proceed), snapshot, many);
    const std::vector<std::uint64_t> each{65536, 131072, 196608};
    ASSERT_TRUE(std::ranges::is_sorted(done));
    EXPECT_TRUE(is_vtp || std::ranges::includes(done, each));
    EXPECT_GT(done.size(), 2u);
    EXPECT_EQ(scratch.file_count(), 1u);
  }
}

}  // namespace
}  // namespace abut::io::testing
