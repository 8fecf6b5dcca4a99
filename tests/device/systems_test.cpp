// Small random systems, where borderline pairs are common, against the oracle.

#include "properties/systems.hpp"
#include "device/host/host_detection.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>

namespace abut::testing {
namespace {

[[maybe_unused]] const int fixed_seed = ::setenv("RC_PARAMS", "seed=20040118 max_success=400", 0);

TEST(DeviceSystems, AreThoseOfTheOracle) {
  const bool held = rc::check([] {
    const Scene scene = *any_system();
    const double margin = *rc::gen::element(0.0, 0.25, 0.1);
    const HostRun run{
        .order = *rc::gen::element(device::ItemOrder::ascending, device::ItemOrder::descending,
                                   device::ItemOrder::shuffled),
        .items_at_a_time = *rc::gen::element<std::uint64_t>(1, 5, 1 << 21)};
    const bool as_float = fits_float(scene) && *rc::gen::arbitrary<bool>();
    const PairVector found = as_float ? list_on_host(Float32Scene(scene).view(), margin, run).pairs
                                      : list_on_host(view_of(scene), margin, run).pairs;
    RC_ASSERT(found == oracle_pairs(scene, margin));
  });
  EXPECT_TRUE(held);
}

}  // namespace
}  // namespace abut::testing
