// Rules of who may pair, against triangle meshes: triangles that a rule denies to a sphere are not
// there for it. Against rational numbers, and against meshes without those triangles.

#include "support/error_expectations.hpp"
#include "walls/mesh_scenes.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using Contacts = std::vector<MovedContact>;
using Allows = std::function<bool(std::size_t, std::size_t)>;

std::vector<std::uint32_t> random_groups(Random& random, std::size_t count) {
  std::vector<std::uint32_t> groups(count);
  for (std::uint32_t& group : groups) group = static_cast<std::uint32_t>(random.below(3));
  return groups;
}

std::vector<std::uint64_t> random_masks(Random& random, std::size_t count) {
  std::vector<std::uint64_t> masks(count);
  for (std::uint64_t& mask : masks) mask = random.next() & 7;
  return masks;
}

/// Balls and triangles, and a rule of each kind together with what it allows.
class Ruled {
 public:
  Ruled(std::uint64_t seed, std::size_t ball_count) : random_(seed) {
    table_.deny(0, 1).deny(2, 2);
    arrays_ = soup(random_, 7, 14, 3);
    balls_ = balls_in(random_, ball_count, 3);
    const std::size_t triangles = arrays_.triangles.size();
    ball_groups_ = random_groups(random_, ball_count);
    triangle_groups_ = random_groups(random_, triangles);
    for (auto* masks : {&ball_categories_, &ball_accepts_}) {
      *masks = random_masks(random_, ball_count);
    }
    for (auto* masks : {&triangle_categories_, &triangle_accepts_}) {
      *masks = random_masks(random_, triangles);
    }
    for (std::size_t k = 0; k < ball_count * triangles / 4; ++k) {
      excluded_.push_back({static_cast<ElementIndex>(random_.below(ball_count)),
                           static_cast<ElementIndex>(random_.below(triangles))});
    }
    exclusions_ = ExclusionList(excluded_, ball_count, triangles);
  }

  struct Kind {
    const char* name;
    PairRule rule;
    Allows allows;
  };

  [[nodiscard]] std::vector<Kind> kinds() const {
    const Allows other_groups = [this](std::size_t i, std::size_t j) {
      return ball_groups_[i] != triangle_groups_[j];
    };
    const Allows by_table = [this](std::size_t i, std::size_t j) {
      return table_.allows(ball_groups_[i], triangle_groups_[j]);
    };
    const Allows by_masks = [this](std::size_t i, std::size_t j) {
      return (ball_categories_[i] & triangle_accepts_[j]) != 0 &&
             (triangle_categories_[j] & ball_accepts_[i]) != 0;
    };
    const Allows not_excluded = [this](std::size_t i, std::size_t j) {
      const ContactPair pair{static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)};
      return std::find(excluded_.begin(), excluded_.end(), pair) == excluded_.end();
    };
    const Allows all_of_these = [=](std::size_t i, std::size_t j) {
      return by_table(i, j) && by_masks(i, j) && not_excluded(i, j);
    };
    const PairTraits balls_by_mask{.categories = ball_categories_, .accepts = ball_accepts_};
    const PairTraits triangles_by_mask{.categories = triangle_categories_,
                                       .accepts = triangle_accepts_};
    const PairTraits balls{ball_groups_, ball_categories_, ball_accepts_};
    const PairTraits triangles{triangle_groups_, triangle_categories_, triangle_accepts_};
    return {{"groups",
             {.elements = {.groups = ball_groups_}, .others = {.groups = triangle_groups_}},
             other_groups},
            {"a table",
             {.elements = {.groups = ball_groups_},
              .others = {.groups = triangle_groups_},
              .table = &table_},
             by_table},
            {"masks", {.elements = balls_by_mask, .others = triangles_by_mask}, by_masks},
            {"exclusions", {.exclusions = &exclusions_}, not_excluded},
            {"all of them",
             {.elements = balls, .others = triangles, .table = &table_, .exclusions = &exclusions_},
             all_of_these}};
  }

  [[nodiscard]] const MeshArrays& arrays() const { return arrays_; }
  [[nodiscard]] const std::vector<Ball>& balls() const { return balls_; }

 private:
  Random random_;
  MeshArrays arrays_;
  std::vector<Ball> balls_;
  GroupTable table_{3};
  std::vector<std::uint32_t> ball_groups_, triangle_groups_;
  std::vector<std::uint64_t> ball_categories_, ball_accepts_;
  std::vector<std::uint64_t> triangle_categories_, triangle_accepts_;
  std::vector<ContactPair> excluded_;
  ExclusionList exclusions_;
};

TEST(MeshRule, AgreesWithRationalNumbers) {
  std::size_t found = 0;
  for (std::uint64_t seed = 81; seed < 85; ++seed) {
    const Ruled ruled(seed, 20);
    for (const auto& [name, rule, allows] : ruled.kinds()) {
      const Contacts expected =
          oracle_mesh_contacts(ruled.balls(), ruled.arrays(), {.allows = allows});
      ASSERT_EQ(agreed_contacts(view_of(ruled.balls()), ruled.arrays().mesh(), Domain::open(),
                                {.rule = rule}),
                expected)
          << name << ", seed " << seed;
      found += expected.size();
    }
  }
  EXPECT_GT(found, 200U);
}

