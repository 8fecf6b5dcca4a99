#include "device/bodies/measure_gap.hpp"
#include "device/cuda/cuda_executor.cuh"

#include <cstdint>

namespace abut::device {

template <class Given>
void CudaExecutor::for_each(std::uint64_t count, const MeasureOpenGap<Given>& body) {
  run(count, body);
}

template void CudaExecutor::for_each(std::uint64_t, const MeasureOpenGap<SphereColumns<2, float>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const MeasureOpenGap<SphereColumns<2, double>>&);
template void CudaExecutor::for_each(std::uint64_t, const MeasureOpenGap<SphereColumns<3, float>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const MeasureOpenGap<SphereColumns<3, double>>&);
template void CudaExecutor::for_each(std::uint64_t, const MeasureOpenGap<JoinedBoxes<2>>&);
template void CudaExecutor::for_each(std::uint64_t, const MeasureOpenGap<JoinedBoxes<3>>&);
template void CudaExecutor::for_each(std::uint64_t, const MeasureOpenGap<JoinedColumns<2>>&);
template void CudaExecutor::for_each(std::uint64_t, const MeasureOpenGap<JoinedColumns<3>>&);

}  // namespace abut::device
