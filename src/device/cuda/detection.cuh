#pragma once

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "device/bodies/joined_columns.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "device/cuda/cuda_executor.cuh"
#include "device/device_request.hpp"
#include "device/found_list.hpp"

namespace abut::device {

/// The pipelines of one dimension and type of numbers, each compiled in a file of its own.
template <int Dim, class T>
[[nodiscard]] FoundList<CudaExecutor> list_on_device(CudaExecutor& executor,
                                                     const SphereColumns<Dim, T>& spheres,
                                                     const DeviceRequest& request,
                                                     base::ProgressReporter& progress);

/// The same without a list.
template <int Dim, class T>
[[nodiscard]] FoundList<CudaExecutor> count_on_device(CudaExecutor& executor,
                                                      const SphereColumns<Dim, T>& spheres,
                                                      const DeviceRequest& request,
                                                      base::ProgressReporter& progress);

/// The same in a periodic domain, of two sets, and of boxes.
template <class Columns>
[[nodiscard]] FoundList<CudaExecutor> list_on_device(CudaExecutor& executor,
                                                     const Joined<Columns>& elements,
                                                     const DeviceRequest& request,
                                                     base::ProgressReporter& progress);

template <class Columns>
[[nodiscard]] FoundList<CudaExecutor> count_on_device(CudaExecutor& executor,
                                                      const Joined<Columns>& elements,
                                                      const DeviceRequest& request,
                                                      base::ProgressReporter& progress);

}  // namespace abut::device
