// Data of contacts with walls through time: what a sphere takes along from feature to feature, and
// what it leaves behind.

#include "support/allocation_faults.hpp"
#include "support/error_expectations.hpp"
#include "walls/mesh_scenes.hpp"

#include <abut/detector.hpp>
#include <abut/wall_history.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

std::vector<PairCount> counts(std::span<const PairCount> numbers) {
  return {numbers.begin(), numbers.end()};
}

/// Balls, a mesh and the ages of their contacts.
class Followed {
 public:
  Followed(TriangleMesh given, std::vector<Ball> some, Domain cell = Domain::open())
      : mesh(std::move(given)), balls(std::move(some)), domain(std::move(cell)) {}

  /// Returns the ages of the contacts of this step, 1 for one that is new.
  std::vector<int> step() {
    const MeshContactList& list = detector_.find_mesh_contacts(view_of(balls), mesh, domain);
    history.update(list, view_of(balls), mesh, domain, ids);
    last.assign(list.begin(), list.end());
    for (int& age : history.values()) ++age;
    return {history.values().begin(), history.values().end()};
  }

  /// Moves the first ball there, and steps.
  std::vector<int> step_to(const Point& center) {
    balls[0].center = center;
    return step();
  }

  TriangleMesh mesh;
  std::vector<Ball> balls;
  Domain domain;
  std::vector<std::uint64_t> ids;
  MeshContactHistory<int> history;
  std::vector<MeshContact> last;

 private:
  Detector detector_{Options{.shifts = Shifts::stored}};
};

using Ages = std::vector<int>;

TEST(WallHistory, GoesOverAFloorAsIfItWereOnePiece) {
  // By eighths, so that centers come to lie over edges and vertices exactly.
  for (const Point& way : {Point{0.125, 0, 0}, Point{0.125, 0.125, 0}, Point{0.125, 0.0625, 0}}) {
    Followed rolling(flat_grid(4).mesh(), {{{0.125, 0.25, 0.9}, 1.0}});
    std::size_t kinds[4] = {};
    PairCount passed_on = 0;
    for (int age = 1; age <= 28; ++age) {
      ASSERT_EQ(rolling.step(), Ages{age});
      EXPECT_EQ(rolling.history.kept(), age == 1 ? 0U : 1U);
      EXPECT_EQ(rolling.history.born().size(), age == 1 ? 1U : 0U);
      EXPECT_TRUE(rolling.history.lost().empty());
      ++kinds[static_cast<std::size_t>(rolling.last[0].feature.kind)];
      passed_on += rolling.history.passed_on().size();
      for (std::size_t axis = 0; axis < 3; ++axis) rolling.balls[0].center[axis] += way[axis];
    }
    EXPECT_GT(kinds[static_cast<std::size_t>(FeatureKind::face)], 10U);
    EXPECT_GT(passed_on, 3U);
  }
}

TEST(WallHistory, GoesOnWhereItIsMovedTo) {
  Followed rolling(flat_grid(4).mesh(), {{{0.125, 0.25, 0.9}, 1.0}});
  rolling.step();
  MeshContactHistory<int> moved(std::move(rolling.history));
  rolling.history = std::move(moved);
  EXPECT_EQ(rolling.step(), Ages{2});
}

TEST(WallHistory, GoesAroundAnOuterEdge) {
  const Point top{0.5, 0, 1.9}, over_the_edge{1.5, 0, 1.5}, side{1.9, 0, 0.5};
  Followed slow(cube().mesh(), {{top, 1.0}});
  EXPECT_EQ(slow.step(), Ages{1});
  EXPECT_EQ(slow.step_to(over_the_edge), Ages{2});
  EXPECT_EQ(slow.last[0].feature.kind, FeatureKind::edge);
  EXPECT_EQ(counts(slow.history.passed_on()), std::vector<PairCount>{0});
  EXPECT_EQ(slow.step_to(side), Ages{3});
  // From face to face in one step, near the edge: of a small sphere the directions to both agree.
  Followed leaping(cube().mesh(), {{{0.95, 0.3, 1.9}, 1.0}});
  leaping.step();
  EXPECT_EQ(leaping.step_to({1.9, 0.3, 0.95}), Ages{2});
  // Far over the edge the old face lies in another direction.
  Followed far(cube().mesh(), {{{0.9, 0.3, 1.9}, 1.0}});
  far.step();
  EXPECT_EQ(far.step_to({1.25, 0.3, 0.0}), Ages{1});
  ASSERT_EQ(far.history.lost().size(), 1U);
  EXPECT_EQ(far.history.lost()[0].value, 1);
}

