// Spheres against triangle meshes in periodic domains: against all images in rational numbers, and
// what must not change a contact.

#include "support/error_expectations.hpp"
#include "walls/mesh_scenes.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using Contacts = std::vector<MovedContact>;

/// So many times each vector of a domain.
using Cells = std::array<int, 3>;

Point moved(Point point, const Domain& domain, const Cells& cells) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] += cells[k] * domain.vector(static_cast<int>(k))[axis];
    }
  }
  return point;
}

/// From -most to most along each periodic axis.
Cells random_cells(Random& random, const Domain& domain, int most) {
  Cells cells{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!domain.is_periodic(static_cast<int>(k))) continue;
    cells[k] = static_cast<int>(random.below(static_cast<std::size_t>(2 * most) + 1)) - most;
  }
  return cells;
}

/// Whole numbers and eighths: moving by their vectors is exact, and ties are frequent.
std::vector<Domain> coarse_domains() {
  return {Domain::periodic({4.0, 5.0, 3.0}),
          Domain::periodic({4.0, unbounded, 3.0}),
          Domain::periodic({unbounded, unbounded, 2.5}),
          Domain::lattice({4, 0, 0}, {1, 5, 0}, {-2, 1.5, 3}),
          Domain::lattice({0, 5, 0}, {4, 0, 0}, {0, 0, 3}),
          Domain::lattice({0, 4, 4}, {4, 0, 4}, {4, 4, 0}, Axes::xz),
          Domain::lees_edwards({4.0, 5.0, 3.0}, 2.5)};
}

/// The oracle looks at as many cells as spheres of reach 3 around the mesh, moved by up to two
/// cells, can need in any of the domains here.
constexpr std::int32_t enough = 6;

TEST(PeriodicMesh, SoupsInAllKindsOfDomains) {
  Random random(71);
  std::size_t kinds[4] = {};
  std::size_t with_shift = 0;
  for (int round = 0; round < 2; ++round) {
    for (const Domain& domain : coarse_domains()) {
      MeshArrays arrays = soup(random, 5 + random.below(4), 3 + random.below(8), 3);
      std::vector<Ball> balls = balls_in(random, 10, 3);
      for (Ball& ball : balls) {
        ball.center = moved(ball.center, domain, random_cells(random, domain, 2));
      }
      if (round == 1) shake(arrays, balls, random);
      const double margin = round == 0 ? 0.5 : 0.0;
      const Contacts expected = oracle_mesh_contacts(
          balls, arrays, {.domain = domain, .margin = margin, .farthest = enough});
      ASSERT_EQ(agreed_contacts(view_of(balls), arrays.mesh(), domain, {.margin = margin}),
                expected);
      for (const MovedContact& one : expected) {
        ++kinds[static_cast<std::size_t>(one.contact.feature.kind)];
        with_shift += one.shift != ImageShift{} ? 1 : 0;
      }
    }
  }
  EXPECT_GT(kinds[1], 50U);
  EXPECT_GT(kinds[2], 50U);
  EXPECT_GT(kinds[3], 50U);
  EXPECT_GT(with_shift, 200U);
}

/// Cells narrower than a triangle, reaches of several cells: several images of one triangle, and
/// features that are nearest in one image and not in another.
TEST(PeriodicMesh, ReachesAndTrianglesBeyondTheCell) {
  Random random(72);
  const struct {
    Domain domain;
    std::int32_t farthest;
  } cases[] = {{Domain::periodic({1.0, 4.0, unbounded}), 10},
               {Domain::periodic({2.0, 2.0, 2.0}), 6},
               {Domain::lattice({1.5, 0, 0}, {4.25, 1, 0}, {0, 0, 4}, Axes::xy), 24}};
  std::size_t several = 0;
  for (const auto& [domain, farthest] : cases) {
    const MeshArrays arrays = soup(random, 9, 5, 3);
    std::vector<Ball> balls = balls_in(random, 4, 2);
    for (Ball& ball : balls) ball.radius = 2.0;
    const Contacts expected =
        oracle_mesh_contacts(balls, arrays, {.domain = domain, .farthest = farthest});
    several += expected.size();
    ASSERT_EQ(agreed_contacts(view_of(balls), arrays.mesh(), domain), expected);
  }
  EXPECT_GT(several, 60U);
}

