// What stands in for properties/detections.cpp in device_relations_test: the relations hold between
// detections of the device engine, whose stages run on the host.

#include "device/host/any_run.hpp"
#include "device/host/host_detection.hpp"
#include "properties/systems.hpp"
#include "support/scene_view.hpp"

#include <functional>
#include <iostream>

namespace abut::testing {

PairVector pairs_of(const Scene& scene, Algorithm, double margin) {
  const HostRun run = any_run();
  const bool as_float = fits_float(scene) && *rc::gen::arbitrary<bool>();
  RC_LOG() << (as_float ? "float" : "double") << std::endl;
  return as_float ? list_on_host(Float32Scene(scene).view(), margin, run).pairs
                  : list_on_host(view_of(scene), margin, run).pairs;
}

/// The engine has no other algorithm.
void for_each_algorithm(const Scene&, const std::function<void(Algorithm)>& relation) {
  relation(Algorithm::rows);
}

}  // namespace abut::testing
