#include "engine/layers/layer_box_run.hpp"

#include "kernels/strided_boxes.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

/// Boxes in one of the ways of BoxLayout. What lies between their numbers is no number.
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

}  // namespace

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

template <int Dim>
void expect_right_in_layers(const Boxes<Dim>& boxes, double margin, Way way,
                            const engine::LayerLimits& limits) {
  engine::RowsSettings settings{margin, 1, Simd::scalar, limits};
  const LayerRun first = run_rows<Dim>(boxes, settings);
  EXPECT_EQ(first.in_layers, way == Way::layers || way == Way::moved);
  EXPECT_EQ(first.in_plane, way == Way::plane);
  EXPECT_EQ(first.are_moved, way == Way::moved);
  EXPECT_TRUE(same_pairs(directly_checked<Dim>(boxes, margin), first.pairs));
  expect_same_everywhere(
      first, settings, [&](const auto& its) { return run_rows<Dim>(boxes, its); },
      [&](std::size_t turn, const auto& its) {
        const auto layout = static_cast<BoxLayout>((boxes.size() + turn) % 3);
        return run_in_place<Dim>(boxes, layout, its);
      });
}

template Spheres<2> stand_ins<2>(const Boxes<2>&);
template Spheres<3> stand_ins<3>(const Boxes<3>&);
template grid::Bounds<2> bounds_of_boxes<2>(const Boxes<2>&);
template grid::Bounds<3> bounds_of_boxes<3>(const Boxes<3>&);
template LayerRun run_in_place<2>(const Boxes<2>&, BoxLayout, const engine::RowsSettings&);
template LayerRun run_in_place<3>(const Boxes<3>&, BoxLayout, const engine::RowsSettings&);
template LayerRun run_rows<2>(const Boxes<2>&, const engine::RowsSettings&);
template LayerRun run_rows<3>(const Boxes<3>&, const engine::RowsSettings&);
template PairVector directly_checked<2>(const Boxes<2>&, double);
template PairVector directly_checked<3>(const Boxes<3>&, double);
template void expect_right_in_layers<2>(const Boxes<2>&, double, Way, const engine::LayerLimits&);
template void expect_right_in_layers<3>(const Boxes<3>&, double, Way, const engine::LayerLimits&);

}  // namespace abut::testing
