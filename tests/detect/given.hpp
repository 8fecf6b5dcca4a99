#pragma once

#include "support/scene_view.hpp"

#include <abut/abut.hpp>
#include <abut/trace.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::testing {

using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<int, 3>>;

/// Everything that the calls are given; made before memory runs out.
struct Given {
  scenes::Scene scene = scenes::scene_named("dense").make(200, 1);
  scenes::Scene others_scene = scenes::scene_named("dense").make(100, 2);
  ElementView elements = view_of(scene);
  ElementView others = view_of(others_scene);
  ElementView flat = discs(scene.x, scene.y, scene.radius);
  ElementView points = abut::points(scene.x, scene.y, scene.z);
  Domain open = Domain::open();
  Domain block = Domain::periodic({5.0, 5.0, 5.0});
  Domain other_block = Domain::periodic({6.0, 6.0, 6.0});
  std::vector<std::uint64_t> ids;
  std::vector<std::uint64_t> large_ids;
  std::vector<std::uint64_t> ids_twice = std::vector<std::uint64_t>(200, 7);
  std::vector<std::uint32_t> groups = std::vector<std::uint32_t>(200, 1);
  Points lower;
  Points upper;
  Points corners{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {5, 5, 0}, {0, 0, 5}, {5, 0, 5}};
  Triangles faces{{0, 1, 2}, {1, 2, 3}, {0, 1, 4}, {1, 4, 5}};
  Triangles bad_faces{{0, 1, 77}};
  TriangleMesh mesh{corners, faces};
  TriangleMesh joined = TriangleMesh::joined(corners, faces, block);
  ElementView boxes;
  std::vector<ContactPair> excluded{{0, 1}, {3, 2}, {0, 1}};
  std::vector<ContactPair> bad_excluded{{0, 1000}};
  std::vector<std::int32_t> numbers{3, 1, 2, 9, 4, 4, 0};
  trace::CellSystem cells;
  Options shifted{.shifts = Shifts::stored};
  Options measured{.shifts = Shifts::stored, .quantities = Quantity::distance | Quantity::vector};
  Options bad_margin{.margin = -1.0};
  Options few{.max_pairs = 3};
  Options several{.threads = 3};
  Options ruled{.rule = {.elements = {.groups = groups}}};
  Options bad_rule{.rule = {.elements = {.groups = std::span(groups).first(7)}}};
  PairList pairs = find_contact_pairs(elements);
  // By several: the threads that they wake stay, and are not left behind by a later call.
  PairList pairs_before = find_contact_pairs(elements, open, {.margin = 0.1, .threads = 3});
  PairList shifted_pairs = find_contact_pairs(elements, block, shifted);
  PairBatchVisitor visit = [](std::span<const ContactPair>, WorkerNumber) {};
  ShiftedBatchVisitor visit_shifted = [](std::span<const ContactPair>, std::span<const ImageShift>,
                                         WorkerNumber) {};

  Given() : boxes(boxes_around()), cells(trace::integerise(elements, {})) {
    for (std::uint64_t k = 0; k < scene.size(); ++k) {
      ids.push_back(scene.size() - k);
      large_ids.push_back(k << 40);
    }
  }

  ElementView boxes_around() {
    for (std::size_t k = 0; k < scene.size(); ++k) {
      const double r = scene.radius[k];
      lower.push_back({scene.x[k] - r, scene.y[k] - r, scene.z[k] - r});
      upper.push_back({scene.x[k] + r, scene.y[k] + r, scene.z[k] + r});
    }
    return abut::boxes(lower, upper);
  }
};

[[nodiscard]] inline const Given& given() {
  static const Given made;
  return made;
}

}  // namespace abut::testing
