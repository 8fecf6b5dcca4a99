#include "device/bodies/decide.hpp"
#include "device/cuda/cuda_executor.cuh"

#include <cstdint>

namespace abut::device {

template <class Spheres>
void CudaExecutor::for_each(std::uint64_t count, const DecideOpen<Spheres>& body) {
  run(count, body);
}

template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<SphereColumns<2, float>>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<SphereColumns<2, double>>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<SphereColumns<3, float>>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<SphereColumns<3, double>>&);

}  // namespace abut::device
