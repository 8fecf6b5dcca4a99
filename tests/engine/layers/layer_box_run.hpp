#pragma once

#include "engine/layers/layer_run.hpp"
#include "exact/box.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {

template <int Dim>
using Boxes = std::vector<exact::Box<Dim>>;

/// A box whose lower corner is there, of these widths.
template <int Dim>
exact::Box<Dim> box_at(const std::array<double, 3>& lower, const std::array<double, 3>& widths) {
  exact::Box<Dim> box{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    box.lower[axis] = lower[axis];
    box.upper[axis] = lower[axis] + widths[axis];
  }
  return box;
}

template <int Dim>
void append(Boxes<Dim>& boxes, const Boxes<Dim>& more) {
  boxes.insert(boxes.end(), more.begin(), more.end());
}

/// Widths up to `widest` on each axis, lower corners in a box from 0 to `extent`.
template <int Dim>
Boxes<Dim> uniform_boxes(Random& random, std::size_t count, const std::array<double, 3>& extent,
                         const std::array<double, 3>& widest = {1.0, 1.0, 1.0}) {
  Boxes<Dim> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, 3> lower{};
    std::array<double, 3> widths{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      lower[axis] = random.uniform(0.0, extent[axis]);
      widths[axis] = random.uniform(0.0, widest[axis]);
    }
    boxes.push_back(box_at<Dim>(lower, widths));
  }
  return boxes;
}

/// The spheres that stand for boxes (exact::Elements).
template <int Dim>
Spheres<Dim> stand_ins(const Boxes<Dim>& boxes) {
  Spheres<Dim> spheres;
  for (const exact::Box<Dim>& box : boxes) {
    exact::Sphere<Dim> sphere{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sphere.center[axis] = box.lower[axis];
      sphere.radius = std::max(sphere.radius, 0.5 * box.upper[axis] - 0.5 * box.lower[axis]);
    }
    spheres.push_back(sphere);
  }
  return spheres;
}

template <int Dim>
LayerRun run_rows(const Boxes<Dim>& boxes, const engine::RowsSettings& settings) {
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  const Spheres<Dim> spheres = stand_ins<Dim>(boxes);
  grid::Bounds<Dim> bounds = bounds_of<Dim>(spheres);
  bounds.count_largest_twice();
  engine::rows<Dim>({spheres, boxes}, bounds, settings, workspace, sink, context);
  return {sink.pairs(), workspace.layer_records.largest_layer() > 0, workspace.clusters_moved > 0,
          context.candidate_tests, context.exact_decisions};
}

/// The contact pairs in canonical order, each decided on the numbers of the boxes.
template <int Dim>
PairVector directly_checked(const Boxes<Dim>& boxes, double margin) {
  PairVector pairs;
  std::uint64_t exact_decisions = 0;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      if (exact::within_reach(boxes[a], boxes[b], margin, exact_decisions)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

/// From every level and number of workers the pairs of `directly_checked`, in the same order as
/// found after as many tests.
template <int Dim>
void expect_right_in_layers(const Boxes<Dim>& boxes, double margin = 0.0, Way way = Way::layers,
                            const engine::LayerLimits& limits = always_in_layers) {
  engine::RowsSettings settings{margin, 1, Simd::scalar, limits};
  const LayerRun first = run_rows<Dim>(boxes, settings);
  EXPECT_EQ(first.in_layers, way != Way::tiles);
  EXPECT_EQ(first.are_moved, way == Way::moved);
  EXPECT_TRUE(same_pairs(directly_checked<Dim>(boxes, margin), first.pairs));
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) + " workers");
      settings.simd = level;
      settings.workers = workers;
      expect_same(first, run_rows<Dim>(boxes, settings));
    }
  }
}

}  // namespace abut::testing
