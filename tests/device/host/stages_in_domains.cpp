// The stages of PeriodicPipeline on the host, of all elements that it takes.

#include "device/bodies/joined_columns.hpp"
#include "device/bodies/periodic/decide_images.hpp"
#include "device/host/stages_on_host.hpp"
#include "device/periodic_pipeline.hpp"

namespace abut::device {

template <class Elements>
FoundList<HostExecutor> list_by_stages(HostExecutor& executor, const Elements& elements,
                                       const DeviceRequest& request,
                                       base::ProgressReporter& progress) {
  return PeriodicPipeline<Elements, HostExecutor>(executor, elements, request, progress).list();
}

template <class Elements>
FoundList<HostExecutor> count_by_stages(HostExecutor& executor, const Elements& elements,
                                        const DeviceRequest& request,
                                        base::ProgressReporter& progress) {
  return PeriodicPipeline<Elements, HostExecutor>(executor, elements, request, progress).count();
}

template FoundList<HostExecutor> list_by_stages(HostExecutor&, const JoinedColumns<2>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> list_by_stages(HostExecutor&, const JoinedColumns<3>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> list_by_stages(HostExecutor&, const JoinedBoxes<2>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> list_by_stages(HostExecutor&, const JoinedBoxes<3>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const JoinedColumns<2>&,
                                                 const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const JoinedColumns<3>&,
                                                 const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const JoinedBoxes<2>&,
                                                 const DeviceRequest&, base::ProgressReporter&);
template FoundList<HostExecutor> count_by_stages(HostExecutor&, const JoinedBoxes<3>&,
                                                 const DeviceRequest&, base::ProgressReporter&);

}  // namespace abut::device
