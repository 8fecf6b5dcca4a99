#include "base/lack_of_memory.hpp"
#include "device/backend.hpp"

#include <abut/column.hpp>
#include <abut/device_elements.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace abut::device {
namespace {

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
    blocks_.reserve(blocks_.size() + 1);
    void* const block = backend_->allocate(count * sizeof(T));
    blocks_.push_back(block);
    backend_->copy_to_device(block, packed.data(), count * sizeof(T));
    return {static_cast<const T*>(block), count};
  }

 private:
  std::unique_ptr<Backend> backend_;
  std::vector<void*> blocks_;
};

template <class T, std::size_t Dim>
ElementView copy_of(const ElementView& elements, DeviceBlocks& blocks) {
  const std::size_t count = elements.size();
  std::array<Column<T>, Dim> centers;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    centers[axis] = blocks.copied<T>(elements.center(static_cast<int>(axis)), count);
  }
  if (elements.shape() == Shape::box) {
    std::array<Column<T>, Dim> uppers;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      uppers[axis] = blocks.copied<T>(elements.upper(static_cast<int>(axis)), count);
    }
    return {centers, uppers};
  }
  if (elements.has_common_radius()) return {centers, elements.common_radius()};
  return {centers, blocks.copied<T>(elements.radii(), count)};
}

ElementView copy_of(const ElementView& elements, DeviceBlocks& blocks) {
  const bool is_double = elements.precision() == Precision::float64;
  if (elements.dimensions() == 2) {
    return is_double ? copy_of<double, 2>(elements, blocks) : copy_of<float, 2>(elements, blocks);
  }
  return is_double ? copy_of<double, 3>(elements, blocks) : copy_of<float, 3>(elements, blocks);
}

}  // namespace

struct ElementCopy::State {
  State(const ElementView& on_host, int device)
      : blocks(device), elements(copy_of(on_host, blocks)) {}

  DeviceBlocks blocks;
  ElementView elements;
};

ElementCopy::ElementCopy(const ElementView& on_host, Device device)
    : state_(base::reporting_lack_of_memory(
          [&] { return std::make_unique<State>(on_host, device.number); })) {}

ElementCopy::~ElementCopy() = default;
ElementCopy::ElementCopy(ElementCopy&&) noexcept = default;
ElementCopy& ElementCopy::operator=(ElementCopy&&) noexcept = default;

const ElementView& ElementCopy::elements() const noexcept {
  return state_->elements;
}

}  // namespace abut::device
