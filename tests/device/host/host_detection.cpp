#include "device/host/host_detection.hpp"

#include "base/float_environment.hpp"
#include "device/columns_of.hpp"
#include "device/host/stages_on_host.hpp"
#include "elements/lattice_of.hpp"

namespace abut::testing {
namespace {

using device::HostExecutor;

enum class Wanted { list, count };

template <class T>
void copy(std::vector<T>& to, const T* from, std::uint64_t count) {
  if (from != nullptr) to.assign(from, from + count);
}

device::DeviceRequest request_of(double margin, const HostRun& run) {
  return {.margin = margin,
          .max_pairs = run.max_pairs,
          .items_at_a_time = run.items_at_a_time,
          .narrow_places = run.narrow_places,
          .shifts = run.shifts,
          .form = run.form,
          .quantities = run.quantities,
          .lattice = elements::lattice_of(run.domain),
          .rule = run.rule};
}

HostExecutor executor_of(const HostRun& run, base::MemoryMeter& memory) {
  if (run.kept == nullptr) return {memory, run.order, run.workers};
  run.kept->begin(run.max_bytes, {});
  return {*run.kept, run.order, run.workers};
}

/// Runs the stages for elements as these take them.
template <class Elements>
HostAnswer answer_of(const Elements& elements, double margin, const HostRun& run, Wanted wanted) {
  const base::FloatEnvironment environment;
  base::MemoryMeter memory(run.max_bytes);
  HostAnswer result;
  {
    HostExecutor executor = executor_of(run, memory);
    base::ProgressReporter progress(run.progress);
    const device::DeviceRequest request = request_of(margin, run);
    const auto found = wanted == Wanted::list
                           ? device::list_by_stages(executor, elements, request, progress)
                           : device::count_by_stages(executor, elements, request, progress);
    result.count = found.contact_pairs();
    result.exact_decisions = found.exact_decisions;
    result.searched = found.searched;
    result.candidate_tests = found.candidate_tests;
    result.waits = executor.waits();
    result.peak_bytes = run.kept == nullptr ? memory.peak() : run.kept->peak();
    if (wanted == Wanted::list) {
      copy(result.pairs, found.pairs.data(), found.count);
      copy(result.shifts, found.shifts.data(), found.count);
      copy(result.gaps, found.gaps.data(), found.count);
      copy(result.offsets, found.offsets.data(), found.offsets.size());
      copy(result.neighbors, found.neighbors.data(), found.count);
    }
  }
  result.held_bytes = memory.held();
  return result;
}

template <int Dim>
HostAnswer answer(const ElementView& spheres, double margin, const HostRun& run, Wanted wanted) {
  if (spheres.shape() == Shape::box) {
    return answer_of(device::joined_boxes_of<Dim>(spheres, run.second), margin, run, wanted);
  }
  const bool is_double = spheres.precision() == Precision::float64;
  const device::DeviceRequest asked{.lattice = elements::lattice_of(run.domain), .rule = run.rule};
  if (run.second == nullptr && asked.is_plain(Dim)) {
    return is_double ? answer_of(device::columns_of<Dim, double>(spheres), margin, run, wanted)
                     : answer_of(device::columns_of<Dim, float>(spheres), margin, run, wanted);
  }
  return answer_of(device::joined_columns_of<Dim>(spheres, run.second), margin, run, wanted);
}

HostAnswer answer(const ElementView& spheres, double margin, const HostRun& run, Wanted wanted) {
  return spheres.dimensions() == 2 ? answer<2>(spheres, margin, run, wanted)
                                   : answer<3>(spheres, margin, run, wanted);
}

}  // namespace

HostAnswer list_on_host(const ElementView& spheres, double margin, const HostRun& run) {
  return answer(spheres, margin, run, Wanted::list);
}

HostAnswer count_on_host(const ElementView& spheres, double margin, const HostRun& run) {
  return answer(spheres, margin, run, Wanted::count);
}

}  // namespace abut::testing
