// The stages of Pipeline on the host, of all elements that it takes.

#include "device/bodies/sphere_columns.hpp"
#include "device/host/stages_on_host.hpp"
#include "device/pipeline.hpp"
#include "exact/sphere_predicate-inl.hpp"

namespace abut::device {
namespace {

template <int Dim, class T>
auto pipeline_of(HostExecutor& executor, const SphereColumns<Dim, T>& elements,
                 const DeviceRequest& request, base::ProgressReporter& progress) {
  return Pipeline<Dim, T, HostExecutor>(executor, elements, request, progress);
}

}  // namespace

template <class Elements>
FoundList<HostExecutor> list_by_stages(HostExecutor& executor, const Elements& elements,
                                       const DeviceRequest& request,
                                       base::ProgressReporter& progress) {
  return pipeline_of(executor, elements, request, progress).list();
}

template <class Elements>
FoundList<HostExecutor> count_by_stages(HostExecutor& executor, const Elements& elements,
                                        const DeviceRequest& request,
                                        base::ProgressReporter& progress) {
  return pipeline_of(executor, elements, request, progress).count();
}

template FoundList<HostExecutor> list_by_stages(HostExecutor&, const SphereColumns<2, float>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> list_by_stages(HostExecutor&, const SphereColumns<2, double>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> list_by_stages(HostExecutor&, const SphereColumns<3, float>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> list_by_stages(HostExecutor&, const SphereColumns<3, double>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const SphereColumns<2, float>&,
                                                 const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const SphereColumns<2, double>&,
                                                 const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const SphereColumns<3, float>&,
                                                 const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const SphereColumns<3, double>&,
                                                 const DeviceRequest&, base::ProgressReporter&);

}  // namespace abut::device
