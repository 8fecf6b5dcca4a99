#include "walls/mesh_oracle.hpp"

#include "exact/features/triangle_oracle.hpp"

#include <abut/algorithm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

namespace abut::testing {
namespace {

using exact::TrianglePart;

/// A feature by its vertices: one, two or three.
using VertexSet = std::set<int>;

/// A triangle with its corners by ascending number: then the nearest part of several is that of
/// smallest numbers.
struct OrderedCell {
  OrderedCell(const MeshArrays& arrays, Cell cell) : corners(cell) {
    std::sort(corners.begin(), corners.end());
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& vertex = arrays.vertices[static_cast<std::size_t>(corners[k])];
      std::copy(vertex.begin(), vertex.end(), triangle.corner[k]);
    }
  }

  Cell corners;
  exact::Triangle triangle{};
};

VertexSet nearest_feature(const testing::RationalPoint& center, double radius,
                          const OrderedCell& ordered, double margin) {
  const Cell& cell = ordered.corners;
  const auto part =
      testing::part_within_reach_by_rationals(center, radius, ordered.triangle, margin);
  if (!part) return {};
  switch (*part) {
    case TrianglePart::corner_0:
    case TrianglePart::corner_1:
    case TrianglePart::corner_2:
      return {cell[static_cast<std::size_t>(*part)]};
    case TrianglePart::side_01:
      return {cell[0], cell[1]};
    case TrianglePart::side_02:
      return {cell[0], cell[2]};
    case TrianglePart::side_12:
      return {cell[1], cell[2]};
    case TrianglePart::face:
      break;
  }
  return {cell[0], cell[1], cell[2]};
}

bool has(const Cell& cell, const VertexSet& feature) {
  return std::all_of(feature.begin(), feature.end(), [&](int vertex) {
    return std::find(cell.begin(), cell.end(), vertex) != cell.end();
  });
}

/// Numbers of edges in the order of their vertices.
std::map<VertexSet, ElementIndex> edges_of(const MeshArrays& arrays) {
  std::set<std::pair<int, int>> ordered;
  for (const Cell& cell : arrays.triangles) {
    for (const int a : cell) {
      for (const int b : cell) {
        if (a < b) ordered.insert({a, b});
      }
    }
  }
  std::map<VertexSet, ElementIndex> edges;
  for (const auto& [a, b] : ordered) {
    const auto number = static_cast<ElementIndex>(edges.size());
    edges[{a, b}] = number;
  }
  return edges;
}

MeshFeature named(const VertexSet& feature, const MeshArrays& arrays,
                  const std::map<VertexSet, ElementIndex>& edges) {
  if (feature.size() == 1) {
    return {FeatureKind::vertex, static_cast<ElementIndex>(*feature.begin())};
  }
  if (feature.size() == 2) return {FeatureKind::edge, edges.at(feature)};
  const auto first = std::find_if(arrays.triangles.begin(), arrays.triangles.end(),
                                  [&](const Cell& cell) { return has(cell, feature); });
  return {FeatureKind::face, static_cast<ElementIndex>(first - arrays.triangles.begin())};
}

exact::Lattice lattice_of(const Domain& domain) {
  exact::Lattice lattice;
  for (std::size_t k = 0; k < 3; ++k) {
    lattice.vectors[k] = domain.vector(static_cast<int>(k));
    lattice.periodic[k] = domain.is_periodic(static_cast<int>(k));
  }
  return lattice;
}

std::vector<ImageShift> shifts_of(const MeshQuestion& question) {
  const auto end = [&](int axis) {
    return question.domain.is_periodic(axis) ? question.farthest : 0;
  };
  std::vector<ImageShift> shifts;
  for (std::int32_t x = -end(0); x <= end(0); ++x) {
    for (std::int32_t y = -end(1); y <= end(1); ++y) {
      for (std::int32_t z = -end(2); z <= end(2); ++z) shifts.push_back({x, y, z});
    }
  }
  return shifts;
}

/// Whether all corners lie so far to one side that rounding cannot matter.
bool clearly_apart(const testing::RationalPoint& center, double reach,
                   const exact::Triangle& triangle) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = center[axis].get_d();
    const double ends[3] = {triangle.corner[0][axis], triangle.corner[1][axis],
                            triangle.corner[2][axis]};
    const double below = *std::min_element(ends, ends + 3) - x;
    const double above = x - *std::max_element(ends, ends + 3);
    const double magnitude = 1.0 + std::fabs(x) + std::fabs(ends[0]) + reach;
    if (std::max(below, above) > reach + 1e-9 * magnitude) return true;
  }
  return false;
}

