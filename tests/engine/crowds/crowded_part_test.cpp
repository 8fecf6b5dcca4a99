#include "engine/crowds/crowded_part.hpp"

#include "engine/layers/layer_in_grid.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "support/nobody_asked.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::uint32_t crowd = 20;
constexpr std::uint32_t beside = 20;  ///< near the crowd, in its layer
constexpr std::uint32_t above = 21;   ///< in the next one
constexpr std::uint32_t all = 25;

/// A crowd in the first layer among few others.
Spheres<3> crowd_among_others() {
  Spheres<3> spheres;
  for (std::uint32_t k = 0; k < crowd; ++k) {
    spheres.push_back(sphere_at<3>({2.05 + 0.005 * k, 2.1, 0.1}));
  }
  spheres.push_back(sphere_at<3>({2.6, 3.05, 0.3}));
  spheres.push_back(sphere_at<3>({2.1, 2.1, 1.06}));
  spheres.push_back(sphere_at<3>({6.0, 2.1, 0.1}));
  spheres.push_back(sphere_at<3>({0.0, 0.0, 0.0}));
  spheres.push_back(sphere_at<3>({6.0, 5.0, 9.0}));
  return spheres;
}

class CrowdedPartTest : public ::testing::Test {
 protected:
  CrowdedPartTest() {
    records_.sort(input_.spheres, grid_, engine::LayerItems::records, input_.layer_kernels, 1,
                  nobody_.work, far_);
  }

  /// Takes the crowd of the first layer.
  void take() {
    engine::LayerCrowds<3> crowds(context_.memory);
    engine::LayerLimits limits;
    limits.least_in_run_of_crowd = crowd;
    limits.least_in_crowd = crowd;
    crowds.find(grid_, records_, limits, 1, nobody_.work);
    ASSERT_EQ(crowds.layers().size(), 1U);
    EXPECT_EQ(crowds.in_layer(0).crowd, std::size_t{crowd});
    part_.take(input_, grid_, records_, crowds, 0, nobody_.work);
  }

  void expect_members(const std::vector<std::uint32_t>& around, std::uint32_t mark) {
    const engine::SearchInput<3> input = part_.input(input_, sink_);
    EXPECT_EQ(part_.crowd(), std::size_t{crowd});
    ASSERT_EQ(part_.set().locals.size(), crowd + around.size());
    for (std::uint32_t k = 0; k < crowd + around.size(); ++k) {
      const std::uint32_t number = k < crowd ? k : around[k - crowd];
      SCOPED_TRACE("place " + std::to_string(k));
      EXPECT_EQ(input.part.given[k], given_[number]);
      EXPECT_EQ(input.part.marks[k], marks_[number] | (k < crowd ? 0 : mark));
      EXPECT_EQ(input.spheres[k].center[0], spheres_[number].center[0]);
    }
  }

  const Spheres<3> spheres_ = crowd_among_others();
  NobodyAsked nobody_;
  base::DetectionContext context_;
  KeptPairs sink_;
  engine::SphereDecider<3> decider_{kernels::strided_spheres(std::span(spheres_)), 0.0,
                                    kernels::tie_kernels(Simd::scalar)};
  engine::SearchInput<3> input_ = search_input<3>(
      {spheres_, {}}, decider_, {0.0, 1, Simd::scalar, always_in_parts}, sink_, context_);
  engine::LayerGrid<3> grid_ =
      engine::LayerGrid<3>::over(bounds_of<3>(spheres_), 0.0, 1.001, 1000).value();
  engine::LayerRecords<3> records_{context_.memory};
  engine::FarSpheres<3> far_{context_.memory};
  engine::CrowdedPart<3> part_{context_.memory};
  std::vector<std::uint32_t> given_{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
                                    13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24};
  std::vector<std::uint32_t> marks_ = std::vector<std::uint32_t>(all, 0);
};

TEST_F(CrowdedPartTest, HasTheCrowdAndThoseThatMayMeetIt) {
  take();
  expect_members({beside, above}, 1);
  const engine::SearchInput<3> input = part_.input(input_, sink_);
  EXPECT_EQ(input.part.depth, 1U);
  EXPECT_EQ(input.part.cell_around, grid_.cell());
  EXPECT_EQ(input.part.long_rows_around, grid_.has_long_rows());
  EXPECT_TRUE(input.part.is_wanted(0, 1));
  EXPECT_TRUE(input.part.is_wanted(0, crowd));
  EXPECT_FALSE(input.part.is_wanted(crowd, crowd + 1));
}

/// A part of a part has the numbers of the whole, and a mark that is free.
TEST_F(CrowdedPartTest, OfAPart) {
  for (std::uint32_t& number : given_) number += 100;
  marks_[above] = 5;
  marks_[3] = 2;
  input_.part = {given_.data(), marks_.data(), 7, 6};
  take();
  expect_members({beside, above}, 8);
  EXPECT_EQ(part_.input(input_, sink_).part.depth, 7U);
  EXPECT_EQ(part_.input(input_, sink_).part.used_marks, 15U);
}

TEST(PartNumbers, HaveAFreeMarkUntilAllAreUsed) {
  engine::PartNumbers numbers;
  EXPECT_EQ(numbers.free_mark(), 1U);
  numbers.used_marks = 0xfffffffbU;
  EXPECT_EQ(numbers.free_mark(), 4U);
  numbers.used_marks = 0xffffffffU;
  EXPECT_EQ(numbers.free_mark(), 0U);
}

}  // namespace
}  // namespace abut::testing
