#pragma once

#include "benchmarks/common/timing.hpp"
#include "benchmarks/device/device_row.hpp"
#include "benchmarks/device/list_bytes.hpp"
#include "scenes/scene.hpp"

#include <abut/element_view.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::benchmarks {

inline ElementView view_of(const scenes::Scene& scene) {
  return scene.dimensions == 2 ? discs(scene.x, scene.y, scene.radius)
                               : spheres(scene.x, scene.y, scene.z, scene.radius);
}

/// A row without times.
inline DeviceRow row_of(std::string contestant, std::string_view scene, const DetectionSize& size) {
  DeviceRow row;
  row.contestant = std::move(contestant);
  row.scene = scene;
  row.elements = size.elements;
  row.pairs = size.pairs;
  row.compulsory_bytes = compulsory_bytes(size);
  return row;
}

/// `call` once, then again and again.
template <class Call>
void time_calls(DeviceRow& row, int calls, Call&& call) {
  Stopwatch stopwatch;
  call();
  row.first = stopwatch.lap();
  std::vector<double> seconds;
  for (int k = 0; k < calls; ++k) {
    call();
    seconds.push_back(stopwatch.lap());
  }
  const MedianAndMinimum times = median_and_minimum(std::move(seconds));
  row.median = times.median;
  row.least = times.minimum;
}

}  // namespace abut::benchmarks
