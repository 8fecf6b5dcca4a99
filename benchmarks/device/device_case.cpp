#include "benchmarks/device/device_case.hpp"

#include "benchmarks/device/cuda_calls.hpp"
#include "benchmarks/device/device_timing.hpp"
#include "benchmarks/device/list_bytes.hpp"
#include "benchmarks/device/plain_grid.hpp"

#include <abut/detector.hpp>
#include <abut/device.hpp>
#include <abut/device_elements.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
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

/// A detection of elements of which the pairs are not yet known.
struct Detected {
  std::string name;  ///< of the scene
  double margin;
  DetectionSize size;
};

DetectionSize size_with(const Statistics& statistics, DetectionSize size) {
  size.pairs = statistics.contact_pairs;
  size.exact_decisions = statistics.exact_decisions;
  return size;
}

DeviceRow measure_device(const Detected& what, const ElementView& on_device,
                         const std::vector<ContactPair>* expected, const DeviceEffort& effort) {
  device::Detector detector({.margin = what.margin});
  const device::PairList* list = &detector.find_contact_pairs(on_device);
  const DetectionSize size = size_with(list->statistics(), what.size);
  DeviceRow row = row_of("abut::device", what.name, size);
  row.moved_bytes = moved_bytes(size);
  if (expected != nullptr) {
    const PairList pairs = list->to_host();
    row.is_right = std::ranges::equal(pairs, *expected);
    if (!row.is_right) return row;
  }
  // A detector of its own, so that the first call is one.
  StageEvents stages;
  detector = device::Detector({.margin = what.margin, .progress = stages.hook()});
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

/// Pairs are counted and not stored.
DeviceRow measure_count(const Detected& what, const ElementView& on_device,
                        const DeviceEffort& effort) {
  device::Detector detector({.margin = what.margin});
  DetectionSize size = size_with(detector.count_contact_pairs(on_device), what.size);
  size.form = ResultForm::count;
  DeviceRow row = row_of("abut::device: count", what.name, size);
  row.moved_bytes = moved_bytes(size);
  detector = device::Detector({.margin = what.margin});
  time_calls(row, effort.calls,
             [&] { row.peak_bytes = detector.count_contact_pairs(on_device).peak_bytes; });
  return row;
}

DeviceRow measure_processor(const Detected& what, const ElementView& elements, int calls,
                            std::vector<ContactPair>& pairs) {
  const Options options{.algorithm = Algorithm::rows, .margin = what.margin};
  Detector detector(options);
  const PairList* list = &detector.find_contact_pairs(elements);
  pairs.assign(list->begin(), list->end());
  DeviceRow row =
      row_of("abut on the processor", what.name, size_with(list->statistics(), what.size));
  detector = Detector(options);
  time_calls(row, calls, [&] { list = &detector.find_contact_pairs(elements); });
  row.peak_bytes = list->statistics().peak_bytes;
  return row;
}

/// Single precision of a scene on the device. Half of a margin belongs to each radius.
struct FloatScene {
  FloatScene(const Scene& scene, double margin) {
    const std::vector<double>* const columns[] = {&scene.x, &scene.y, &scene.z, &scene.radius};
    for (const std::vector<double>* column : columns) {
      std::vector<float> rounded(column->begin(), column->end());
      if (column == &scene.radius) {
        for (float& radius : rounded) radius += static_cast<float>(0.5 * margin);
      }
      arrays.emplace_back(rounded.size());
      arrays.back().copy_from_host(rounded.data());
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::minmax_element(columns[axis]->begin(), columns[axis]->end());
      extent.lower[axis] = static_cast<float>(*least);
      extent.upper[axis] = static_cast<float>(*most);
    }
    extent.largest_radius = static_cast<float>(
        *std::max_element(scene.radius.begin(), scene.radius.end()) + 0.5 * margin);
  }

  [[nodiscard]] PlainGrid::Spheres spheres() const {
    return {static_cast<std::uint32_t>(arrays[0].size()), arrays[0].data(), arrays[1].data(),
            arrays[2].data(), arrays[3].data()};
  }

  std::vector<DeviceArray<float>> arrays;
  PlainGrid::Extent extent{};
};

/// Whether a search found these pairs. It leaves them in rows of ascending first elements.
bool found_these(const PlainGrid& grid, std::uint64_t count,
                 const std::vector<ContactPair>& expected) {
  if (count != expected.size()) return false;
  std::vector<ContactPair> pairs(grid.pairs().size());
  grid.pairs().copy_to_host(pairs.data());
  for (auto row = pairs.begin(); row != pairs.end();) {
    const auto end = std::find_if(
        row, pairs.end(), [&](const ContactPair& pair) { return pair.first != row->first; });
    std::sort(row, end);
    row = end;
  }
  return pairs == expected;
}

DeviceRow measure_plain_grid(const Detected& what, const Scene& scene,
                             const std::vector<ContactPair>& expected, const DeviceEffort& effort) {
  const FloatScene rounded(scene, what.margin);
  DetectionSize size = what.size;
  DeviceRow row;
  {
    PlainGrid grid(rounded.spheres(), rounded.extent);
    size.pairs = grid.find();
    row = row_of("plain grid, single precision", what.name, size);
    row.is_right = found_these(grid, size.pairs, expected);
  }
  if (!row.is_right) return row;
  PlainGrid anew(rounded.spheres(), rounded.extent);
  time_calls(row, effort.calls, [&] {
    static_cast<void>(anew.find());
    require(cudaDeviceSynchronize(), "finish its work");
  });
  return row;
}

/// The name of a scene in the table, with its margin.
std::string name_of(const SceneCase& what) {
  std::string name(what.scene);
  if (what.margin == 0.0) return name;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), " with a margin of %g", what.margin);
  return name + text.data();
}

}  // namespace

