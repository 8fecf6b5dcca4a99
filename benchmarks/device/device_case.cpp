#include "benchmarks/device/device_case.hpp"

#include "benchmarks/device/cuda_calls.hpp"
#include "benchmarks/device/device_timing.hpp"
#include "benchmarks/device/plain_grid.hpp"

#include <abut/detector.hpp>
#include <abut/device.hpp>
#include <abut/device_elements.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

/// Sets an event wherever a stage of a detection begins: the hook is asked there, and what it puts
/// into the stream stands before the work of the stage.
class StageEvents {
 public:
  [[nodiscard]] ProgressHook hook() {
    return [this](const Progress& progress) {
      begin(std::string(progress.phase));
      return ProgressAction::proceed;
    };
  }
  void begin_call() { phases_.clear(); }
  void end_call() { begin("end"); }

  /// Seconds from the begin of a stage to that of the next.
  [[nodiscard]] double seconds(const std::string& phase) const {
    for (std::size_t k = 0; k + 1 < phases_.size(); ++k) {
      if (phases_[k] == phase) return events_[k + 1].seconds_since(events_[k]);
    }
    return 0.0;
  }

 private:
  void begin(const std::string& phase) {
    if (phases_.size() == most || (!phases_.empty() && phases_.back() == phase)) return;
    events_[phases_.size()].record();
    phases_.push_back(phase);
  }

  static constexpr std::size_t most = 16;
  std::array<DeviceEvent, most> events_;
  std::vector<std::string> phases_;
};

DeviceRow measure_device(std::string_view name, const ElementView& on_device,
                         const std::vector<ContactPair>* expected, const DeviceEffort& effort) {
  device::Detector detector;
  const device::PairList* list = &detector.find_contact_pairs(on_device);
  DeviceRow row = row_of("abut::device", name, on_device.size(), list->size());
  if (expected != nullptr) {
    const PairList pairs = list->to_host();
    row.is_right = std::ranges::equal(pairs, *expected);
    if (!row.is_right) return row;
  }
  // A detector of its own, so that the first call is one.
  StageEvents stages;
  detector = device::Detector({.progress = stages.hook()});
  time_calls(row, effort.calls, [&] {
    stages.begin_call();
    list = &detector.find_contact_pairs(on_device);
    stages.end_call();
    list->wait();
  });
  row.gather = stages.seconds("gather");
  row.search = stages.seconds("search");
  row.order = stages.seconds("order");
  row.peak_bytes = list->statistics().peak_bytes;
  return row;
}

DeviceRow measure_processor(std::string_view name, const ElementView& elements, int calls,
                            std::vector<ContactPair>& pairs) {
  Detector detector({.algorithm = Algorithm::rows});
  const PairList* list = &detector.find_contact_pairs(elements);
  pairs.assign(list->begin(), list->end());
  DeviceRow row = row_of("abut on the processor", name, elements.size(), pairs.size());
  detector = Detector({.algorithm = Algorithm::rows});
  time_calls(row, calls, [&] { list = &detector.find_contact_pairs(elements); });
  row.peak_bytes = list->statistics().peak_bytes;
  return row;
}

/// Single precision of a scene on the device.
struct FloatScene {
  explicit FloatScene(const Scene& scene) {
    const std::vector<double>* const columns[] = {&scene.x, &scene.y, &scene.z, &scene.radius};
    for (const std::vector<double>* column : columns) {
      const std::vector<float> rounded(column->begin(), column->end());
      arrays.emplace_back(rounded.size());
      arrays.back().copy_from_host(rounded.data());
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::minmax_element(columns[axis]->begin(), columns[axis]->end());
      extent.lower[axis] = static_cast<float>(*least);
      extent.upper[axis] = static_cast<float>(*most);
    }
    extent.largest_radius =
        static_cast<float>(*std::max_element(scene.radius.begin(), scene.radius.end()));
  }

  [[nodiscard]] PlainGrid::Spheres spheres() const {
    return {static_cast<std::uint32_t>(arrays[0].size()), arrays[0].data(), arrays[1].data(),
            arrays[2].data(), arrays[3].data()};
  }

  std::vector<DeviceArray<float>> arrays;
  PlainGrid::Extent extent{};
};

DeviceRow measure_plain_grid(std::string_view name, const Scene& scene,
                             const std::vector<ContactPair>& expected, const DeviceEffort& effort) {
  const FloatScene rounded(scene);
  PlainGrid grid(rounded.spheres(), rounded.extent);
  DeviceRow row = row_of("plain grid, single precision", name, scene.size(), grid.find());
  std::vector<ContactPair> pairs(grid.pairs().size());
  grid.pairs().copy_to_host(pairs.data());
  std::sort(pairs.begin(), pairs.end());
  row.is_right = pairs == expected;
  if (!row.is_right) return row;
  PlainGrid anew(rounded.spheres(), rounded.extent);
  time_calls(row, effort.calls, [&] {
    static_cast<void>(anew.find());
    require(cudaDeviceSynchronize(), "finish its work");
  });
  return row;
}

}  // namespace

bool measure_scene(std::string_view name, std::uint64_t elements, const DeviceEffort& effort) {
  const Scene scene = scenes::scene_named(name).make(elements, 1);
  std::vector<ContactPair> expected;
  const int processor_calls = elements > 10'000'000 ? 1 : 3;
  const DeviceRow processor = measure_processor(name, view_of(scene), processor_calls, expected);
  print_row(processor, effort, processor.median);
  const device::ElementCopy copy(view_of(scene));
  const DeviceRow on_device = measure_device(name, copy.elements(), &expected, effort);
  print_row(on_device, effort, processor.median);
  if (scene.dimensions == 3 && elements > 0) {
    try {
      print_row(measure_plain_grid(name, scene, expected, effort), effort, processor.median);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s, %llu: plain grid left out: %s\n", std::string(name).c_str(),
                   static_cast<unsigned long long>(elements), error.what());
    }
  }
  return on_device.is_right;
}

bool measure_copies(std::string_view name, std::uint64_t elements, std::uint32_t copies,
                    const DeviceEffort& effort) {
  Scene scene = scenes::scene_named(name).make(elements, 1);
  std::vector<ContactPair> pairs;
  static_cast<void>(measure_processor(name, view_of(scene), 1, pairs));
  const std::uint64_t expected = pairs.size() * copies;
  pairs = {};
  const auto [least, most] = std::minmax_element(scene.x.begin(), scene.x.end());
  const double radius = *std::max_element(scene.radius.begin(), scene.radius.end());
  // Copies are moved by sums that are rounded: no pair of a random scene is so close to the reach.
  const double step = *most - *least + 8.0 * radius;
  std::array<DeviceArray<double>, 3> columns;
  const std::uint64_t all = elements * copies;
  std::vector<double>* const from[] = {&scene.x, &scene.y, &scene.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns[axis] = DeviceArray<double>(all);
    for (std::uint32_t k = 0; k < copies; ++k) {
      require(cudaMemcpy(columns[axis].data() + k * elements, from[axis]->data(),
                         elements * sizeof(double), cudaMemcpyHostToDevice),
              "copy from the host");
      if (axis == 0) std::ranges::for_each(scene.x, [&](double& x) { x += step; });
    }
  }
  const auto column = [&](std::size_t axis) { return Column<double>{columns[axis].data(), all}; };
  DeviceRow row = measure_device(name, spheres(column(0), column(1), column(2), radius), nullptr,
                                 {1, effort.copy_speed});
  row.is_right = row.pairs == expected;
  print_row(row, effort, 0.0);
  return row.is_right;
}

}  // namespace abut::benchmarks
