#include "device/cuda/periodic_detection-inl.cuh"

namespace abut::device {

template FoundList<CudaExecutor> list_on_device(CudaExecutor&, const JoinedBoxes<2>&,
                                                const DeviceRequest&, base::ProgressReporter&);
template FoundList<CudaExecutor> count_on_device(CudaExecutor&, const JoinedBoxes<2>&,
                                                 const DeviceRequest&, base::ProgressReporter&);

}  // namespace abut::device