bool measure_scene(const SceneCase& what, const DeviceEffort& effort) {
  const Scene scene = scenes::scene_named(what.scene).make(what.elements, 1);
  const Detected detected{name_of(what), what.margin, size_of(scene)};
  std::vector<ContactPair> expected;
  const int processor_calls = what.elements > 10'000'000 ? 1 : 3;
  const DeviceRow processor =
      measure_processor(detected, view_of(scene), processor_calls, expected);
  print_row(processor, effort, processor.median);
  const auto on_device = [&] {
    const device::ElementCopy copy(view_of(scene));
    return measure_device(detected, copy.elements(), &expected, effort);
  }();
  print_row(on_device, effort, processor.median);
  if (scene.dimensions == 3 && what.elements > 0) {
    try {
      print_row(measure_plain_grid(detected, scene, expected, effort), effort, processor.median);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s, %llu: plain grid left out: %s\n", detected.name.c_str(),
                   static_cast<unsigned long long>(what.elements), error.what());
    }
  }
  return on_device.is_right;
}

namespace {

/// So many copies of a scene side by side, of equal spheres, in the memory of the device.
class CopiesOfScene {
 public:
  CopiesOfScene(Scene scene, std::uint32_t copies) : radius_(scene.radius.front()) {
    const auto [least, most] = std::minmax_element(scene.x.begin(), scene.x.end());
    // Copies are moved by sums that are rounded: no pair of a random scene is so close to the
    // reach.
    const double step = *most - *least + 8.0 * radius_;
    const std::vector<double>* const from[] = {&scene.x, &scene.y, &scene.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_[axis] = DeviceArray<double>(scene.size() * copies);
      for (std::uint32_t k = 0; k < copies; ++k) {
        require(cudaMemcpy(columns_[axis].data() + k * scene.size(), from[axis]->data(),
                           scene.size() * sizeof(double), cudaMemcpyHostToDevice),
                "copy from the host");
        if (axis == 0) std::ranges::for_each(scene.x, [&](double& x) { x += step; });
      }
    }
  }

  [[nodiscard]] ElementView view() const {
    const auto column = [&](std::size_t axis) {
      return Column<double>{columns_[axis].data(), columns_[axis].size()};
    };
    return spheres(column(0), column(1), column(2), radius_);
  }

 private:
  double radius_;
  std::array<DeviceArray<double>, 3> columns_;
};

std::uint64_t pairs_of(const Scene& scene, double margin) {
  Detector detector({.algorithm = Algorithm::rows, .margin = margin});
  return detector.count_contact_pairs(view_of(scene)).contact_pairs;
}

}  // namespace

bool measure_copies(const SceneCase& what, std::uint32_t copies, const DeviceEffort& effort) {
  Scene scene = scenes::scene_named(what.scene).make(what.elements, 1);
  const std::uint64_t touching = copies * pairs_of(scene, 0.0);
  const std::uint64_t near = copies * pairs_of(scene, what.margin);
  const DetectionSize size{.elements = copies * what.elements};
  const CopiesOfScene all(std::move(scene), copies);
  DeviceRow list =
      measure_device({std::string(what.scene), 0.0, size}, all.view(), nullptr, effort);
  list.is_right = list.pairs == touching;
  print_row(list, effort, 0.0);
  DeviceRow count = measure_count({name_of(what), what.margin, size}, all.view(), effort);
  count.is_right = count.pairs == near;
  print_row(count, effort, 0.0);
  return list.is_right && count.is_right;
}

}  // namespace abut::benchmarks
