#include "fuzz/expected_walls.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace abut::fuzz {
namespace {

using testing::ImagePair;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

/// Boxes around all that is within reach of each ball; none where one exceeds the doubles in a
/// periodic domain, for images that far out would be left out.
std::optional<ElementArrays> around_balls(const WallCase& given) {
  ElementArrays boxes{given.balls.dimensions, Shape::box, {}, {}, {}};
  for (std::size_t k = 0; k < given.balls.size(); ++k) {
    const double reach = std::nextafter(given.balls.radius[k] + given.margin, infinite);
    for (int axis = 0; axis < boxes.dimensions; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      const double center = given.balls.lower[a][k];
      const double lower = std::nextafter(center - reach, -infinite);
      const double upper = std::nextafter(center + reach, infinite);
      if (given.domain.is_periodic() && !(lower >= -largest && upper <= largest)) {
        return std::nullopt;
      }
      boxes.lower[a].push_back(std::max(lower, -largest));
      boxes.upper[a].push_back(std::min(upper, largest));
    }
  }
  return boxes;
}

ElementArrays around_triangles(const testing::MeshArrays& mesh) {
  ElementArrays boxes{3, Shape::box, {}, {}, {}};
  for (const testing::Cell& cell : mesh.triangles) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = [&](std::size_t k) {
        return mesh.vertices[static_cast<std::size_t>(cell[k])][axis];
      };
      boxes.lower[axis].push_back(std::min({at(0), at(1), at(2)}));
      boxes.upper[axis].push_back(std::max({at(0), at(1), at(2)}));
    }
  }
  return boxes;
}

struct Candidates {
  std::vector<ImagePair> pairs;  ///< (ball, wall, shift of the wall)
  bool far = false;
};

/// By whole numbers: which boxes around walls meet those around balls.
std::optional<Candidates> candidates_of(const WallCase& given, const ElementArrays& walls,
                                        std::uint64_t most_images) {
  const std::optional<ElementArrays> balls = around_balls(given);
  if (!balls) return std::nullopt;
  const testing::ExactOracle oracle(testing::joined(*balls, walls), given.domain, 0.0);
  const testing::OracleAnswer answer = oracle.pairs(most_images);
  if (answer.too_many) return std::nullopt;
  Candidates result{{}, answer.far};
  for (ImagePair image : answer.pairs) {
    if (image.pair.first >= balls->size() || image.pair.second < balls->size()) continue;
    image.pair.second -= static_cast<ElementIndex>(balls->size());
    result.pairs.push_back(image);
  }
  return result;
}

/// The feature of the moved box that holds the nearest point, if that is within reach.
std::optional<BoxFeature> touched(const WallCase& given, const ImagePair& image) {
  const auto [ball, solid] = image.pair;
  const std::int32_t numbers[] = {image.shift.x, image.shift.y, image.shift.z};
  BoxFeature feature;
  mpq_class squared = 0;
  int bounds = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(given.balls.dimensions); ++axis) {
    mpq_class x = given.balls.lower[axis][ball];
    for (int k = 0; k < 3; ++k) x -= numbers[k] * mpq_class(given.domain.vector(k)[axis]);
    const mpq_class low = given.solids.lower[axis][solid];
    const mpq_class high = given.solids.upper[axis][solid];
    const mpq_class nearest = x < low ? low : x > high ? high : x;
    squared += (x - nearest) * (x - nearest);
    auto& side = feature.side[axis];
    side = static_cast<std::int8_t>(nearest == low ? -1 : nearest == high ? 1 : 0);
    bounds += side != 0 ? 1 : 0;
  }
  const int kind = bounds == 0 || given.balls.dimensions == 3 ? bounds : bounds + 1;
  feature.kind = static_cast<FeatureKind>(kind);
  const mpq_class reach = mpq_class(given.balls.radius[ball]) + mpq_class(given.margin);
  if (squared > reach * reach) return std::nullopt;
  return feature;
}

}  // namespace

