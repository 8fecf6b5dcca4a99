#include "device/cuda/cuda_error.hpp"
#include "device/cuda/device_columns.hpp"

#include <abut/error.hpp>

#include <cuda_runtime_api.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::device {
namespace {

[[noreturn]] void refuse(const char* column, const std::string& fault, const char* advice) {
  throw Error(ErrorCode::wrong_usage,
              std::string("the column ") + column + " " + fault + "; " + advice);
}

void require_column(const ElementView::Numbers& numbers, const char* name, std::ptrdiff_t size,
                    int device) {
  if (numbers.first == nullptr) refuse(name, "is null", "pass an address of the device");
  if (reinterpret_cast<std::uintptr_t>(numbers.first) % static_cast<std::uintptr_t>(size) != 0 ||
      numbers.stride_bytes % size != 0) {
    refuse(name, "is not aligned for its numbers", "copy it to an array of its type");
  }
  cudaPointerAttributes attributes{};
  require(cudaPointerGetAttributes(&attributes, numbers.first), "tell where an array lies");
  if (attributes.type == cudaMemoryTypeManaged) return;
  if (attributes.type != cudaMemoryTypeDevice) {
    refuse(name, "lies in the memory of the host", "copy it to the device, or take abut::Detector");
  }
  if (attributes.device == device) return;
  refuse(name, "lies on device " + std::to_string(attributes.device),
         "make the detector on that device");
}

}  // namespace

void require_device_columns(const ElementView& spheres, int device) {
  if (spheres.size() == 0) return;
  static constexpr const char* axis_name[] = {"x", "y", "z"};
  const std::ptrdiff_t size =
      spheres.precision() == Precision::float64 ? sizeof(double) : sizeof(float);
  for (int axis = 0; axis < spheres.dimensions(); ++axis) {
    require_column(spheres.center(axis), axis_name[axis], size, device);
  }
  if (!spheres.has_common_radius()) require_column(spheres.radii(), "radius", size, device);
}

}  // namespace abut::device