/// A rule denies all images alike.
TEST(MeshRule, AgreesWithRationalNumbersInPeriodicDomains) {
  const Ruled ruled(86, 8);
  for (const Domain& domain : {Domain::lattice({4, 0, 0}, {1, 5, 0}, {-2, 1.5, 3}),
                               Domain::periodic({3.0, 3.0, unbounded})}) {
    for (const auto& [name, rule, allows] : ruled.kinds()) {
      const Contacts expected = oracle_mesh_contacts(
          ruled.balls(), ruled.arrays(), {.domain = domain, .farthest = 5, .allows = allows});
      ASSERT_FALSE(expected.empty());
      ASSERT_EQ(
          agreed_contacts(view_of(ruled.balls()), ruled.arrays().mesh(), domain, {.rule = rule}),
          expected)
          << name;
    }
  }
}

/// What one ball touches under a rule is what it touches of a mesh that has only the triangles
/// which the rule allows it, by the names of the whole mesh.
TEST(MeshRule, DeniedTrianglesAreNotThere) {
  for (std::uint64_t seed = 87; seed < 97; ++seed) {
    const Ruled ruled(seed, 30);
    const TriangleMesh whole = ruled.arrays().mesh();
    for (const auto& [name, rule, allows] : ruled.kinds()) {
      Contacts expected;
      for (std::size_t i = 0; i < ruled.balls().size(); ++i) {
        MeshArrays part{ruled.arrays().vertices, {}};
        std::vector<ElementIndex> numbers;
        for (std::size_t t = 0; t < whole.size(); ++t) {
          if (!allows(i, t)) continue;
          part.triangles.push_back(ruled.arrays().triangles[t]);
          numbers.push_back(static_cast<ElementIndex>(t));
        }
        const TriangleMesh mesh = part.mesh();
        for (auto [sphere, feature] : find_mesh_contacts(view_of({ruled.balls()[i]}), mesh)) {
          if (feature.kind == FeatureKind::face) {
            feature.number = whole.faces()[numbers[feature.number]];
          } else if (feature.kind == FeatureKind::edge) {
            const auto edge =
                std::find(whole.edges().begin(), whole.edges().end(), mesh.edges()[feature.number]);
            feature.number = static_cast<ElementIndex>(edge - whole.edges().begin());
          }
          expected.push_back({{static_cast<ElementIndex>(i), feature}, {}});
        }
      }
      std::sort(expected.begin(), expected.end());
      const Options options{.shifts = Shifts::stored, .rule = rule};
      ASSERT_EQ(moved_contacts(find_mesh_contacts(view_of(ruled.balls()), whole, options)),
                expected)
          << name << ", seed " << seed;
    }
  }
}

/// A ball over one half of a square touches its face; where that half is not there for it, the
/// diagonal, which the other half has, or nothing.
TEST(MeshRule, WithoutATriangleItsNeighborsBorderIsTouched) {
  const MeshArrays square{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const TriangleMesh mesh = square.mesh();
  const std::vector<Ball> balls{{{1.5, 2.5, 1.0}, 1.25}, {{0.5, 3.5, 1.0}, 1.25}};
  const Contacts free_contacts = agreed_contacts(view_of(balls), mesh, Domain::open());
  ASSERT_EQ(free_contacts.size(), 2U);
  EXPECT_EQ(count_of(free_contacts, FeatureKind::face), 2U);
  const std::vector<ContactPair> pairs{{0, 1}, {1, 1}};
  const ExclusionList exclusions(pairs, balls.size(), mesh.size());
  const Contacts contacts =
      agreed_contacts(view_of(balls), mesh, Domain::open(), {.rule = {.exclusions = &exclusions}});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].contact, (MeshContact{0, {FeatureKind::edge, 1}}));
}

TEST(MeshRule, OneThatAllowsAllChangesNothing) {
  Random random(98);
  for (int k = 0; k < 20; ++k) {
    const TriangleMesh mesh = soup(random, 7, 14, 2).mesh();
    const std::vector<Ball> balls = balls_in(random, 40, 2);
    const std::vector<std::uint32_t> zeros(balls.size(), 0), ones(mesh.size(), 1);
    const PairRule rule{.elements = {.groups = zeros}, .others = {.groups = ones}};
    const Contacts expected = agreed_contacts(view_of(balls), mesh, Domain::open());
    EXPECT_EQ(agreed_contacts(view_of(balls), mesh, Domain::open(), {.rule = rule}), expected);
    const PairRule none{.elements = {.groups = zeros},
                        .others = {.groups = std::span(zeros).first(mesh.size())}};
    EXPECT_TRUE(agreed_contacts(view_of(balls), mesh, Domain::open(), {.rule = none}).empty());
  }
}

TEST(MeshRule, OneThatDoesNotFitIsRefused) {
  const TriangleMesh mesh = cube().mesh();
  const std::vector<Ball> balls{{{0, 0, 0}, 1.0}, {{1, 0, 0}, 1.0}};
  const auto expect = [&](ErrorCode code, std::initializer_list<std::string_view> words,
                          const PairRule& rule) {
    expect_error(code, words, [&] {
      static_cast<void>(find_mesh_contacts(view_of(balls), mesh, {.rule = rule}));
    });
  };
  const std::vector<std::uint32_t> two{0, 1}, three{0, 1, 2};
  expect(ErrorCode::invalid_input, {"rule.elements.groups has 3", "2 elements"},
         {.elements = {.groups = three}, .others = {.groups = three}});
  expect(ErrorCode::invalid_input, {"rule.others.groups has 3", "12 elements"},
         {.elements = {.groups = two}, .others = {.groups = three}});
  const std::vector<ContactPair> pairs{{0, 1}};
  const ExclusionList of_one_set(pairs, 2), of_more(pairs, 2, 13);
  expect(ErrorCode::wrong_usage, {"exclusions of one set for two sets"},
         {.exclusions = &of_one_set});
  expect(ErrorCode::invalid_input, {"2 and 13 elements", "2 and 12"}, {.exclusions = &of_more});
}

}  // namespace
}  // namespace abut::testing