/// A floor, and a wall that stands on its border.
MeshArrays floor_and_wall(double angle) {
  const double x = 2.0 + 4.0 * std::cos(angle), z = 4.0 * std::sin(angle);
  return {{{-2, -2, 0}, {2, -2, 0}, {-2, 2, 0}, {2, 2, 0}, {x, -2, z}, {x, 2, z}},
          {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {3, 4, 5}}};
}

TEST(WallHistory, InACornerEachWallHasItsOwn) {
  Followed corner(floor_and_wall(std::numbers::pi / 2).mesh(), {{{0, 0.5, 0.9}, 1.0}});
  EXPECT_EQ(corner.step(), Ages{1});
  EXPECT_EQ(corner.step_to({1.1, 0.5, 0.9}), (Ages{2, 1})) << "the wall is new";
  EXPECT_EQ(corner.step_to({1.1, 0.5, 1.1}), Ages{2}) << "the floor is left, the wall goes on";
  EXPECT_EQ(corner.history.lost().size(), 1U);
  EXPECT_TRUE(corner.history.passed_on().empty());
  // From the floor to the wall in one step: they meet, but in no smooth surface.
  EXPECT_EQ(corner.step_to({0.9, 0.5, 0.9}), Ages{1});
  EXPECT_EQ(corner.history.lost().size(), 1U);
}

/// A sphere in a shallow groove touches both faces for a while: two contacts, each with its own
/// value. A caller who keeps the deeper one alone has one contact, which goes on.
TEST(WallHistory, OfAGrooveTheDeeperSideMayGoOn) {
  const TriangleMesh groove = floor_and_wall(0.2).mesh();
  std::vector<Ball> balls{{{1.7, 0.5, 0.95}, 1.0}};
  MeshContactHistory<int> of_all, of_the_deepest;
  std::size_t both = 0;
  int age = 0;
  for (; age < 25; ++age) {
    const MeshContactList list =
        find_mesh_contacts(view_of(balls), groove, Domain::open(), {.quantities = Quantity::gap});
    of_all.update(list, view_of(balls), groove);
    both += list.size() == 2 ? 1U : 0U;
    const std::size_t deepest = list.size() == 2 && list.gaps()[1] < list.gaps()[0] ? 1 : 0;
    of_the_deepest.update(list.contacts().subspan(deepest, 1), view_of(balls), groove);
    ASSERT_EQ(of_the_deepest.values()[0], age);
    ++of_the_deepest.values()[0];
    for (int& value : of_all.values()) ++value;
    balls[0].center[0] += 0.02;
  }
  EXPECT_GT(both, 3U);
  EXPECT_LT(of_all.values()[0], age);
}

/// Contacts that a caller makes up: each of three goes to the next one, so to say.
MeshContactHistory<int> after(const MeshArrays& arrays, const std::vector<Ball>& balls,
                              const std::vector<MeshContact>& before,
                              const std::vector<MeshContact>& now) {
  MeshContactHistory<int> history;
  const TriangleMesh mesh = arrays.mesh();
  history.update(std::span<const MeshContact>(before), view_of(balls), mesh);
  for (std::size_t k = 0; k < before.size(); ++k) history.values()[k] = 10 + static_cast<int>(k);
  history.update(std::span<const MeshContact>(now), view_of(balls), mesh);
  return history;
}

std::vector<int> values_of(const MeshContactHistory<int>& history) {
  return {history.values().begin(), history.values().end()};
}

