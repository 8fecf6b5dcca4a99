#pragma once

#include "device/backend.hpp"

#include <abut/column.hpp>
#include <abut/element_view.hpp>

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

namespace abut::device {

/// Blocks in the memory of a device, released together.
class DeviceBlocks {
 public:
  explicit DeviceBlocks(int device) : backend_(open_backend(device)) {}
  ~DeviceBlocks() {
    for (void* block : blocks_) backend_->release(block);
  }
  DeviceBlocks(const DeviceBlocks&) = delete;
  DeviceBlocks& operator=(const DeviceBlocks&) = delete;

  /// Copies numbers of the host, however far apart, into a block of their own without gaps.
  template <class T>
  Column<T> copied(const ElementView::Numbers& numbers, std::size_t count) {
    if (count == 0) return {};
    std::vector<T> packed(count);
    for (std::size_t k = 0; k < count; ++k) {
      const auto offset = static_cast<std::ptrdiff_t>(k) * numbers.stride_bytes;
      std::memcpy(&packed[k], numbers.first + offset, sizeof(T));
    }
    return {copied(std::span<const T>(packed)).data(), count};
  }

  /// Copies an array; that of the copy lies on the device.
  template <class T>
  std::span<const T> copied(std::span<const T> array) {
    if (array.empty()) return {};
    blocks_.reserve(blocks_.size() + 1);
    void* const block = backend_->allocate(array.size_bytes());
    blocks_.push_back(block);
    backend_->copy_to_device(block, array.data(), array.size_bytes());
    return {static_cast<const T*>(block), array.size()};
  }

 private:
  std::unique_ptr<Backend> backend_;
  std::vector<void*> blocks_;
};

}  // namespace abut::device
