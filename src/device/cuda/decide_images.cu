#include "device/bodies/periodic/decide_images.hpp"
#include "device/cuda/cuda_executor.cuh"
#include "exact/sphere_predicate-inl.hpp"

#include <cstdint>

namespace abut::device {

template <class Spheres>
void CudaExecutor::for_each(std::uint64_t count, const DecideOpen<Spheres>& body) {
  run(count, body);
}

template void CudaExecutor::for_each(std::uint64_t,
                                     const DecideOpen<PeriodicElements<JoinedBoxes<2>>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const DecideOpen<PeriodicElements<JoinedBoxes<3>>>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<PeriodicSpheres<2>>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<PeriodicSpheres<3>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const DecideOpen<CheckedElements<JoinedBoxes<2>>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const DecideOpen<CheckedElements<JoinedBoxes<3>>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const DecideOpen<CheckedElements<JoinedColumns<2>>>&);
template void CudaExecutor::for_each(std::uint64_t,
                                     const DecideOpen<CheckedElements<JoinedColumns<3>>>&);

}  // namespace abut::device