TEST(WallHistory, OfSeveralTheNearestDirectionGoesOn) {
  constexpr FeatureKind face = FeatureKind::face;
  // Three triangles around the vertex 0; the center stands over the second.
  const MeshArrays fan{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {-4, 4, 0}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 2, 3}}};
  const std::vector<Ball> ball{{{0.5, 2.0, 1.0}, 1.0}};
  // The way to face 2 is 0.5 to the side, the way to face 0 more.
  EXPECT_EQ(values_of(after(fan, ball, {{0, {face, 0}}, {0, {face, 2}}}, {{0, {face, 1}}})),
            std::vector<int>{11});
  // Of two new ones the one beside which the old one lies.
  EXPECT_EQ(values_of(after(fan, ball, {{0, {face, 1}}}, {{0, {face, 0}}, {0, {face, 2}}})),
            (std::vector<int>{0, 10}));
  // Two to two: the nearest first, the others with what is left.
  const std::vector<Ball> higher{{{0.5, 2.0, 2.0}, 1.0}};
  EXPECT_EQ(values_of(after(fan, higher, {{0, {face, 0}}, {0, {face, 2}}},
                            {{0, {face, 1}}, {0, {face, 3}}})),
            (std::vector<int>{11, 10}));
  // The same way from both: the first place.
  const std::vector<Ball> middle{{{0.0, 0.0, 1.0}, 1.0}};
  EXPECT_EQ(values_of(after(fan, middle, {{0, {face, 0}}, {0, {face, 2}}}, {{0, {face, 1}}})),
            std::vector<int>{10});
  EXPECT_EQ(values_of(after(fan, middle, {{0, {face, 1}}}, {{0, {face, 0}}, {0, {face, 2}}})),
            (std::vector<int>{10, 0}));
  // A vertex in common is needed, and one sphere.
  EXPECT_EQ(values_of(after(fan, ball, {{0, {face, 2}}},
                            {{0, {FeatureKind::vertex, 1}}, {0, {FeatureKind::vertex, 2}}})),
            (std::vector<int>{0, 0}));
  EXPECT_EQ(values_of(after(fan, {ball[0], ball[0]}, {{0, {face, 0}}}, {{1, {face, 1}}})),
            std::vector<int>{0});
  // A center on the mesh has no direction.
  EXPECT_EQ(values_of(after(fan, {{{0, 0, 0}, 1.0}}, {{0, {face, 0}}}, {{0, {face, 1}}})),
            std::vector<int>{0});
}

TEST(WallHistory, FollowsAMeshThatTurnsWithItsSpheres) {
  Followed turning(cube().mesh(),
                   {{{0.1, 0.3, 1.4}, 0.5}, {{1.4, 1.4, 0}, 0.6}, {{1.3, 1.3, 1.3}, 0.7}});
  const std::vector<Ball> at_rest = turning.balls;
  for (int step = 1; step <= 40; ++step) {
    const double c = std::cos(0.3 * step), s = std::sin(0.3 * step);
    turning.mesh.move({{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}, {0.1 * step, 0, 0}});
    for (std::size_t k = 0; k < turning.balls.size(); ++k) {
      const Point& x = at_rest[k].center;
      turning.balls[k].center = {c * x[0] - s * x[1] + 0.1 * step, s * x[0] + c * x[1], x[2]};
      turning.balls[k].radius = at_rest[k].radius + 0.01;
    }
    ASSERT_EQ(turning.step(), (Ages{step, step, step}));
    EXPECT_TRUE(turning.history.passed_on().empty());
  }
}

TEST(WallHistory, FollowsIdsThroughInsertionRemovalAndReordering) {
  Followed some(flat_grid(4).mesh(), {{{0.5, 0.2, 1}, 1}, {{1.5, 0.2, 1}, 1}, {{2.5, 0.2, 1}, 1}});
  some.ids = {30, 10, 20};
  some.step();
  for (std::size_t k = 0; k < 3; ++k) some.history.values()[k] = 100 + static_cast<int>(k);
  // 10 is gone, 15 is new, 20 comes before 30, which rolls on to the next triangle.
  some.balls = {{{2.5, 0.2, 1}, 1}, {{1.5, 0.2, 1}, 1}, {{0.5, 0.8, 1}, 1}};
  some.ids = {20, 15, 30};
  EXPECT_EQ(some.step(), (Ages{103, 1, 101}));
  EXPECT_EQ(counts(some.history.born()), std::vector<PairCount>{1});
  EXPECT_EQ(counts(some.history.passed_on()), std::vector<PairCount>{2});
  ASSERT_EQ(some.history.lost().size(), 1U);
  EXPECT_EQ(some.history.lost()[0].sphere, 10U);
  EXPECT_EQ(some.history.lost()[0].value, 101);
}

