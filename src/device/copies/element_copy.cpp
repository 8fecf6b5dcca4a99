#include "base/lack_of_memory.hpp"
#include "device/copies/device_blocks.hpp"

#include <abut/column.hpp>
#include <abut/device_elements.hpp>

#include <array>
#include <cstddef>
#include <memory>

namespace abut::device {
namespace {

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
