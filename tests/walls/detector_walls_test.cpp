// Contacts with walls from a Detector: those of the free function at every step, whatever moves.

#include "support/error_expectations.hpp"
#include "walls/mesh_scenes.hpp"
#include "walls/mesh_search.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

constexpr Quantities some_quantities = Quantity::gap | Quantity::point;

void expect_same(const MeshContactList& found, const MeshContactList& expected) {
  ASSERT_TRUE(std::ranges::equal(found.contacts(), expected.contacts()))
      << found.size() << " found, " << expected.size() << " expected";
  ASSERT_TRUE(std::ranges::equal(found.shifts(), expected.shifts()));
  ASSERT_TRUE(std::ranges::equal(found.gaps(), expected.gaps()));
  ASSERT_TRUE(std::ranges::equal(found.points(), expected.points()));
  ASSERT_TRUE(found.normals().empty());
}

/// Compares a detector with the free function, for some numbers of threads.
class Steps {
 public:
  explicit Steps(double margin = 0.0) {
    for (const int threads : {1, 3}) {
      detectors_.emplace_back(Options{.shifts = Shifts::stored,
                                      .quantities = some_quantities,
                                      .margin = margin,
                                      .threads = threads});
    }
  }

  void step(const std::vector<Ball>& balls, const TriangleMesh& mesh) {
    for (Detector& detector : detectors_) {
      const MeshContactList expected = find_mesh_contacts(view_of(balls), mesh, detector.options());
      expect_same(detector.find_mesh_contacts(view_of(balls), mesh), expected);
      contacts_ += expected.size();
    }
  }

  [[nodiscard]] std::size_t contacts() const { return contacts_; }

 private:
  std::vector<Detector> detectors_;
  std::size_t contacts_ = 0;
};

Motion turned(double angle, const Point& translation) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{{c, -s, 0.0}, {s * 0.6, c * 0.6, -0.8}, {s * 0.8, c * 0.8, 0.6}}}, translation};
}

std::vector<Ball> scattered_balls(Random& random, std::size_t count, double width) {
  std::vector<Ball> balls;
  for (std::size_t k = 0; k < count; ++k) {
    Ball ball{{}, random.uniform(0.05, 0.3)};
    for (double& x : ball.center) x = random.uniform(-width, width);
    balls.push_back(ball);
  }
  return balls;
}

TEST(DetectorWalls, StandMoveAndDeform) {
  Random random(1701);
  MeshArrays arrays = soup(random, 40, 60, 6);
  TriangleMesh mesh = arrays.mesh();
  Steps steps(0.1);
  for (int step = 0; step < 60; ++step) {
    std::vector<Ball> balls = scattered_balls(random, 500, 7.0);
    if (step % 10 == 9) balls[7].radius = 0.1 * step;
    if (step >= 10 && step < 40) {
      mesh.move(turned(0.1 * step, {0.02 * step, -0.5, 0.3}));
    } else if (step >= 40) {
      for (Point& vertex : arrays.vertices) {
        for (double& x : vertex) x += random.uniform(-0.05, 0.05);
      }
      mesh.deform(arrays.vertices);
      if (step % 2 == 1) mesh.move(turned(1.0, {}));
    }
    steps.step(balls, mesh);
  }
  EXPECT_GT(steps.contacts(), 4000U);
}

TEST(DetectorWalls, TakeAnyMotionAndAnyMesh) {
  Random random(1702);
  Steps steps;
  for (int round = 0; round < 30; ++round) {
    TriangleMesh mesh = soup(random, 12, 20, 4).mesh();
    const double stretch = std::ldexp(1.0, round % 7 - 3);
    mesh.move({{{{-stretch, 0.25, 0.0}, {0.0, stretch, 0.0}, {0.125, 0.0, 1.0}}}, {1.0, 0.0, 2.0}});
    steps.step(scattered_balls(random, 600, 6.0), mesh);
    steps.step({}, mesh);
    steps.step(scattered_balls(random, 60, 6.0), MeshArrays{}.mesh());
  }
  EXPECT_GT(steps.contacts(), 200U);
}

TEST(DetectorWalls, AtEveryScale) {
  Random random(1703);
  for (const int exponent : {-1060, -600, -300, 300, 600, 1010}) {
    MeshArrays arrays = soup(random, 12, 20, 4);
    std::vector<Ball> balls = scattered_balls(random, 900, 4.0);
    for (Point& vertex : arrays.vertices) {
      for (double& x : vertex) x = std::ldexp(x, exponent);
    }
    for (Ball& ball : balls) {
      for (double& x : ball.center) x = std::ldexp(x, exponent);
      ball.radius = std::ldexp(ball.radius, exponent);
    }
    TriangleMesh mesh = arrays.mesh();
    Steps steps;
    steps.step(balls, mesh);
    mesh.move({{{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}}, {}});
    steps.step(balls, mesh);
    EXPECT_GT(steps.contacts(), 10U) << exponent;
  }
}