/// A floor as wide as a sheared cell, on which a sphere rolls through the faces and is put back.
TEST(WallHistory, GoesThroughTheFacesOfACell) {
  const Domain cell = Domain::lattice({4, 0, 0}, {1, 4, 0}, {0, 0, 9});
  MeshArrays floor = flat_grid(4);
  for (Point& vertex : floor.vertices) vertex[0] += 0.25 * vertex[1];
  Followed rolling(TriangleMesh::joined(floor.vertices, floor.triangles, cell),
                   {{{2.0, 2.0, 0.75}, 1.0}}, cell);
  std::size_t passed_on = 0;
  for (int step = 1; step <= 80; ++step) {
    ASSERT_EQ(rolling.step(), Ages{step});
    passed_on += rolling.history.passed_on().size();
    Point& center = rolling.balls[0].center;
    center[0] += 0.1875;
    center[1] += 0.125;
    if (center[1] > 4.0) center[0] -= 1.0, center[1] -= 4.0;
    if (center[0] > 5.0) center[0] -= 4.0;
    if (step == 40) center[2] -= 9.0;
  }
  EXPECT_GT(passed_on, 20U);
}

TEST(WallHistory, ImagesAreContactsOfTheirOwn) {
  const Domain cell = Domain::periodic({4.0, unbounded, unbounded});
  const MeshArrays wall{{{0, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 1, 2}}};
  Followed wide(wall.mesh(), {{{2.0, 1.0, 1.0}, 2.5}}, cell);
  EXPECT_EQ(wide.step(), (Ages{1, 1}));
  wide.history.values()[1] = 50;
  EXPECT_EQ(wide.step_to({13.5, 1.0, 1.0}), (Ages{2, 51})) << "3 cells on, and 0.5 back";
  EXPECT_EQ(wide.step_to({0.5, 1.0, 1.0}), Ages{3}) << "the second has gone out of reach";
}

TEST(WallHistory, RefusesWhatItCannotFollowAndStaysAsItIs) {
  Followed some(flat_grid(2).mesh(), {{{0.5, 0.2, 1}, 1}, {{1.5, 0.2, 1}, 1}});
  some.step();
  some.history.values()[1] = 7;
  const std::vector<MeshContact> list = some.last;
  const auto refused = [&](ErrorCode code, std::initializer_list<std::string_view> words,
                           const std::vector<MeshContact>& contacts, const TriangleMesh& mesh,
                           const Domain& domain, std::span<const std::uint64_t> ids) {
    expect_error(code, words, [&] {
      some.history.update(std::span<const MeshContact>(contacts), view_of(some.balls), mesh, domain,
                          ids);
    });
  };
  const std::vector<std::uint64_t> twice{5, 5}, few{5};
  const Domain open = Domain::open(), cell = Domain::periodic({9.0, 9.0, 9.0});
  const FeatureKind face = FeatureKind::face;
  using enum ErrorCode;
  refused(invalid_input, {"id 5"}, list, some.mesh, open, twice);
  refused(invalid_input, {"1 ids", "2 elements"}, list, some.mesh, open, few);
  refused(wrong_usage, {"contact 1", "order"}, {list[1], list[0]}, some.mesh, open, {});
  refused(wrong_usage, {"contact 1", "order"}, {list[1], list[1]}, some.mesh, open, {});
  refused(wrong_usage, {"sphere 2", "there are 2"}, {{2, {face, 0}}}, some.mesh, open, {});
  refused(wrong_usage, {"feature 8"}, {{0, {face, 8}}}, some.mesh, open, {});
  refused(wrong_usage, {"feature 0"}, {{0, {FeatureKind::interior, 0}}}, some.mesh, open, {});
  refused(wrong_usage, {"shifts"}, list, some.mesh, cell, {});
  refused(wrong_usage, {"2 dimensions"}, list, some.mesh, Domain::periodic({9.0, 9.0}), {});
  refused(wrong_usage, {"other triangles", "clear()"}, list, flat_grid(3).mesh(), open, {});
  expect_error(wrong_usage, {"three dimensions"}, [&] {
    const std::vector<double> zeros(2, 0.0);
    some.history.update(std::span<const MeshContact>(list), discs(zeros, zeros, 1.0), some.mesh);
  });
  EXPECT_EQ(some.history.born().size(), 2U);
  EXPECT_EQ(some.step(), (Ages{2, 8}));
  some.history.clear();
  some.mesh = flat_grid(3).mesh();
  EXPECT_EQ(some.step(), (Ages{1, 1}));
}