/// The lattice vectors are no short numbers: whole vectors added to a position are rounded, and the
/// oracle takes what came out.
TEST(PeriodicMesh, LatticesOfAllBits) {
  Random random(73);
  for (int round = 0; round < 6; ++round) {
    const auto number = [&](double x) { return x + random.uniform(-0.2, 0.2); };
    const Domain domain =
        Domain::lattice({number(4), number(0), number(0)}, {number(1), number(-5), number(0)},
                        {number(0), number(1), number(3)});
    MeshArrays arrays = soup(random, 6, 8, 3);
    std::vector<Ball> balls = balls_in(random, 8, 3);
    shake(arrays, balls, random);
    for (Ball& ball : balls) {
      ball.center = moved(ball.center, domain, random_cells(random, domain, 2));
    }
    const Contacts expected =
        oracle_mesh_contacts(balls, arrays, {.domain = domain, .farthest = enough});
    ASSERT_FALSE(expected.empty());
    ASSERT_EQ(agreed_contacts(view_of(balls), arrays.mesh(), domain), expected);
  }
}

TEST(PeriodicMesh, MovingBallsByLatticeVectorsChangesTheirShiftsOnly) {
  Random random(74);
  for (const Domain& domain : coarse_domains()) {
    const TriangleMesh mesh = soup(random, 8, 12, 3).mesh();
    std::vector<Ball> balls = balls_in(random, 60, 3);
    Contacts expected = agreed_contacts(view_of(balls), mesh, domain);
    ASSERT_FALSE(expected.empty());
    std::vector<Cells> cells;
    for (Ball& ball : balls) {
      cells.push_back(random_cells(random, domain, 1000000));
      ball.center = moved(ball.center, domain, cells.back());
    }
    for (auto& [contact, shift] : expected) {
      const auto& [x, y, z] = cells[contact.sphere];
      shift = {shift.x + x, shift.y + y, shift.z + z};
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(agreed_contacts(view_of(balls), mesh, domain), expected);
  }
}

TEST(PeriodicMesh, MovingTheMeshByLatticeVectorsChangesShiftsOnly) {
  Random random(75);
  for (const Domain& domain : coarse_domains()) {
    MeshArrays arrays = soup(random, 8, 12, 3);
    const std::vector<Ball> balls = balls_in(random, 60, 3);
    Contacts expected = agreed_contacts(view_of(balls), arrays.mesh(), domain);
    const Cells cells = random_cells(random, domain, 1000000);
    for (Point& vertex : arrays.vertices) vertex = moved(vertex, domain, cells);
    for (auto& [contact, shift] : expected) {
      shift = {shift.x - cells[0], shift.y - cells[1], shift.z - cells[2]};
    }
    EXPECT_EQ(agreed_contacts(view_of(balls), arrays.mesh(), domain), expected);
  }
}

/// Triangles apart from each other and balls, all of them twice, in a cell twice as long.
TEST(PeriodicMesh, TwiceTheCellHasTwiceTheContacts) {
  Random random(76);
  const Domain once = Domain::lattice({4, 0, 0}, {1, 5, 0}, {-2, 1.5, 3});
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    std::array<Domain::Vector, 3> vectors{once.vector(0), once.vector(1), once.vector(2)};
    for (double& x : vectors[axis]) x *= 2.0;
    const Domain twice = Domain::lattice(vectors[0], vectors[1], vectors[2]);
    MeshArrays arrays = soup(random, 24, 0, 3);
    for (int t = 0; t < 8; ++t) arrays.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    std::vector<Ball> balls = balls_in(random, 40, 3);
    const std::size_t contacts = agreed_contacts(view_of(balls), arrays.mesh(), once).size();
    ASSERT_GT(contacts, 100U);
    Cells one{};
    one[axis] = 1;
    for (int t = 8; t < 16; ++t) arrays.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    for (std::size_t v = 0; v < 24; ++v) {
      arrays.vertices.push_back(moved(arrays.vertices[v], once, one));
    }
    for (std::size_t b = 0; b < 40; ++b) {
      balls.push_back({moved(balls[b].center, once, one), balls[b].radius});
    }
    EXPECT_EQ(agreed_contacts(view_of(balls), arrays.mesh(), twice).size(), 2 * contacts);
  }
}

