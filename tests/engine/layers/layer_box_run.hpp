#pragma once

#include "engine/layers/layer_run.hpp"
#include "exact/box.hpp"
#include "kernels/strided_boxes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
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
Spheres<Dim> stand_ins(const Boxes<Dim>& boxes) {
  Spheres<Dim> spheres;
  for (const exact::Box<Dim>& box : boxes) spheres.push_back(kernels::stand_in(box));
  return spheres;
}
template <int Dim>
grid::Bounds<Dim> bounds_of_boxes(const Boxes<Dim>& boxes) {
  grid::Bounds<Dim> bounds = bounds_of<Dim>(stand_ins<Dim>(boxes));
  bounds.count_largest_twice();
  return bounds;
}

/// Ways in which the corners of boxes lie in memory: a column for each number, with the first or
/// the last box in front, or records with other numbers between them.
enum class BoxLayout { columns, backwards, wide_records };

/// Boxes in one of these ways. What lies between their numbers is no number.
template <int Dim>
class LaidOutBoxes {
 public:
  LaidOutBoxes(const Boxes<Dim>& boxes, BoxLayout layout)
      : numbers_(2 * Dim * boxes.size() + boxes.size(), std::numeric_limits<double>::quiet_NaN()) {
    columns_.size = boxes.size();
    for (int axis = 0; axis < Dim; ++axis) {
      put(axis, axis, layout);
      put(upper_corners + axis, Dim + axis, layout);
    }
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      for (int axis = 0; axis < Dim; ++axis) {
        number(axis, k) = boxes[k].lower[axis];
        number(upper_corners + axis, k) = boxes[k].upper[axis];
      }
    }
  }

  LaidOutBoxes(const LaidOutBoxes&) = delete;
  LaidOutBoxes& operator=(const LaidOutBoxes&) = delete;
  ~LaidOutBoxes() = default;

  [[nodiscard]] const kernels::StridedBoxes& columns() const noexcept { return columns_; }

 private:
  static constexpr int upper_corners = kernels::StridedBoxes::upper_corners;

  /// The column, which is that many-th of those that there are.
  void put(int column, int place, BoxLayout layout) {
    const auto size = static_cast<std::ptrdiff_t>(columns_.size);
    const bool is_record = layout == BoxLayout::wide_records;
    const bool is_backwards = layout == BoxLayout::backwards && size > 0;
    columns_.stride[column] = is_record ? 2 * Dim + 1 : is_backwards ? -1 : 1;
    columns_.begin[column] =
        numbers_.data() + (is_record ? place : place * size + (is_backwards ? size - 1 : 0));
  }

  double& number(int column, std::size_t k) {
    return numbers_[static_cast<std::size_t>(columns_.place(column, k) - numbers_.data())];
  }

  std::vector<double> numbers_;
  kernels::StridedBoxes columns_{};
};

/// Where the boxes lie, which is not done at all but in layers.
template <int Dim>
LayerRun run_in_place(const Boxes<Dim>& boxes, BoxLayout layout,
                      const engine::RowsSettings& settings) {
  const LaidOutBoxes<Dim> laid_out(boxes, layout);
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  const bool in_layers = engine::rows_in_place<Dim>(laid_out.columns(), bounds_of_boxes<Dim>(boxes),
                                                    settings, workspace, sink, context);
  return layer_run<Dim>(sink, in_layers, workspace, context);
}

template <int Dim>
LayerRun run_rows(const Boxes<Dim>& boxes, const engine::RowsSettings& settings) {
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  KeptPairs sink;
  const Spheres<Dim> spheres = stand_ins<Dim>(boxes);
  const grid::Bounds<Dim> bounds = bounds_of_boxes<Dim>(boxes);
  engine::rows<Dim>({spheres, boxes}, bounds, settings, workspace, sink, context);
  return layer_run<Dim>(sink, workspace.layer_records.largest_layer() > 0, workspace, context);
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

/// From every level and number of workers, and in layers from every layout, the pairs of
/// `directly_checked`, in the same order as found after as many tests.
template <int Dim>
void expect_right_in_layers(const Boxes<Dim>& boxes, double margin = 0.0, Way way = Way::layers,
                            const engine::LayerLimits& limits = always_in_layers) {
  engine::RowsSettings settings{margin, 1, Simd::scalar, limits};
  const LayerRun first = run_rows<Dim>(boxes, settings);
  EXPECT_EQ(first.in_layers, way != Way::tiles);
  EXPECT_EQ(first.are_moved, way == Way::moved);
  EXPECT_TRUE(same_pairs(directly_checked<Dim>(boxes, margin), first.pairs));
  std::size_t turn = boxes.size();
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) + " workers");
      settings.simd = level;
      settings.workers = workers;
      expect_same(first, run_rows<Dim>(boxes, settings));
      const auto layout = static_cast<BoxLayout>(++turn % 3);
      SCOPED_TRACE("layout " + std::to_string(turn % 3));
      const LayerRun in_place = run_in_place<Dim>(boxes, layout, settings);
      if (in_place.in_layers) {
        expect_same(first, in_place);
      } else {
        EXPECT_TRUE(in_place.pairs.empty());
      }
    }
  }
}

/// Right in layers without that many coarse spheres or boxes, or in tiles where there are none.
template <int Dim, class Elements>
void expect_right_beside(std::size_t coarse, const Elements& elements, double margin = 0.0) {
  const engine::RowsSettings settings{margin, 1, Simd::scalar, always_beside_coarse};
  EXPECT_EQ(run_rows<Dim>(elements, settings).coarse, coarse);
  const Way way = coarse > 0 ? Way::layers : Way::tiles;
  expect_right_in_layers<Dim>(elements, margin, way, always_beside_coarse);
}

}  // namespace abut::testing
