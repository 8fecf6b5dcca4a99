#pragma once

#include "device/cuda/detection.cuh"
#include "device/pipeline.hpp"

namespace abut::device {

template <int Dim, class T>
FoundList<CudaExecutor> list_on_device(CudaExecutor& executor, const SphereColumns<Dim, T>& spheres,
                                       const DeviceRequest& request,
                                       base::ProgressReporter& progress) {
  return Pipeline<Dim, T, CudaExecutor>(executor, spheres, request, progress).list();
}

template <int Dim, class T>
FoundList<CudaExecutor> count_on_device(CudaExecutor& executor,
                                        const SphereColumns<Dim, T>& spheres,
                                        const DeviceRequest& request,
                                        base::ProgressReporter& progress) {
  return Pipeline<Dim, T, CudaExecutor>(executor, spheres, request, progress).count();
}

}  // namespace abut::device