std::optional<ExpectedContacts<MovedBoxContact>> expected_box_contacts(const WallCase& given,
                                                                       std::uint64_t most_images) {
  const auto candidates = candidates_of(given, given.solids, most_images);
  if (!candidates) return std::nullopt;
  ExpectedContacts<MovedBoxContact> expected{{}, candidates->far};
  for (const ImagePair& image : candidates->pairs) {
    if (const auto feature = touched(given, image)) {
      expected.contacts.push_back({{image.pair.first, image.pair.second, *feature}, image.shift});
    }
  }
  return expected;
}

std::optional<ExpectedContacts<testing::MovedContact>> expected_mesh_contacts(
    const WallCase& given, std::uint64_t most_images) {
  const auto candidates = candidates_of(given, around_triangles(given.mesh), most_images);
  if (!candidates) return std::nullopt;
  std::vector<testing::Ball> balls;
  for (std::size_t k = 0; k < given.balls.size(); ++k) {
    const auto& place = given.balls.lower;
    balls.push_back({{place[0][k], place[1][k], place[2][k]}, given.balls.radius[k]});
  }
  testing::MeshQuestion question{.domain = given.domain, .margin = given.margin};
  question.images = [&](std::size_t ball) {
    std::vector<ImageShift> shifts;
    for (const auto& [pair, shift] : candidates->pairs) {
      if (pair.first == ball) shifts.push_back(shift);
    }
    std::sort(shifts.begin(), shifts.end());
    shifts.erase(std::unique(shifts.begin(), shifts.end()), shifts.end());
    return shifts;
  };
  return ExpectedContacts<testing::MovedContact>{
      testing::oracle_mesh_contacts(balls, given.mesh, question), candidates->far};
}

testing::WallGeometry expected_geometry(const WallCase& given, const MovedBoxContact& moved) {
  const auto& [contact, shift] = moved;
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  const auto dimensions = static_cast<std::size_t>(given.balls.dimensions);
  testing::RationalPoint center, lower, upper;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    mpq_class offset = 0;
    for (int k = 0; k < 3; ++k) offset += numbers[k] * mpq_class(given.domain.vector(k)[axis]);
    center[axis] = given.balls.lower[axis][contact.sphere];
    lower[axis] = given.solids.lower[axis][contact.box] + offset;
    upper[axis] = given.solids.upper[axis][contact.box] + offset;
  }
  return testing::geometry_of_box(center, lower, upper, dimensions);
}

testing::WallGeometry expected_geometry(const WallCase& given, const TriangleMesh& mesh,
                                        const testing::MovedContact& moved) {
  const MeshFeature feature = moved.contact.feature;
  std::array<ElementIndex, 3> corners{feature.number, feature.number, feature.number};
  if (feature.kind == FeatureKind::face) corners = mesh.triangles()[feature.number];
  if (feature.kind == FeatureKind::edge) {
    const TriangleMesh::Edge edge = mesh.edges()[feature.number];
    corners = {edge[0], edge[1], edge[1]};
  }
  exact::Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::ranges::copy(mesh.vertices()[corners[k]], triangle.corner[k]);
  }
  const auto& place = given.balls.lower;
  const ElementIndex ball = moved.contact.sphere;
  const double center[3] = {place[0][ball], place[1][ball], place[2][ball]};
  exact::Lattice lattice;
  for (int k = 0; k < 3; ++k) {
    lattice.periodic[static_cast<std::size_t>(k)] = given.domain.is_periodic(k);
    lattice.vectors[static_cast<std::size_t>(k)] = given.domain.vector(k);
  }
  const testing::NearestPart nearest = testing::nearest_part_by_rationals(
      testing::moved_back(center, moved.shift, lattice), triangle);
  return {testing::rational(center), nearest.vector, nearest.vector, nearest.distance_squared};
}

}  // namespace abut::fuzz
