#include <abut/triangle_mesh.hpp>

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "elements/gathered_elements.hpp"
#include "walls/joined_vertices.hpp"
#include "walls/mesh_features.hpp"
#include "walls/vertex_numbers.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <compare>
#include <numeric>
#include <string>
#include <utility>

namespace abut {
namespace {

using walls::VertexPlace;
using Corners = TriangleMesh::Corners;
using Point = TriangleMesh::Point;

/// Three edges of each triangle, and `no_edge`, must have numbers.
constexpr std::size_t most_vertices = std::numeric_limits<ElementIndex>::max();
constexpr std::size_t most_triangles = most_vertices / 3;

/// The corners at the ends of sides 01, 02, 12.
constexpr std::array<std::array<std::size_t, 2>, 3> ends_of_sides{{{0, 1}, {0, 2}, {1, 2}}};

[[noreturn]] void refuse_count(std::size_t count, const char* what, std::size_t most) {
  throw Error(ErrorCode::limit_exceeded, std::to_string(count) + " " + what +
                                             "; a mesh numbers at most " + std::to_string(most) +
                                             ": split it");
}

void validate(const ElementView& vertices, const Connectivity& triangles) {
  if (vertices.dimensions() != 3) {
    throw Error(ErrorCode::wrong_usage,
                "the vertices have 2 dimensions; a triangle mesh wants three coordinates of each");
  }
  if (triangles.vertices_per_cell() != 3) {
    throw Error(ErrorCode::wrong_usage, "cells of " +
                                            std::to_string(triangles.vertices_per_cell()) +
                                            " vertices; a triangle mesh wants three in each");
  }
  if (vertices.size() > most_vertices) refuse_count(vertices.size(), "vertices", most_vertices);
  if (triangles.size() > most_triangles) {
    refuse_count(triangles.size(), "triangles", most_triangles);
  }
}

std::vector<Point> points_of(const ElementView& vertices) {
  const base::FloatEnvironment environment;
  std::vector<Point> points(vertices.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const exact::Sphere<3> vertex = elements::sphere_at<3>(vertices, k);
    std::copy_n(vertex.center, 3, points[k].begin());
  }
  return points;
}

/// A set of so many vertices, wherever it is moved to: the first of them by its number, the others
/// by theirs and how far they are moved from the first.
template <std::size_t Count>
struct Figure {
  std::array<VertexPlace, Count> vertices;

  friend constexpr auto operator<=>(const Figure&, const Figure&) = default;
};

/// `vertices` are ascending; returns how far the first is moved.
template <std::size_t Count>
std::pair<Figure<Count>, ImageShift> figure_of(std::array<VertexPlace, Count> vertices) {
  const ImageShift moved = vertices[0].shift;
  if (moved != ImageShift{}) {
    for (VertexPlace& vertex : vertices) vertex.shift = walls::difference(vertex.shift, moved);
  }
  return {Figure<Count>{vertices}, moved};
}

}  // namespace

struct TriangleMesh::Vertices {
  const ElementView& view;
  std::vector<Point> points;
  std::vector<VertexPlace> places;
  Domain domain = Domain::open();

  /// Returns the figure of the edge between the corners a < b of a triangle.
  [[nodiscard]] auto figure(const Corners& corners, const std::array<std::size_t, 2>& ends) const {
    return figure_of<2>({places[corners[ends[0]]], places[corners[ends[1]]]});
  }
  [[nodiscard]] auto figure(const Corners& corners) const {
    return figure_of<3>({places[corners[0]], places[corners[1]], places[corners[2]]});
  }
};

TriangleMesh::TriangleMesh(const ElementView& vertices, const Connectivity& triangles)
    : TriangleMesh(base::reporting_lack_of_memory([&] {
        validate(vertices, triangles);
        const Vertices apart{vertices, points_of(vertices), walls::vertices_apart(vertices.size())};
        return TriangleMesh(apart, triangles);
      })) {}

TriangleMesh TriangleMesh::joined(const ElementView& vertices, const Connectivity& triangles,
                                  const Domain& domain) {
  return base::reporting_lack_of_memory([&] {
    validate(vertices, triangles);
    Vertices all{vertices, points_of(vertices), {}, domain};
    all.places = walls::joined_vertices(all.points, domain);
    return TriangleMesh(all, triangles);
  });
}

TriangleMesh::TriangleMesh(const Vertices& vertices, const Connectivity& triangles)
    : boxes_(fit_boxes(vertices.view, triangles)), vertices_(vertices.points) {
  const bool is_moved =
      std::any_of(vertices.places.begin(), vertices.places.end(),
                  [](const VertexPlace& place) { return place.shift != ImageShift{}; });
  if (is_moved) {
    domain_ = vertices.domain;
    shifts_.resize(triangles.size());
  }
  number_vertices(vertices, triangles);
  number_edges(vertices);
  number_faces(vertices);
  count_triangles();
}

void TriangleMesh::number_vertices(const Vertices& vertices, const Connectivity& triangles) {
  const auto& places = vertices.places;
  for (const VertexPlace& place : places) vertex_features_.push_back(place.number);
  const walls::VertexNumbers numbers(triangles, places.size());
  triangles_.resize(triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    Corners& corners = triangles_[k];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      corners[corner] = static_cast<ElementIndex>(numbers.at(k, corner));
    }
    std::sort(corners.begin(), corners.end(), [&](ElementIndex a, ElementIndex b) {
      return places[a] != places[b] ? places[a] < places[b] : a < b;
    });
    for (std::size_t corner = 0; !shifts_.empty() && corner < 3; ++corner) {
      shifts_[k][corner] = places[corners[corner]].shift;
    }
  }
}

