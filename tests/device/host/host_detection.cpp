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
HostAnswer answer_of(const Elements& elements, const device::DeviceRequest& request,
                     const HostRun& run, Wanted wanted) {
  const base::FloatEnvironment environment;
  base::MemoryMeter memory(run.max_bytes);
  HostAnswer result;
  {
    HostExecutor executor = executor_of(run, memory);
    base::ProgressReporter progress(run.progress);
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

HostAnswer answer(const ElementView& spheres, double margin, const HostRun& run, Wanted wanted) {
  const device::DeviceRequest request = request_of(margin, run);
  const auto asked = [&](const auto& elements) {
    return answer_of(elements, request, run, wanted);
  };
  return spheres.dimensions() == 2
             ? device::call_with_elements<2>(spheres, run.second, request, asked)
             : device::call_with_elements<3>(spheres, run.second, request, asked);
}

}  // namespace

HostAnswer list_on_host(const ElementView& spheres, double margin, const HostRun& run) {
  return answer(spheres, margin, run, Wanted::list);
}

HostAnswer count_on_host(const ElementView& spheres, double margin, const HostRun& run) {
  return answer(spheres, margin, run, Wanted::count);
}

}  // namespace abut::testing
