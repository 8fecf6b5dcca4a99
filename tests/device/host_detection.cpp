#include "device/host_detection.hpp"

#include "base/float_environment.hpp"
#include "device/columns_of.hpp"
#include "device/pipeline.hpp"

namespace abut::testing {
namespace {

using device::HostExecutor;

enum class Wanted { list, count };

template <int Dim, class T>
HostAnswer answer(const ElementView& spheres, double margin, const HostRun& run, Wanted wanted) {
  const base::FloatEnvironment environment;
  base::MemoryMeter memory(run.max_bytes);
  HostAnswer result;
  {
    HostExecutor executor(memory, run.order, run.workers);
    base::ProgressReporter progress(run.progress);
    device::Pipeline<Dim, T, HostExecutor> pipeline(executor, device::columns_of<Dim, T>(spheres),
                                                    {margin, run.max_pairs, run.items_at_a_time},
                                                    progress);
    const auto found = wanted == Wanted::list ? pipeline.list() : pipeline.count();
    result.count = found.count;
    result.exact_decisions = found.exact_decisions;
    result.peak_bytes = memory.peak();
    if (wanted == Wanted::list) {
      result.pairs.assign(found.pairs.data(), found.pairs.data() + found.count);
    }
  }
  result.held_bytes = memory.held();
  return result;
}

HostAnswer answer(const ElementView& spheres, double margin, const HostRun& run, Wanted wanted) {
  const bool is_double = spheres.precision() == Precision::float64;
  if (spheres.dimensions() == 2) {
    return is_double ? answer<2, double>(spheres, margin, run, wanted)
                     : answer<2, float>(spheres, margin, run, wanted);
  }
  return is_double ? answer<3, double>(spheres, margin, run, wanted)
                   : answer<3, float>(spheres, margin, run, wanted);
}

}  // namespace

HostAnswer list_on_host(const ElementView& spheres, double margin, const HostRun& run) {
  return answer(spheres, margin, run, Wanted::list);
}

HostAnswer count_on_host(const ElementView& spheres, double margin, const HostRun& run) {
  return answer(spheres, margin, run, Wanted::count);
}

}  // namespace abut::testing