void TriangleMesh::number_edges(const Vertices& vertices) {
  const auto is_none = [&](const Corners& corners, const std::array<std::size_t, 2>& ends) {
    return vertices.places[corners[ends[0]]] == vertices.places[corners[ends[1]]];
  };
  std::vector<Figure<2>> figures;
  for (const Corners& corners : triangles_) {
    for (const auto& ends : ends_of_sides) {
      if (!is_none(corners, ends)) figures.push_back(vertices.figure(corners, ends).first);
    }
  }
  std::sort(figures.begin(), figures.end());
  figures.erase(std::unique(figures.begin(), figures.end()), figures.end());
  // An edge stands where the first of its triangles has it.
  edges_.assign(figures.size(), {no_edge, no_edge});
  std::vector<ImageShift> where(figures.size());
  triangle_edges_.assign(size(), {no_edge, no_edge, no_edge});
  for (std::size_t k = 0; k < size(); ++k) {
    const Corners& corners = triangles_[k];
    for (std::size_t side = 0; side < 3; ++side) {
      const auto& ends = ends_of_sides[side];
      if (is_none(corners, ends)) continue;
      const auto [figure, moved] = vertices.figure(corners, ends);
      const auto place = std::lower_bound(figures.begin(), figures.end(), figure);
      const auto edge = static_cast<std::size_t>(place - figures.begin());
      if (edges_[edge][0] == no_edge) {
        edges_[edge] = {corners[ends[0]], corners[ends[1]]};
        where[edge] = moved;
      }
      triangle_edges_[k][side] = static_cast<ElementIndex>(edge);
      if (!shifts_.empty()) shifts_[k][3 + side] = walls::difference(moved, where[edge]);
    }
  }
}

void TriangleMesh::number_faces(const Vertices& vertices) {
  std::vector<ElementIndex> by_figure(size());
  std::iota(by_figure.begin(), by_figure.end(), ElementIndex{0});
  const auto figure = [&](ElementIndex triangle) { return vertices.figure(triangles_[triangle]); };
  std::sort(by_figure.begin(), by_figure.end(), [&](ElementIndex a, ElementIndex b) {
    const auto order = figure(a).first <=> figure(b).first;
    return order != 0 ? order < 0 : a < b;
  });
  faces_.resize(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const ElementIndex triangle = by_figure[k];
    const bool repeated = k > 0 && figure(by_figure[k - 1]).first == figure(triangle).first;
    faces_[triangle] = repeated ? faces_[by_figure[k - 1]] : triangle;
    if (shifts_.empty()) continue;
    shifts_[triangle][6] =
        walls::difference(figure(triangle).second, figure(faces_[triangle]).second);
  }
}

void TriangleMesh::count_triangles() {
  auto& [of_faces, of_edges, of_vertices] = counts_;
  of_faces.resize(size());
  of_edges.resize(edges_.size());
  of_vertices.resize(vertices_.size());
  for (std::size_t k = 0; k < size(); ++k) {
    walls::for_each_feature(
        *this, static_cast<ElementIndex>(k), [&](const walls::MovedFeature& moved) {
          ++counts_[static_cast<std::size_t>(moved.feature.kind) - 1][moved.feature.number];
        });
  }
}

}  // namespace abut
