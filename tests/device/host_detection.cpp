#include "device/host_detection.hpp"

#include "base/float_environment.hpp"
#include "device/bodies/periodic/decide_images.hpp"
#include "device/columns_of.hpp"
#include "device/periodic_pipeline.hpp"
#include "device/pipeline.hpp"
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

/// Runs a pipeline, which is made by make(executor, request, progress).
template <class Make>
HostAnswer run_pipeline(double margin, const HostRun& run, Wanted wanted, const Make& make) {
  const base::FloatEnvironment environment;
  base::MemoryMeter memory(run.max_bytes);
  HostAnswer result;
  {
    HostExecutor executor = executor_of(run, memory);
    base::ProgressReporter progress(run.progress);
    auto pipeline = make(executor, request_of(margin, run), progress);
    const auto found = wanted == Wanted::list ? pipeline.list() : pipeline.count();
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

template <int Dim, class T>
HostAnswer open_answer(const ElementView& spheres, double margin, const HostRun& run,
                       Wanted wanted) {
  return run_pipeline(margin, run, wanted,
                      [&](HostExecutor& executor, const device::DeviceRequest& request,
                          base::ProgressReporter& progress) {
                        return device::Pipeline<Dim, T, HostExecutor>(
                            executor, device::columns_of<Dim, T>(spheres), request, progress);
                      });
}

/// By the pipeline that takes elements joined of one or two sets.
template <class Joined>
HostAnswer joined_answer(const Joined& elements, double margin, const HostRun& run, Wanted wanted) {
  return run_pipeline(margin, run, wanted,
                      [&](HostExecutor& executor, const device::DeviceRequest& request,
                          base::ProgressReporter& progress) {
                        return device::PeriodicPipeline<Joined, HostExecutor>(executor, elements,
                                                                              request, progress);
                      });
}

template <int Dim>
HostAnswer answer(const ElementView& spheres, double margin, const HostRun& run, Wanted wanted) {
  if (spheres.shape() == Shape::box) {
    return joined_answer(device::joined_boxes_of<Dim>(spheres, run.second), margin, run, wanted);
  }
  const bool is_double = spheres.precision() == Precision::float64;
  const device::DeviceRequest asked{.lattice = elements::lattice_of(run.domain), .rule = run.rule};
  if (run.second == nullptr && asked.is_plain(Dim)) {
    return is_double ? open_answer<Dim, double>(spheres, margin, run, wanted)
                     : open_answer<Dim, float>(spheres, margin, run, wanted);
  }
  return joined_answer(device::joined_columns_of<Dim>(spheres, run.second), margin, run, wanted);
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
