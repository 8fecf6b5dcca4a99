// Small random systems, where borderline pairs are common, on a device against the oracle.

#include "device/face/face_detection.hpp"
#include "properties/systems.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace abut::testing {
namespace {

[[maybe_unused]] const int fixed_seed = ::setenv("RC_PARAMS", "seed=20040118 max_success=400", 0);

TEST(OnDevice, SystemsAreThoseOfTheOracle) {
  device::Detector detector;
  const bool held = rc::check([&] {
    const Scene scene = *any_system();
    const double margin = *rc::gen::element(0.0, 0.25, 0.1);
    detector.set_options({.margin = margin});
    const bool as_float = fits_float(scene) && *rc::gen::arbitrary<bool>();
    const Float32Scene rounded(scene);
    const device::ElementCopy copy(as_float ? rounded.view() : view_of(scene));
    const PairVector found = pairs_of(detector.find_contact_pairs(copy.elements()).to_host());
    RC_ASSERT(found == oracle_pairs(scene, margin));
  });
  EXPECT_TRUE(held);
}

}  // namespace
}  // namespace abut::testing
