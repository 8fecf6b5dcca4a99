// Levels, cells and stretches of the device engine.

#include "device/frame.hpp"

#include "device/host/host_executor.hpp"
#include "device/levels.hpp"

#include "device/columns_of.hpp"
#include "device/search/axis_stretches.hpp"
#include "device/search/stretch_layout.hpp"
#include "scenes/random.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using namespace device;

Extent<3> extent_of_all(const scenes::Scene& scene) {
  Extent<3> extent = Extent<3>::of_none();
  const auto columns = columns_of<3, double>(view_of(scene));
  for (std::uint32_t k = 0; k < columns.count; ++k) {
    extent = JoinExtents{}(extent, extent_of(columns[k]));
  }
  return extent;
}

SizeCounts counts_of(const scenes::Scene& scene, const Extent<3>& extent) {
  SizeCounts counts{};
  for (const double radius : scene.radius) {
    ++counts[size_class_of(radius, half_octave_of(extent.largest_radius))];
  }
  return counts;
}

Levels levels_of(const char* name, std::size_t count) {
  const scenes::Scene scene = scenes::scene_named(name).make(count, 1);
  const Extent<3> extent = extent_of_all(scene);
  const Levels levels = choose_levels(counts_of(scene, extent), extent, 0.0);
  std::uint64_t elements = 0;
  double below = 0.0;
  for (std::uint32_t k = 0; k < levels.count; ++k) {
    EXPECT_GT(levels.ends[k], below);
    std::uint64_t here = 0;
    for (const double radius : scene.radius) {
      if (radius >= below && radius < levels.ends[k]) ++here;
    }
    EXPECT_EQ(levels.elements[k], here) << "level " << k;
    elements += levels.elements[k];
    below = levels.ends[k];
  }
  EXPECT_EQ(below, std::numeric_limits<double>::infinity());
  EXPECT_EQ(elements, scene.size());
  return levels;
}

TEST(DeviceLevels, AreAsManyAsPay) {
  EXPECT_EQ(levels_of("dense", 20000).count, 1U);
  EXPECT_EQ(levels_of("one_giant", 20000).count, 2U);
  EXPECT_GE(levels_of("log_uniform_1000", 20000).count, 2U);
  EXPECT_GE(levels_of("graded_1000", 20000).count, 3U);
}

/// Pairs at most a reach apart, beside faces of cells and far from the corner: adjacent cells.
TEST(DeviceFrame, PartnersAreInAdjacentCells) {
  scenes::Random random(7);
  std::uint64_t apart = 0;
  for (int system = 0; system < 200; ++system) {
    const double radius = random.uniform(0.1, 1.0);
    const double cells = std::ldexp(1.0, 1 + system % 30);
    const double length = 2.0 * radius * cells;
    const double lower = random.uniform(-1.0, 1.0) * (system % 3 == 0 ? 1e9 : 1.0);
    Extent<2> extent{{lower, 0.0}, {lower + length, 0.0}, radius, radius, radius, no_element};
    const Frame<2> frame = make_frame(extent, 0.0, 0.0);
    SizeLevel<2> level{};
    const CellWidths widths = lay_out(level, extent, frame);
    ASSERT_EQ(widths.narrowest, widths.in_one_piece);
    const double cell = widths.narrowest;
    for (int k = 0; k < 200; ++k) {
      const double face = std::floor(random.uniform(1.0, length / cell)) * cell;
      const double x = lower + std::nextafter(face, random.uniform(-1.0, 1.0) * length);
      const double y = x + 2.0 * radius;
      if (y > extent.upper[0] || !(y - x <= 2.0 * radius)) continue;
      const auto cell_of = [&](double at) {
        return units_along(level.axes[0], level.units_of_one, at) >> unit_bits;
      };
      const std::uint64_t steps = cell_of(y) - cell_of(x);
      EXPECT_LE(steps, 1U) << x << ' ' << radius;
      apart += steps;
    }
  }
  EXPECT_GT(apart, 10000U);
}

/// Clusters up to 10^18 apart.
scenes::Scene far_clusters() {
  scenes::Scene scene;
  scenes::Random random(3);
  const std::vector<double> places{-1e18, 0.0, 1e6, 1e18};
  for (int k = 0; k < 400; ++k) {
    const double place = places[static_cast<std::size_t>(k) % places.size()];
    // Steps that the far clusters can show.
    scene.x.push_back(place + 128.0 * std::floor(random.uniform(0.0, 50.0)));
    scene.y.push_back(random.uniform(0.0, 50.0));
    scene.z.push_back(random.uniform(0.0, 50.0));
    scene.radius.push_back(1.0);
  }
  return scene;
}

/// As many cells as if clusters lay side by side, and none adjacent to another's.
TEST(DeviceFrame, WideGapsAreClosed) {
  const scenes::Scene scene = far_clusters();
  const Extent<3> extent = extent_of_all(scene);
  Frame<3> frame = make_frame(extent, 0.0, 0.0);
  frame.level_count = 1;
  SizeLevel<3>& level = frame.levels[0];
  level.radius_end = std::numeric_limits<double>::infinity();
  level.end_slot = static_cast<std::uint32_t>(scene.size());
  const CellWidths widths = lay_out(level, extent, frame);
  EXPECT_GT(widths.in_one_piece, 1e8 * widths.narrowest);

  base::MemoryMeter memory;
  HostExecutor executor(memory, ItemOrder::shuffled, 1);
  const auto elements = columns_of<3, double>(view_of(scene));
  StretchLayout<SphereColumns<3, double>, HostExecutor>(executor, elements, frame, 0)
      .lay_out(level, widths);
  EXPECT_EQ(memory.held(), 0U);
  AxisStretches<SphereColumns<3, double>, HostExecutor> stretches(executor, elements, frame, 0, 0);
  stretches.divide(level.widest_gap, level.axes[0].stretch_count);
  const AxisOfStretches along_x = stretches.number_cells(level.units_of_one);
  EXPECT_EQ(level.units_of_one, units_of_cell / widths.narrowest);
  EXPECT_LE(level.cells[0], 2 * scene.size());
  EXPECT_LE(level.cells[1], 30U);
  for (std::size_t a = 0; a < scene.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto cell_of = [&](double x) {
        return static_cast<std::int64_t>(along_x.units_along(level.units_of_one, x) >> unit_bits);
      };
      const std::int64_t steps = std::abs(cell_of(scene.x[a]) - cell_of(scene.x[b]));
      const double distance = std::fabs(scene.x[a] - scene.x[b]);
      EXPECT_GE(steps, distance > 1e5 ? 2 : distance > widths.narrowest ? 1 : 0);
      EXPECT_LE(steps, distance <= 2.0 ? 1 : 1000);
    }
  }
}

}  // namespace
}  // namespace abut::testing
