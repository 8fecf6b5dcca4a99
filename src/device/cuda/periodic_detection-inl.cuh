#pragma once

#include "device/cuda/detection.cuh"
#include "device/periodic_pipeline.hpp"

namespace abut::device {

template <class Columns>
FoundList<CudaExecutor> list_on_device(CudaExecutor& executor, const Joined<Columns>& elements,
                                       const DeviceRequest& request,
                                       base::ProgressReporter& progress) {
  return PeriodicPipeline<Joined<Columns>, CudaExecutor>(executor, elements, request, progress)
      .list();
}

template <class Columns>
FoundList<CudaExecutor> count_on_device(CudaExecutor& executor, const Joined<Columns>& elements,
                                        const DeviceRequest& request,
                                        base::ProgressReporter& progress) {
  return PeriodicPipeline<Joined<Columns>, CudaExecutor>(executor, elements, request, progress)
      .count();
}

}  // namespace abut::device
