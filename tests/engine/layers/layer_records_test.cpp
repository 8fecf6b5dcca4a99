#include "engine/layers/layer_records.hpp"

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "engine/random_spheres.hpp"
#include "kernels/layers/layer_kernels.hpp"
#include "support/nobody_asked.hpp"
#include "support/rows_variants.hpp"
#include "support/sphere_layouts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class LayerRecordsOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using Grid = engine::LayerGrid<its_dim>;

  static Grid grid_over(const Spheres<its_dim>& spheres) {
    return Grid::over(bounds_of<its_dim>(spheres), 0.0, 1.001, spheres.size()).value();
  }

  struct Element {
    kernels::PositionRecord record;
    float radius;
  };

  void expect_sorted(const Spheres<its_dim>& spheres) {
    SCOPED_TRACE(std::to_string(spheres.size()) + " elements");
    const Grid grid = grid_over(spheres);
    std::vector<std::vector<Element>> expected(grid.layer_count());
    for (std::uint32_t k = 0; k < spheres.size(); ++k) {
      expected[grid.layer(spheres[k])].push_back(
          {grid.record(spheres[k], k), grid.units_of(spheres[k].radius)});
    }
    std::size_t turn = spheres.size();
    for (const Simd level : simd_levels_here()) {
      for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
        SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) + " workers");
        const Layout layout = all_layouts[++turn % all_layouts.size()];
        SCOPED_TRACE(layout);
        // Part of the spheres, all or none of them, are ghosts, whose numbers lie elsewhere.
        const std::span all(spheres);
        const std::size_t elements = random_.below(3) == 0   ? random_.below(all.size() + 1)
                                     : random_.below(2) == 0 ? all.size()
                                                             : 0;
        const LaidOut<its_dim> laid_out(all.first(elements), layout);
        const LaidOut<its_dim> ghosts(all.subspan(elements), Layout::packed);
        NobodyAsked nobody;
        const auto items = random_.below(2) == 0 ? engine::LayerItems::records
                                                 : engine::LayerItems::records_and_spheres;
        records_.sort(engine::LayerSpheres<its_dim>({laid_out.columns(), ghosts.columns()}), grid,
                      items, kernels::layer_kernels(level), workers, nobody.work, far_);
        EXPECT_EQ(records_.has_spheres(), items == engine::LayerItems::records_and_spheres);
        std::size_t largest = 0;
        for (std::size_t layer = 0; layer < expected.size(); ++layer) {
          expect_layer(expected[layer], records_.layer(layer), !grid.has_radii());
          expect_spheres(spheres, records_.layer(layer));
          largest = std::max(largest, expected[layer].size());
        }
        EXPECT_EQ(records_.largest_layer(), largest);
      }
    }
  }

  static void expect_layer(const std::vector<Element>& expected,
                           const engine::LayerElements<its_dim>& found, bool has_equal_radii) {
    ASSERT_EQ(found.records.size(), expected.size());
    ASSERT_EQ(found.radii.size(), has_equal_radii ? 0 : expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ASSERT_EQ(found.records[k].number, expected[k].record.number);
      ASSERT_TRUE(std::ranges::equal(found.records[k].position, expected[k].record.position));
      if (!has_equal_radii) {
        ASSERT_EQ(found.radii[k], expected[k].radius);
      }
    }
  }

  void expect_spheres(const Spheres<its_dim>& spheres,
                      const engine::LayerElements<its_dim>& found) const {
    ASSERT_EQ(found.spheres.size(), records_.has_spheres() ? found.records.size() : 0);
    for (std::size_t k = 0; k < found.spheres.size(); ++k) {
      const exact::Sphere<its_dim>& expected = spheres[found.records[k].number];
      ASSERT_TRUE(std::ranges::equal(found.spheres[k].center, expected.center));
      ASSERT_EQ(found.spheres[k].radius, expected.radius);
    }
  }

  base::MemoryMeter memory_;
  engine::LayerRecords<its_dim> records_{memory_};
  engine::FarSpheres<its_dim> far_{memory_};
  Random random_{static_cast<std::uint64_t>(31 + its_dim)};
};

TYPED_TEST_SUITE(LayerRecordsOf, Dimensions);

/// Each element once, in its layer, in the order of numbers, with the record that the grid makes
/// and its radius unless all are equal: from every level, with any number of workers, and after a
/// larger set.
TYPED_TEST(LayerRecordsOf, EachLayerHasItsElementsInTheirOrder) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : {40000U, 9001U, 64U, 5U, 1U}) {
    auto spheres = uniform_spheres<dim>(this->random_, count, box_for<dim>(count, 4.0));
    this->expect_sorted(spheres);
    for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.3, 0.5);
    this->expect_sorted(spheres);
  }
}

/// Two passes over the elements, each of which asks after pieces of some thousand.
TYPED_TEST(LayerRecordsOf, TheHookIsAskedInBothPasses) {
  constexpr int dim = TypeParam::value;
  const std::size_t count = 500000;
  const auto spheres = uniform_spheres<dim>(this->random_, count, box_for<dim>(count, 4.0));
  std::uint64_t asked = 0;
  const ProgressHook hook = [&](const Progress&) {
    ++asked;
    return ProgressAction::proceed;
  };
  base::ProgressReporter progress(hook);
  base::WorkCounter work(progress, 0);
  this->records_.sort(
      engine::LayerSpheres<dim>(kernels::SphereParts(kernels::strided_spheres<dim>(spheres))),
      this->grid_over(spheres), engine::LayerItems::records, kernels::layer_kernels(Simd::scalar),
      1, work, this->far_);
  EXPECT_GE(asked, 2 * count / (base::ProgressReporter::steps_between_calls + 8192));
}

}  // namespace
}  // namespace abut::testing
