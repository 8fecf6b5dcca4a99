#include "benchmarks/device/device_forms.hpp"

#include "benchmarks/device/device_timing.hpp"
#include "benchmarks/device/list_bytes.hpp"
#include "benchmarks/device/same_lists.hpp"
#include "scenes/scene.hpp"

#include <abut/detector.hpp>
#include <abut/device.hpp>
#include <abut/device_elements.hpp>
#include <abut/domain.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::benchmarks {
namespace {

constexpr int processor_calls = 3;

/// A scene on the host and on the device, in open space and in a block as wide as its
/// centers, so that pairs meet across the faces.
struct Elements {
  explicit Elements(const scenes::Scene& scene)
      : on_host(view_of(scene)), copy(on_host), size(size_of(scene)) {
    std::array<double, 3> sides{};
    const std::vector<double>* const columns[] = {&scene.x, &scene.y, &scene.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] = std::minmax_element(columns[axis]->begin(), columns[axis]->end());
      sides[axis] = *most - *least;
    }
    block = Domain::periodic(sides);
  }

  ElementView on_host;
  device::ElementCopy copy;
  DetectionSize size;
  Domain block = Domain::open();
};

/// One form of result: its name, what is asked for, and in which domain.
struct Form {
  std::string name;
  ResultForm result = ResultForm::pairs;
  Options options = {};
  bool is_periodic = false;
};

/// Measures one form of result: `find(detector, elements)` returns a list of either detector.
class FormMeasurement {
 public:
  FormMeasurement(std::string_view scene, const Elements& elements, const DeviceEffort& effort)
      : scene_(scene), elements_(elements), effort_(effort) {}

  /// False if the device found something else than the processor.
  template <class Find>
  bool measure(const Form& form, const Find& find) const {
    Detector on_processor(form.options);
    device::Detector on_device(form.options);
    const auto* expected = &find(on_processor, elements_.on_host);
    const auto* found = &find(on_device, elements_.copy.elements());
    DeviceRow of_processor =
        row_of("abut on the processor: " + form.name, scene_, size_of_list(form, *expected));
    const DetectionSize size = size_of_list(form, *found);
    DeviceRow of_device = row_of("abut::device: " + form.name, scene_, size);
    of_device.moved_bytes = moved_bytes(size);
    of_device.is_right = same(found->to_host(), *expected);
    // Detectors of their own, so that the first call is one.
    on_processor = Detector(form.options);
    time_calls(of_processor, processor_calls,
               [&] { expected = &find(on_processor, elements_.on_host); });
    of_processor.peak_bytes = expected->statistics().peak_bytes;
    print_row(of_processor, effort_, of_processor.median);
    if (of_device.is_right) {
      on_device = device::Detector(form.options);
      time_calls(of_device, effort_.calls, [&] {
        found = &find(on_device, elements_.copy.elements());
        found->wait();
      });
      of_device.peak_bytes = found->statistics().peak_bytes;
    }
    print_row(of_device, effort_, of_processor.median);
    return of_device.is_right;
  }

 private:
  template <class List>
  [[nodiscard]] DetectionSize size_of_list(const Form& form, const List& list) const {
    DetectionSize size = elements_.size;
    size.form = form.result;
    size.pairs = list.statistics().contact_pairs;
    size.exact_decisions = list.statistics().exact_decisions;
    size.has_gaps = form.options.quantities == Quantity::gap;
    size.has_shifts = form.options.shifts == Shifts::stored;
    size.is_periodic = form.is_periodic;
    return size;
  }

  std::string scene_;
  const Elements& elements_;
  const DeviceEffort& effort_;
};

}  // namespace

bool measure_forms(std::string_view name, std::uint64_t elements, const DeviceEffort& effort) {
  const scenes::Scene scene = scenes::scene_named(name).make(elements, 1);
  const Elements both(scene);
  const FormMeasurement forms(name, both, effort);
  const auto pairs_in = [](const Domain& domain) {
    return [&domain](auto& detector, const ElementView& view) -> const auto& {
      return detector.find_contact_pairs(view, domain);
    };
  };
  const auto list_of = [](NeighborListKind kind) {
    return [kind](auto& detector, const ElementView& view) -> const auto& {
      return detector.build_neighbor_list(view, Domain::open(), kind);
    };
  };
  const Domain open = Domain::open();
  const auto half = list_of(NeighborListKind::half);
  const auto full = list_of(NeighborListKind::full);
  const Options gaps{.quantities = Quantity::gap};
  const Options shifts{.shifts = Shifts::stored};
  bool all_right = forms.measure({"gaps", ResultForm::pairs, gaps}, pairs_in(open));
  all_right &= forms.measure({"half list", ResultForm::half_list}, half);
  all_right &= forms.measure({"full list", ResultForm::full_list}, full);
  all_right &= forms.measure({"full list with gaps", ResultForm::full_list, gaps}, full);
  all_right &= forms.measure({"periodic", ResultForm::pairs, {}, true}, pairs_in(both.block));
  all_right &= forms.measure({"periodic with shifts", ResultForm::pairs, shifts, true},
                             pairs_in(both.block));
  return all_right;
}

}  // namespace abut::benchmarks