TEST(WallHistory, OfABoxIsThatOfTheWholeBox) {
  const std::vector<std::array<double, 3>> lower{{-1, -1, -1}, {3, -1, -1}},
      upper{{1, 1, 1}, {5, 1, 1}};
  std::vector<Ball> balls{{{0.5, 0, 1.9}, 1.0}};
  BoxContactHistory<int> history;
  const auto step = [&](const Point& center) {
    balls[0].center = center;
    const BoxContactList list = find_box_contacts(view_of(balls), boxes(lower, upper));
    history.update(list, view_of(balls));
    for (int& age : history.values()) ++age;
    return Ages(history.values().begin(), history.values().end());
  };
  EXPECT_EQ(step({0.5, 0, 1.9}), Ages{1});
  EXPECT_EQ(step({1.5, 0, 1.5}), Ages{2}) << "on an edge";
  EXPECT_EQ(step({2.0, 0, 0.5}), (Ages{3, 1})) << "between both";
  EXPECT_EQ(step({2.1, 0, 0.5}), Ages{2}) << "on the second";
  ASSERT_EQ(history.lost().size(), 1U);
  EXPECT_EQ(history.lost()[0].box, 0U);
  EXPECT_EQ(history.lost()[0].value, 3);
  const std::vector<BoxContact> wrong{{0, 1, {}}, {0, 0, {}}};
  expect_error(ErrorCode::wrong_usage, {"contact 1", "order"},
               [&] { history.update(std::span<const BoxContact>(wrong), view_of(balls)); });
  EXPECT_EQ(step({2.1, 0, 0.5}), Ages{3});
  history.clear();
  EXPECT_EQ(step({2.1, 0, 0.5}), Ages{1});
}

TEST(WallHistory, OfABoxFollowsAWrappedDisc) {
  const Domain cell = Domain::periodic({4.0, 4.0});
  const std::vector<std::array<double, 2>> lower{{0, 0}}, upper{{4, 1}};
  std::vector<double> x{3.9}, y{1.4};
  BoxContactHistory<int> history;
  const auto step = [&] {
    const ElementView disc = discs(x, y, 0.5);
    history.update(
        find_box_contacts(disc, rectangles(lower, upper), cell, {.shifts = Shifts::stored}), disc,
        cell);
  };
  step();
  ASSERT_EQ(history.values().size(), 2U) << "it lies over the next image, too";
  history.values()[0] = 3;
  history.values()[1] = 4;
  x[0] -= 4.0;
  step();
  EXPECT_EQ(history.kept(), 2U);
  EXPECT_EQ(std::vector<int>(history.values().begin(), history.values().end()),
            (std::vector<int>{3, 4}));
}

TEST(WallHistory, AllocatesNothingOnceItKnowsTheSize) {
  scenes::Random random(5);
  const TriangleMesh mesh = flat_grid(8).mesh();
  std::vector<Ball> first, second;
  for (int k = 0; k < 200; ++k) {
    first.push_back({{random.uniform(0, 8), random.uniform(0, 8), 0.5}, 0.6});
    second.push_back(first.back());
    second.back().center[0] += 0.3;
  }
  const MeshContactList before = find_mesh_contacts(view_of(first), mesh);
  const MeshContactList now = find_mesh_contacts(view_of(second), mesh);
  MeshContactHistory<Point> history;
  const auto both = [&] {
    history.update(before, view_of(first), mesh);
    history.update(now, view_of(second), mesh);
  };
  both(), both();
  EXPECT_GT(history.passed_on().size(), 20U);
  const AllocationFault watch;
  both();
  EXPECT_EQ(watch.requests(), 0U);
}

}  // namespace
}  // namespace abut::testing
