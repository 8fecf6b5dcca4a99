#include "device/bodies/decide.hpp"
#include "device/cuda/cuda_executor.cuh"

namespace abut::device {

template <int Dim, class T>
void CudaExecutor::for_each(std::uint64_t count, const DecideOpen<Dim, T>& body) {
  run(count, body);
}

template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<2, float>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<2, double>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<3, float>&);
template void CudaExecutor::for_each(std::uint64_t, const DecideOpen<3, double>&);

}  // namespace abut::device
