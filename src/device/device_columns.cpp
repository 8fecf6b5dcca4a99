#include "device/device_columns.hpp"

#include <abut/error.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::device {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& fault, const char* advice) {
  throw Error(ErrorCode::wrong_usage, "the " + name + " " + fault + "; " + advice);
}

/// Requires that a device can read arrays.
class DeviceArrays {
 public:
  DeviceArrays(int device, const FindPlace& place_of) : device_(device), place_of_(place_of) {}

  void require(const ElementView::Numbers& numbers, const std::string& name,
               std::ptrdiff_t size) const {
    if (numbers.first == nullptr) refuse(name, "is null", "pass an address of the device");
    if (reinterpret_cast<std::uintptr_t>(numbers.first) % static_cast<std::uintptr_t>(size) != 0 ||
        numbers.stride_bytes % size != 0) {
      refuse(name, "is not aligned for its numbers", "copy it to an array of its type");
    }
    const ArrayPlace place = place_of_(numbers.first);
    if (place.memory == ArrayPlace::Memory::shared) return;
    if (place.memory == ArrayPlace::Memory::host) {
      refuse(name, "lies in the memory of the host",
             "copy it to the device, or take abut::Detector");
    }
    if (place.device == device_) return;
    refuse(name, "lies on device " + std::to_string(place.device),
           "make the detector on that device");
  }

 private:
  int device_;
  const FindPlace& place_of_;
};

}  // namespace

void require_device_columns(const ElementView& spheres, int device, const FindPlace& place_of) {
  if (spheres.size() == 0) return;
  const DeviceArrays arrays(device, place_of);
  static constexpr const char* axis_name[] = {"x", "y", "z"};
  const std::ptrdiff_t size =
      spheres.precision() == Precision::float64 ? sizeof(double) : sizeof(float);
  for (int axis = 0; axis < spheres.dimensions(); ++axis) {
    const char* const end = spheres.shape() == Shape::box ? "min" : "";
    arrays.require(spheres.center(axis), std::string("column ") + axis_name[axis] + end, size);
  }
  if (spheres.shape() == Shape::box) {
    for (int axis = 0; axis < spheres.dimensions(); ++axis) {
      arrays.require(spheres.upper(axis), std::string("column ") + axis_name[axis] + "max", size);
    }
  }
  if (!spheres.has_common_radius()) arrays.require(spheres.radii(), "column radius", size);
}

void require_device_arrays(const PairRule& rule, int device, const FindPlace& place_of) {
  const DeviceArrays arrays(device, place_of);
  const auto require_numbers = [&](const std::string& name, const auto& numbers) {
    if (numbers.empty()) return;
    constexpr std::ptrdiff_t size = sizeof(numbers[0]);
    arrays.require({reinterpret_cast<const std::byte*>(numbers.data()), size}, "array " + name,
                   size);
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
