// The history of contacts with meshes against a map kept by hand, with the rule of handing over
// written down once more: features that have a vertex at one place, directions from `measure`.

#include "walls/mesh_scenes.hpp"

#include <abut/mesh_contacts.hpp>
#include <abut/wall_history.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// A contact by the id of its sphere and the image beside where the sphere has really got to.
struct Known {
  std::uint64_t id;
  MeshFeature feature;
  ImageShift image;

  friend auto operator<=>(const Known&, const Known&) = default;
};

/// Spheres that jump about over a landscape.
class Landscape {
 public:
  Landscape(const Domain& domain, const MeshArrays& arrays, double step, std::uint64_t seed)
      : domain_(domain),
        mesh_(TriangleMesh::joined(arrays.vertices, arrays.triangles, domain)),
        step_(step),
        random_(seed) {
    for (int k = 0; k < 60; ++k) add();
  }

  /// Moves, wraps, removes and adds spheres.
  void move() {
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      for (double& x : balls_[k].center) x += random_.uniform(-step_, step_);
      balls_[k].center[2] = std::fmin(std::fmax(balls_[k].center[2], -0.5), 2.0);
      if (domain_.is_periodic() && random_.below(3) == 0) wrap(k);
    }
    if (random_.below(3) == 0) remove(random_.below(balls_.size()));
    if (random_.below(3) == 0) add();
  }

  /// Updates the history and compares each value with that of the map.
  void compare() {
    const MeshContactList list =
        find_mesh_contacts(view_of(balls_), mesh_, domain_, {.shifts = Shifts::stored});
    history_.update(list, view_of(balls_), mesh_, domain_, ids_);
    std::map<Known, int> before;
    before.swap(known_);
    std::map<Known, int> rest = before;
    std::vector<std::size_t> born;
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (rest.erase(known(list, k)) == 0) born.push_back(k);
    }
    const auto from = handed_over(list, born, rest);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto here = before.find(known(list, k));
      const auto over = from.find(k);
      const int expected = here != before.end() ? here->second
                           : over != from.end() ? before.at(over->second)
                                                : 0;
      ASSERT_EQ(history_.values()[k], expected) << "contact " << k;
      history_.values()[k] = ++last_value_;
      known_[known(list, k)] = last_value_;
    }
    ASSERT_EQ(history_.passed_on().size(), from.size());
    ASSERT_EQ(history_.born().size(), born.size() - from.size());
    ASSERT_EQ(history_.kept(), list.size() - born.size() + from.size());
    expect_lost(before, rest, from);
    passed_on += from.size();
  }

  std::size_t passed_on = 0;
  std::size_t chosen = 0;  ///< handed over where there was a choice

 private:
  void add() {
    balls_.push_back({{random_.uniform(0, 6), random_.uniform(0, 6), random_.uniform(0.5, 1.5)},
                      random_.uniform(0.3, 0.9)});
    ids_.push_back(next_id_ += 3);
    cells_.emplace_back();
  }

  /// The last sphere takes its number.
  void remove(std::size_t k) {
    balls_[k] = balls_.back(), ids_[k] = ids_.back(), cells_[k] = cells_.back();
    balls_.pop_back(), ids_.pop_back(), cells_.pop_back();
  }

  /// Moves a sphere by lattice vectors and remembers by which.
  void wrap(std::size_t k) {
    const ImageShift n{static_cast<std::int32_t>(random_.below(3)) - 1,
                       static_cast<std::int32_t>(random_.below(3)) - 1, 0};
    balls_[k].center = moved(balls_[k].center, n);
    cells_[k] = {cells_[k].x + n.x, cells_[k].y + n.y, 0};
  }

  [[nodiscard]] Point moved(Point point, const ImageShift& n) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] += n.x * domain_.vector(0)[axis] + n.y * domain_.vector(1)[axis];
    }
    return point;
  }

  [[nodiscard]] Known known(const MeshContactList& list, std::size_t k) const {
    const ImageShift &n = list.shifts()[k], &w = cells_[list[k].sphere];
    return {ids_[list[k].sphere], list[k].feature, {n.x - w.x, n.y - w.y, n.z - w.z}};
  }

  [[nodiscard]] std::vector<Point> corners(const MeshFeature& feature, const ImageShift& n) const {
    std::vector<Point> points;
    const auto add = [&](const auto& vertices) {
      for (const ElementIndex v : vertices) points.push_back(moved(mesh_.vertices()[v], n));
    };
    if (feature.kind == FeatureKind::vertex) add(std::array{feature.number});
    if (feature.kind == FeatureKind::edge) add(mesh_.edges()[feature.number]);
    if (feature.kind == FeatureKind::face) add(mesh_.triangles()[feature.number]);
    return points;
  }

  [[nodiscard]] bool connected(const MeshFeature& a, const ImageShift& n, const MeshFeature& b,
                               const ImageShift& m) const {
    for (const Point& p : corners(a, n)) {
      for (const Point& q : corners(b, m)) {
        if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-9) return true;
      }
    }
    return false;
  }

  [[nodiscard]] double agreement(ElementIndex sphere, const MeshFeature& a, const ImageShift& n,
                                 const MeshFeature& b, const ImageShift& m) const {
    const std::array<MeshContact, 2> both{{{sphere, a}, {sphere, b}}};
    const std::array<ImageShift, 2> shifts{n, m};
    const VectorArray normal =
        measure(view_of(balls_), mesh_, {both, shifts}, Quantity::normal, domain_).normals;
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += normal[0][axis] * normal[1][axis];
    return sum;
  }

  /// Of new contacts what they go on from: the best of all pairs, again and again.
  std::map<std::size_t, Known> handed_over(const MeshContactList& list,
                                           const std::vector<std::size_t>& born,
                                           const std::map<Known, int>& rest) {
    std::map<std::pair<std::size_t, Known>, double> pairs;
    for (const std::size_t k : born) {
      const ElementIndex sphere = list[k].sphere;
      for (const auto& [gone, value] : rest) {
        if (gone.id != ids_[sphere]) continue;
        const ImageShift n{gone.image.x + cells_[sphere].x, gone.image.y + cells_[sphere].y, 0};
        if (!connected(list[k].feature, list.shifts()[k], gone.feature, n)) continue;
        const double sum = agreement(sphere, list[k].feature, list.shifts()[k], gone.feature, n);
        if (sum > 0.5) pairs[{k, gone}] = sum;
      }
    }
    std::map<std::size_t, Known> from;
    while (!pairs.empty()) {
      auto best = pairs.begin();
      for (auto other = best; other != pairs.end(); ++other) {
        if (other->second > best->second) best = other;
      }
      const auto [k, gone] = best->first;
      from[k] = gone;
      const std::size_t size = pairs.size();
      std::erase_if(pairs, [&, at = k, old = gone](const auto& pair) {
        return pair.first.first == at || pair.first.second == old;
      });
      chosen += size - pairs.size() - 1;
    }
    return from;
  }

  void expect_lost(const std::map<Known, int>& before, std::map<Known, int> rest,
                   const std::map<std::size_t, Known>& from) const {
    for (const auto& [k, gone] : from) rest.erase(gone);
    std::map<int, std::pair<std::uint64_t, MeshFeature>> expected, lost;
    for (const auto& [gone, value] : rest) expected[value] = {gone.id, gone.feature};
    for (const auto& one : history_.lost()) lost[one.value] = {one.sphere, one.feature};
    ASSERT_EQ(lost, expected);
    ASSERT_EQ(history_.lost().size(), expected.size());
    ASSERT_LE(expected.size(), before.size());
  }

  Domain domain_;
  TriangleMesh mesh_;
  double step_;
  Random random_;
  std::vector<Ball> balls_;
  std::vector<std::uint64_t> ids_;
  std::vector<ImageShift> cells_;  ///< by which each sphere has been moved in all
  std::uint64_t next_id_ = 1000;
  MeshContactHistory<int> history_;
  std::map<Known, int> known_;
  int last_value_ = 0;
};

