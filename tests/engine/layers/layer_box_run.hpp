#pragma once

#include "engine/layers/layer_run.hpp"
#include "exact/box.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

// Templates not defined here are so for two and three dimensions in layer_box_run.cpp.

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

template <int Dim>
Boxes<Dim> mapped(Boxes<Dim> boxes, double scale, double offset) {
  for (auto& box : boxes) {
    for (double& x : box.lower) x = x * scale + offset;
    for (double& x : box.upper) x = x * scale + offset;
  }
  return boxes;
}

/// The spheres that stand for boxes (exact::Elements), and their bounds.
template <int Dim>
Spheres<Dim> stand_ins(const Boxes<Dim>& boxes);
template <int Dim>
grid::Bounds<Dim> bounds_of_boxes(const Boxes<Dim>& boxes);

/// Ways in which the corners of boxes lie in memory: a column for each number, with the first or
/// the last box in front, or records with other numbers between them.
enum class BoxLayout { columns, backwards, wide_records };

/// Where the boxes lie, which is not done at all but in layers.
template <int Dim>
LayerRun run_in_place(const Boxes<Dim>& boxes, BoxLayout layout,
                      const engine::RowsSettings& settings);

template <int Dim>
LayerRun run_rows(const Boxes<Dim>& boxes, const engine::RowsSettings& settings);

/// The contact pairs in canonical order, each decided on the numbers of the boxes.
template <int Dim>
PairVector directly_checked(const Boxes<Dim>& boxes, double margin);

/// From every level and number of workers, and in layers from every layout, the pairs of
/// `directly_checked`, in the same order as found after as many tests.
template <int Dim>
void expect_right_in_layers(const Boxes<Dim>& boxes, double margin = 0.0, Way way = Way::layers,
                            const engine::LayerLimits& limits = always_in_layers);

/// Right in layers without that many coarse spheres or boxes, or in tiles where there are none.
template <int Dim, class Elements>
void expect_right_beside(std::size_t coarse, const Elements& elements, double margin = 0.0) {
  const engine::RowsSettings settings{margin, 1, Simd::scalar, always_beside_coarse};
  EXPECT_EQ(run_rows<Dim>(elements, settings).coarse, coarse);
  const Way way = coarse > 0 ? Way::layers : Way::tiles;
  expect_right_in_layers<Dim>(elements, margin, way, always_beside_coarse);
}

}  // namespace abut::testing
