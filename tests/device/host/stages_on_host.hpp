#pragma once

#include "base/progress_reporter.hpp"
#include "device/device_request.hpp"
#include "device/found_list.hpp"
#include "device/host/host_executor.hpp"

namespace abut::device {

/// Lists the contacts of elements by the stages of the device engine, which run on the host. The
/// stages of each kind of elements are compiled once for all programs of tests; `Elements` are
/// those that a detection on a device takes (device/cuda/detection.cuh).
template <class Elements>
[[nodiscard]] FoundList<HostExecutor> list_by_stages(HostExecutor& executor,
                                                     const Elements& elements,
                                                     const DeviceRequest& request,
                                                     base::ProgressReporter& progress);

/// Counts them.
template <class Elements>
[[nodiscard]] FoundList<HostExecutor> count_by_stages(HostExecutor& executor,
                                                      const Elements& elements,
                                                      const DeviceRequest& request,
                                                      base::ProgressReporter& progress);

}  // namespace abut::device
