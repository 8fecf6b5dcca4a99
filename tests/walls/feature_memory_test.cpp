// Contacts with features when memory is short: every allocation fails once, in turn; the bound is
// kept.

#include "scenes/random.hpp"
#include "support/allocation_faults.hpp"
#include "support/error_expectations.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using Point = std::array<double, 3>;

class FeatureMemory : public ::testing::Test {
 protected:
  FeatureMemory() {
    scenes::Random random(51);
    for (Point& center : centers_) {
      for (double& x : center) x = random.uniform(0.0, 4.0);
    }
  }

  std::vector<Point> centers_ = std::vector<Point>(300);
  const std::vector<Point> vertices_{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}, {4, 4, 2}};
  const std::vector<std::array<int, 3>> triangles_{{0, 1, 2}, {1, 2, 3}};
  const TriangleMesh mesh_{vertices_, triangles_};
  const ElementView spheres_ = spheres(centers_, 0.5);
  const std::vector<std::uint32_t> of_spheres_ = std::vector<std::uint32_t>(300, 0);
  const std::vector<std::uint32_t> of_triangles_{1, 2};
  const PairRule rule_{.elements = {.groups = of_spheres_}, .others = {.groups = of_triangles_}};
};

TEST_F(FeatureMemory, EveryAllocationThatFailsIsAnError) {
  const Domain periodic = Domain::periodic({4.0, unbounded, 3.0});
  for (const bool plain : {true, false}) {
    const Domain domain = plain ? Domain::open() : periodic;
    Options options{.shifts = plain ? Shifts::none : Shifts::stored, .threads = plain ? 1 : 2};
    if (!plain) options.rule = rule_;
    const PairCount expected = find_mesh_contacts(spheres_, mesh_, domain, options).size();
    ASSERT_GT(expected, 20U);
    const std::int64_t before = live_blocks();
    std::uint64_t refused = 0;
    for (bool done = false; !done; ++refused) {
      ASSERT_LT(refused, 1000U) << "never went through";
      AllocationFault fault(refused);
      try {
        const PairCount found = find_mesh_contacts(spheres_, mesh_, domain, options).size();
        fault.disarm();
        done = true;
        EXPECT_EQ(found, expected);
        EXPECT_LE(fault.requests(), refused) << "a refused allocation went unnoticed";
      } catch (const Error& error) {
        fault.disarm();
        EXPECT_EQ(error.code(), ErrorCode::limit_exceeded) << error.what();
      }
      EXPECT_EQ(live_blocks(), before) << "allocation " << refused;
    }
    EXPECT_GT(refused, 5U);
  }
}

TEST_F(FeatureMemory, TheBoundIsKept) {
  for (const Domain& domain : {Domain::open(), Domain::periodic({4.0, unbounded, 3.0})}) {
    for (const Shifts shifts : {Shifts::none, Shifts::stored}) {
      Options options{.shifts = shifts, .threads = 1};
      const MeshContactList free_run = find_mesh_contacts(spheres_, mesh_, domain, options);
      options.max_bytes = free_run.statistics().peak_bytes;
      EXPECT_EQ(find_mesh_contacts(spheres_, mesh_, domain, options).size(), free_run.size());
      --options.max_bytes;
      expect_error(ErrorCode::limit_exceeded, {"bytes", "memory bound"}, [&] {
        static_cast<void>(find_mesh_contacts(spheres_, mesh_, domain, options));
      });
    }
  }
}

Motion step_of(int step) {
  const double up = 0.05 * step;
  return {{{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}}, {4.0, 0.0, up}};
}

TEST_F(FeatureMemory, ADetectorAllocatesNothingInASecondCall) {
  TriangleMesh mesh = mesh_;
  Detector detector(Options{
      .shifts = Shifts::stored, .quantities = Quantity::gap | Quantity::point, .threads = 1});
  mesh.move(step_of(0));
  const PairCount most = detector.find_mesh_contacts(spheres_, mesh).size();
  ASSERT_GT(most, 20U);
  static_cast<void>(detector.find_mesh_contacts(spheres_, mesh));
  const AllocationFault watched;
  mesh.move(step_of(0));
  EXPECT_EQ(detector.find_mesh_contacts(spheres_, mesh).size(), most);
  EXPECT_EQ(watched.requests(), 0U);
}

TEST_F(FeatureMemory, ADetectorRecoversFromEveryAllocationThatFails) {
  const PairCount expected = find_mesh_contacts(spheres_, mesh_).size();
  std::uint64_t refused = 0;
  for (bool done = false; !done; ++refused) {
    ASSERT_LT(refused, 1000U) << "never went through";
    Detector detector(Options{.quantities = Quantity::gap, .threads = 2});
    AllocationFault fault(refused);
    try {
      const MeshContactList& list = detector.find_mesh_contacts(spheres_, mesh_);
      fault.disarm();
      done = true;
      EXPECT_EQ(list.size(), expected);
    } catch (const Error& error) {
      fault.disarm();
      EXPECT_EQ(error.code(), ErrorCode::limit_exceeded);
      EXPECT_EQ(detector.find_mesh_contacts(spheres_, mesh_).size(), expected);
    }
  }
  EXPECT_GT(refused, 5U);
}

}  // namespace
}  // namespace abut::testing
