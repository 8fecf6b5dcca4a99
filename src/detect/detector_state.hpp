#pragma once

#include "detect/detection_run.hpp"

#include <abut/detector.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>

#include <memory>
#include <utility>

namespace abut {

/// The memory of a Detector from call to call.
struct Detector::State {
  explicit State(Options given) : options(std::move(given)) {}

  Options options;
  detect::DetectionRun run{detect::WorkingArrays::kept};
  PairList pairs;
  NeighborList neighbors;
  std::shared_ptr<void> walls;  ///< walls::DetectorWalls, which stands above; made when first asked
};

}  // namespace abut