/// Hills of 6 by 6 that go on in the next cell.
MeshArrays hills(std::uint64_t seed, double shear) {
  Random random(seed);
  std::array<std::array<double, 6>, 6> height{};
  for (auto& row : height) {
    for (double& z : row) z = random.uniform(0.0, 0.8);
  }
  MeshArrays arrays = flat_grid(6);
  for (Point& vertex : arrays.vertices) {
    vertex[2] =
        height[static_cast<std::size_t>(vertex[0]) % 6][static_cast<std::size_t>(vertex[1]) % 6];
    vertex[0] += shear * vertex[1];
  }
  return arrays;
}

void follow(Landscape& landscape) {
  for (int step = 0; step < 60; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    landscape.compare();
    if (::testing::Test::HasFatalFailure()) return;
    landscape.move();
  }
}

TEST(WallHistoryByHand, OfHillsInOpenSpace) {
  Landscape landscape(Domain::open(), hills(3, 0.0), 0.2, 7);
  follow(landscape);
  EXPECT_GT(landscape.passed_on, 100U);
  EXPECT_GT(landscape.chosen, 20U);
}

TEST(WallHistoryByHand, OfHillsThatGoOnInTheNextCell) {
  for (const double shear : {0.0, 0.5}) {
    const Domain cell = Domain::lattice({6, 0, 0}, {6 * shear, 6, 0}, {0, 0, 12});
    Landscape landscape(cell, hills(4, shear), 0.2, 8);
    follow(landscape);
    EXPECT_GT(landscape.passed_on, 100U);
    EXPECT_GT(landscape.chosen, 20U);
  }
}

TEST(WallHistoryByHand, OfTrianglesOfAllKinds) {
  Random random(11);
  for (int round = 0; round < 5; ++round) {
    Landscape landscape(Domain::open(), soup(random, 20, 30, 5), 0.3, random.below(1000));
    follow(landscape);
    EXPECT_GT(landscape.passed_on, 50U);
  }
}

}  // namespace
}  // namespace abut::testing
