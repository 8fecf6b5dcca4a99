// What a build without CUDA has of devices: none.

#include "device/backend.hpp"

#include <abut/error.hpp>

#include <memory>
#include <vector>

namespace abut::device {

// NOLINTNEXTLINE(performance-unnecessary-value-param): a build with CUDA keeps the allocator
std::unique_ptr<Backend> open_backend(int, Allocator) {
  throw Error(
      ErrorCode::unavailable,
      "no device can be used: this build of abut has no CUDA; build it with -DABUT_CUDA=ON, "
      "or take abut::Detector");
}

std::vector<DeviceInfo> found_devices() {
  return {};
}

}  // namespace abut::device
