#include "device/cuda/array_place.hpp"
#include "device/cuda/cuda_error.hpp"

#include <cuda_runtime_api.h>

namespace abut::device {

ArrayPlace place_of_array(const void* address) {
  cudaPointerAttributes attributes{};
  require(cudaPointerGetAttributes(&attributes, address), "tell where an array lies");
  switch (attributes.type) {
    case cudaMemoryTypeManaged:
      return {ArrayPlace::Memory::shared, attributes.device};
    case cudaMemoryTypeDevice:
      return {ArrayPlace::Memory::device, attributes.device};
    default:
      return {ArrayPlace::Memory::host, 0};
  }
}

}  // namespace abut::device