/// Exactly at their radius from a wall in the face of the cell: on this side of it, on the other
/// side, cells away; over faces, edges and vertices.
TEST(PeriodicMesh, TiesAtTheFacesOfTheCell) {
  MeshArrays grid = flat_grid(2);
  const TriangleMesh mesh = grid.mesh();
  const Domain domain = Domain::periodic({unbounded, unbounded, 4.0});
  std::vector<Ball> balls;
  for (const double z : {1.0, 3.0, -1.0, 401.0, -397.0}) {
    for (int y = 0; y <= 8; ++y) {
      for (int x = 0; x <= 8; ++x) balls.push_back({{x * 0.25, y * 0.25, z}, 1.0});
    }
  }
  const Contacts contacts = agreed_contacts(view_of(balls), mesh, domain);
  ASSERT_EQ(contacts.size(), balls.size());
  const std::int32_t images[] = {0, 1, 0, 100, -99};
  for (std::size_t k = 0; k < balls.size(); ++k) {
    EXPECT_EQ(contacts[k].contact.sphere, k);
    EXPECT_EQ(contacts[k].contact.feature, contacts[k % 81].contact.feature);
    EXPECT_EQ(contacts[k].shift, (ImageShift{0, 0, images[k / 81]}));
  }
  for (Ball& ball : balls) ball.radius = std::nextafter(1.0, 0.0);
  EXPECT_TRUE(agreed_contacts(view_of(balls), mesh, domain).empty());
  // In the middle between two images both are touched.
  for (Ball& ball : balls) ball = {{ball.center[0], ball.center[1], 2.0}, 2.0};
  EXPECT_EQ(agreed_contacts(view_of(balls), mesh, domain).size(), 2 * balls.size());
}

/// Images know nothing of each other: over the seam between two of them both borders are touched.
TEST(PeriodicMesh, OverASeamBothImagesAreTouched) {
  const TriangleMesh floor = flat_grid(2).mesh();
  const Domain domain = Domain::periodic({2.0, 2.0, unbounded});
  const std::vector<Ball> balls{{{0.0, 0.75, 1.0}, 1.0}, {{0.5, 0.75, 1.0}, 1.0}};
  const Contacts contacts = agreed_contacts(view_of(balls), floor, domain);
  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_EQ(count_of(contacts, FeatureKind::edge), 2U);
  EXPECT_NE(contacts[0].contact.feature, contacts[1].contact.feature);
  EXPECT_EQ(contacts[2].contact.sphere, 1U);
}

TEST(PeriodicMesh, AnOpenDomainIsOpenSpace) {
  Random random(77);
  const TriangleMesh mesh = soup(random, 8, 12, 3).mesh();
  const std::vector<Ball> balls = balls_in(random, 60, 3);
  const MeshContactList plain = find_mesh_contacts(view_of(balls), mesh);
  EXPECT_TRUE(plain.shifts().empty());
  Contacts expected;
  for (const MeshContact& contact : plain) expected.push_back({contact, {}});
  EXPECT_GT(expected.size(), 30U);
  EXPECT_EQ(agreed_contacts(view_of(balls), mesh, Domain::open()), expected);
  const Domain wide = Domain::periodic({1e6, 1e6, 1e6});
  EXPECT_EQ(agreed_contacts(view_of(balls), mesh, wide), expected);
}

