#pragma once

#include "device/cuda/detection.cuh"
#include "device/periodic_pipeline.hpp"

namespace abut::device {

template <int Dim>
FoundList<CudaExecutor> list_on_device(CudaExecutor& executor, const JoinedColumns<Dim>& spheres,
                                       const DeviceRequest& request,
                                       base::ProgressReporter& progress) {
  return PeriodicPipeline<Dim, CudaExecutor>(executor, spheres, request, progress).list();
}

template <int Dim>
FoundList<CudaExecutor> count_on_device(CudaExecutor& executor, const JoinedColumns<Dim>& spheres,
                                        const DeviceRequest& request,
                                        base::ProgressReporter& progress) {
  return PeriodicPipeline<Dim, CudaExecutor>(executor, spheres, request, progress).count();
}

}  // namespace abut::device
