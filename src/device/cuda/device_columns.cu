#include "device/cuda/cuda_error.hpp"
#include "device/cuda/device_columns.hpp"

#include <abut/error.hpp>

#include <cuda_runtime_api.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::device {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& fault, const char* advice) {
  throw Error(ErrorCode::wrong_usage, "the " + name + " " + fault + "; " + advice);
}

void require_array(const ElementView::Numbers& numbers, const std::string& name,
                   std::ptrdiff_t size, int device) {
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
    const char* const end = spheres.shape() == Shape::box ? "min" : "";
    require_array(spheres.center(axis), std::string("column ") + axis_name[axis] + end, size,
                  device);
  }
  if (spheres.shape() == Shape::box) {
    for (int axis = 0; axis < spheres.dimensions(); ++axis) {
      require_array(spheres.upper(axis), std::string("column ") + axis_name[axis] + "max", size,
                    device);
    }
  }
  if (!spheres.has_common_radius()) require_array(spheres.radii(), "column radius", size, device);
}

void require_device_arrays(const PairRule& rule, int device) {
  const auto require_numbers = [&](const std::string& name, const auto& numbers) {
    if (numbers.empty()) return;
    constexpr std::ptrdiff_t size = sizeof(numbers[0]);
    require_array({reinterpret_cast<const std::byte*>(numbers.data()), size}, "array " + name, size,
                  device);
  };
  const auto require_traits = [&](const std::string& set, const PairTraits& traits) {
    require_numbers(set + ".groups", traits.groups);
    require_numbers(set + ".categories", traits.categories);
    require_numbers(set + ".accepts", traits.accepts);
  };
  require_traits("rule.elements", rule.elements);
  require_traits("rule.others", rule.others);
}

}  // namespace abut::device