/// Without shifts a contact with several images is listed as often.
TEST(PeriodicMesh, ShiftsAreStoredIfAskedFor) {
  const MeshArrays arrays{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<Ball> one{{{0.25, 0.25, 1.0}, 1.0}};
  const Domain domain = Domain::periodic({unbounded, unbounded, 2.0});
  const MeshContactList list = find_mesh_contacts(view_of(one), arrays.mesh(), domain);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0], list[1]);
  EXPECT_TRUE(list.shifts().empty());
  const Contacts stored = agreed_contacts(view_of(one), arrays.mesh(), domain);
  ASSERT_EQ(stored.size(), 2U);
  EXPECT_EQ(stored[0].shift, (ImageShift{0, 0, 0}));
  EXPECT_EQ(stored[1].shift, (ImageShift{0, 0, 1}));
}

TEST(PeriodicMesh, OfNothing) {
  const Domain domain = Domain::periodic({4.0, 4.0, 4.0});
  const std::vector<Ball> one{{{8, 8, 8}, 1.0}};
  const MeshArrays nothing;
  EXPECT_TRUE(agreed_contacts(view_of({}), nothing.mesh(), domain).empty());
  EXPECT_TRUE(agreed_contacts(view_of(one), nothing.mesh(), domain).empty());
  EXPECT_TRUE(agreed_contacts(view_of({}), cube().mesh(), domain).empty());
  EXPECT_EQ(agreed_contacts(view_of(one), cube().mesh(), domain).size(), 6U);
}

class PeriodicMeshErrors : public ::testing::Test {
 protected:
  static void expect(ErrorCode code, std::initializer_list<std::string_view> words,
                     const std::vector<Ball>& balls, const Domain& domain,
                     const Options& options = {}) {
    const TriangleMesh mesh = cube().mesh();
    expect_error(code, words, [&] {
      static_cast<void>(find_mesh_contacts(view_of(balls), mesh, domain, options));
    });
  }
};

/// The sphere is named, by its own number, also where those before it are left out.
TEST_F(PeriodicMeshErrors, TooFarOut) {
  const Domain strip = Domain::periodic({1.0, unbounded, unbounded});
  const std::vector<Ball> balls{{{0, 0, 99}, 1.0}, {{0, 0, 0}, 1.0}, {{0x1p33, 0, 0}, 1.0}};
  expect(ErrorCode::invalid_input, {"element 2 has x = 8589934592", "2147483647 cells"}, balls,
         strip);
  const std::vector<Ball> wide{{{0, 0, 99}, 1.0}, {{0, 0, 0}, 1.0}, {{0, 0, 0}, 0x1p33}};
  expect(ErrorCode::invalid_input, {"element 2 has radius", "2147483647 cells"}, wide, strip);
  const std::vector<Ball> apart{
      {{0, 0, 99}, 1.0}, {{-0x1.fffffp30, 0, 0}, 1.0}, {{0x1.fffffp30, 0, 0}, 1.0}};
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    expect(ErrorCode::invalid_input, {"elements 1 and 2 pair", "2147483647 lattice vectors"}, apart,
           strip, {.algorithm = algorithm});
  }
}

TEST_F(PeriodicMeshErrors, BadDomainsAlgorithmsAndNumbers) {
  const Domain block = Domain::periodic({4.0, 4.0, 4.0});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect(ErrorCode::wrong_usage, {"domain of 2 dimensions"}, {{{0, 0, 0}, 1.0}},
         Domain::periodic({4.0, 4.0}));
  expect(ErrorCode::wrong_usage, {"binary_tree", "does not support periodic"}, {{{0, 0, 0}, 1.0}},
         block, {.algorithm = Algorithm::binary_tree});
  expect(ErrorCode::invalid_input, {"element 1", "y = nan"}, {{{0, 0, 0}, 1.0}, {{0, nan, 0}, 1.0}},
         block);
  expect(ErrorCode::limit_exceeded, {"contacts", "limit", "1"}, {{{0, 0, 0}, 2.0}}, block,
         {.max_pairs = 1});
}

}  // namespace
}  // namespace abut::testing