TEST(DetectorWalls, InPeriodicDomainsAndUnderARule) {
  Random random(1704);
  const MeshArrays arrays = soup(random, 12, 20, 4);
  const std::vector<Ball> balls = scattered_balls(random, 60, 6.0);
  const Domain cell = Domain::periodic({5.0, 6.0, 7.0});
  Detector detector(Options{.shifts = Shifts::stored, .quantities = some_quantities});
  expect_same(detector.find_mesh_contacts(view_of(balls), arrays.mesh(), cell),
              find_mesh_contacts(view_of(balls), arrays.mesh(), cell, detector.options()));
  const std::vector<ContactPair> denied{{1, 2}, {3, 4}};
  const ExclusionList list(denied, balls.size(), arrays.triangles.size());
  Options options = detector.options();
  options.rule.exclusions = &list;
  detector.set_options(options);
  expect_same(detector.find_mesh_contacts(view_of(balls), arrays.mesh()),
              find_mesh_contacts(view_of(balls), arrays.mesh(), options));
}

TEST(DetectorWalls, OfBoxesAreThoseOfTheFreeFunction) {
  const std::vector<double> zero{0.0}, one{1.0}, high{1.2};
  const ElementView balls = spheres(zero, zero, high, 0.5);
  const ElementView solids = boxes(zero, zero, zero, one, one, one);
  Detector detector(Options{.quantities = some_quantities});
  const BoxContactList& list = detector.find_box_contacts(balls, solids);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0], find_box_contacts(balls, solids)[0]);
  EXPECT_EQ(list.points()[0], (Vector{0.0, 0.0, 1.0}));
}

TEST(DetectorWalls, ReadNumbersHoweverTheyLie) {
  Random random(1706);
  const TriangleMesh mesh = soup(random, 40, 60, 6).mesh();
  const std::size_t count = 1300;
  std::vector<double> x(count), y(count), z(count), r(count);
  std::vector<std::array<float, 3>> singles(count);
  for (std::size_t k = 0; k < count; ++k) {
    singles[k] = {static_cast<float>(x[k] = random.uniform(-1.0, 7.0)),
                  static_cast<float>(y[k] = random.uniform(-1.0, 7.0)),
                  static_cast<float>(z[k] = random.uniform(-1.0, 7.0))};
    r[k] = random.uniform(0.05, 0.3);
  }
  const ElementView views[] = {spheres(x, y, z, r), spheres(x, y, z, 0.25),
                               spheres(singles, 0.25F)};
  Detector detector(Options{.shifts = Shifts::stored, .quantities = some_quantities});
  for (const ElementView& view : views) {
    const MeshContactList expected = find_mesh_contacts(view, mesh, detector.options());
    EXPECT_GT(expected.size(), 100U);
    expect_same(detector.find_mesh_contacts(view, mesh), expected);
  }
  r[1000] = -0.5;
  expect_error(ErrorCode::invalid_input, {"element 1000", "radius = -0.5"},
               [&] { static_cast<void>(detector.find_mesh_contacts(views[0], mesh)); });
}

/// A mesh that moves rigidly keeps its grid, and one that is deformed by little does.
TEST(DetectorWalls, BuildTheGridOnce) {
  Random random(1705);
  MeshArrays arrays = flat_grid(20);
  TriangleMesh mesh = arrays.mesh();
  const std::vector<Ball> balls = scattered_balls(random, 300, 20.0);
  walls::MeshSearch search;
  std::vector<MeshContact> contacts;
  std::vector<ImageShift> shifts;
  PairGeometry geometry;
  const auto find = [&] {
    static_cast<void>(search.find(view_of(balls), mesh, {}, {contacts, shifts, geometry}));
  };
  for (int step = 0; step < 50; ++step) {
    mesh.move(turned(0.37 * step, {0.5 * step, 1.0, -3.0}));
    find();
  }
  EXPECT_EQ(search.builds(), 1U);
  for (int step = 0; step < 20; ++step) {
    arrays.vertices[7][2] += 0.005;
    mesh.deform(arrays.vertices);
    mesh.move(turned(0.37 * step, {}));
    find();
  }
  EXPECT_LE(search.builds(), 3U);
  EXPECT_GE(search.builds(), 2U);
}

TEST(DetectorWalls, AreEmptyAfterAnError) {
  const MeshArrays arrays = cube();
  std::vector<Ball> balls{{{0, 0, 1.5}, 1.0}, {{0, 0, 1.5}, 1.0}};
  Detector detector(Options{.quantities = Quantity::gap});
  const MeshContactList& list = detector.find_mesh_contacts(view_of(balls), arrays.mesh());
  EXPECT_EQ(list.size(), 2U);
  balls[1].center[1] = std::numeric_limits<double>::quiet_NaN();
  expect_error(ErrorCode::invalid_input, {"element 1", "y = nan"}, [&] {
    static_cast<void>(detector.find_mesh_contacts(view_of(balls), arrays.mesh()));
  });
  EXPECT_TRUE(list.empty());
  EXPECT_TRUE(list.gaps().empty());
  balls.pop_back();
  EXPECT_EQ(detector.find_mesh_contacts(view_of(balls), arrays.mesh()).size(), 1U);
  Options options = detector.options();
  options.max_pairs = 0;
  detector.set_options(options);
  expect_error(ErrorCode::limit_exceeded, {"1 contacts"}, [&] {
    static_cast<void>(detector.find_mesh_contacts(view_of(balls), arrays.mesh()));
  });
}

}  // namespace
}  // namespace abut::testing