/// The features that one ball touches of one image, of triangles that are there for it.
std::vector<VertexSet> touched(const testing::RationalPoint& center, double radius, double margin,
                               const std::vector<OrderedCell>& cells,
                               const std::vector<bool>& is_there) {
  std::vector<VertexSet> nearest(cells.size());
  for (std::size_t t = 0; t < cells.size(); ++t) {
    if (!is_there[t] || clearly_apart(center, radius + margin, cells[t].triangle)) continue;
    nearest[t] = nearest_feature(center, radius, cells[t], margin);
  }
  std::vector<VertexSet> result;
  for (const VertexSet& feature : std::set(nearest.begin(), nearest.end())) {
    if (feature.empty()) continue;
    bool is_nearest_of_all = true;
    for (std::size_t t = 0; t < cells.size(); ++t) {
      if (is_there[t] && has(cells[t].corners, feature) && nearest[t] != feature) {
        is_nearest_of_all = false;
      }
    }
    if (is_nearest_of_all) result.push_back(feature);
  }
  return result;
}

/// Whether a number is that of an image at the border of those looked at.
bool on_border(const ImageShift& shift, const MeshQuestion& question) {
  if (question.images) return false;
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (question.domain.is_periodic(axis) && std::abs(numbers[axis]) == question.farthest) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const MovedContact& moved) {
  static constexpr const char* names[] = {"interior", "face", "edge", "vertex"};
  const auto& [kind, number] = moved.contact.feature;
  return out << "sphere " << moved.contact.sphere << " on " << names[static_cast<int>(kind)] << ' '
             << number << " moved by (" << moved.shift.x << ' ' << moved.shift.y << ' '
             << moved.shift.z << ')';
}

std::vector<MovedContact> oracle_mesh_contacts(const std::vector<Ball>& balls,
                                               const MeshArrays& arrays,
                                               const MeshQuestion& question) {
  const auto edges = edges_of(arrays);
  std::vector<OrderedCell> cells;
  for (const Cell& cell : arrays.triangles) cells.emplace_back(arrays, cell);
  const exact::Lattice lattice = lattice_of(question.domain);
  std::vector<ImageShift> shifts;
  if (!question.images) shifts = shifts_of(question);
  std::vector<MovedContact> contacts;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    double center[3];
    std::copy(balls[k].center.begin(), balls[k].center.end(), center);
    std::vector<bool> is_there(cells.size(), true);
    for (std::size_t t = 0; question.allows && t < cells.size(); ++t) {
      is_there[t] = question.allows(k, t);
    }
    if (question.images) shifts = question.images(k);
    for (const ImageShift& shift : shifts) {
      const auto seen_from = testing::moved_back(center, shift, lattice);
      for (const VertexSet& feature :
           touched(seen_from, balls[k].radius, question.margin, cells, is_there)) {
        EXPECT_FALSE(on_border(shift, question)) << "the oracle looks not far enough";
        contacts.push_back({{static_cast<ElementIndex>(k), named(feature, arrays, edges)}, shift});
      }
    }
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

std::vector<MeshContact> oracle_mesh_contacts(const std::vector<Ball>& balls,
                                              const MeshArrays& arrays, double margin) {
  std::vector<MeshContact> contacts;
  for (const MovedContact& moved : oracle_mesh_contacts(balls, arrays, {.margin = margin})) {
    contacts.push_back(moved.contact);
  }
  return contacts;
}

std::vector<MovedContact> moved_contacts(const MeshContactList& list) {
  EXPECT_EQ(list.shifts().size(), list.size());
  EXPECT_EQ(list.statistics().contact_pairs, list.size());
  std::vector<MovedContact> contacts;
  for (std::size_t k = 0; k < list.shifts().size(); ++k) {
    contacts.push_back({list[k], list.shifts()[k]});
  }
  return contacts;
}

std::vector<MovedContact> agreed_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                          const Domain& domain, Options options) {
  options.shifts = Shifts::stored;
  const auto expected = moved_contacts(find_mesh_contacts(spheres, mesh, domain, options));
  for (const AlgorithmInfo& algorithm : algorithms()) {
    if (domain.is_periodic() && !algorithm.periodic) continue;
    options.algorithm = algorithm.algorithm;
    for (const int threads : {1, 2, 3, 7, 16}) {
      options.threads = threads;
      EXPECT_EQ(moved_contacts(find_mesh_contacts(spheres, mesh, domain, options)), expected)
          << algorithm.name << ", " << threads << " threads";
    }
  }
  return expected;
}

}  // namespace abut::testing
