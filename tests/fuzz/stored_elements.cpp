#include "fuzz/stored_elements.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace abut::fuzz {

StoredElements::StoredElements(const ElementArrays& elements, const Storage& storage)
    : elements_(elements), storage_(storage) {
  const auto axes = static_cast<std::size_t>(elements.dimensions);
  for (std::size_t axis = 0; axis < axes; ++axis) columns_.push_back(&elements.lower[axis]);
  if (elements.shape == Shape::box) {
    for (std::size_t axis = 0; axis < axes; ++axis) columns_.push_back(&elements.upper[axis]);
  } else {
    columns_.push_back(&elements.radius);
    const auto& radius = elements.radius;
    const bool equal = std::ranges::all_of(radius, [&](double r) { return r == radius[0]; });
    storage_.common_radius = storage.common_radius && equal && !radius.empty();
  }
  if (storage_.precision == Precision::float32) {
    store(floats_);
  } else {
    store(doubles_);
  }
}

/// Backwards, element k lies where the last but k would.
template <class T>
void StoredElements::store(std::vector<T>& memory) {
  const std::size_t count = elements_.size();
  const std::size_t width = columns_.size();
  memory.resize(count * width);
  for (std::size_t c = 0; c < width; ++c) {
    for (std::size_t k = 0; k < count; ++k) {
      const auto value = static_cast<T>((*columns_[c])[k]);
      const std::size_t place = storage_.layout == Layout::structs     ? k * width + c
                                : storage_.layout == Layout::backwards ? c * count + count - 1 - k
                                                                       : c * count + k;
      memory[place] = value;
    }
  }
}

template <class T, std::size_t Dim>
ElementView StoredElements::view_of(const std::vector<T>& memory) const {
  const std::size_t count = elements_.size();
  const auto column = [&](std::size_t c) {
    const auto bytes = static_cast<std::ptrdiff_t>(sizeof(T));
    if (count == 0) return Column<T>{};
    switch (storage_.layout) {
      case Layout::structs:
        return Column<T>{memory.data() + c, count,
                         bytes * static_cast<std::ptrdiff_t>(columns_.size())};
      case Layout::backwards:
        return Column<T>{memory.data() + c * count + count - 1, count, -bytes};
      default:
        return Column<T>{memory.data() + c * count, count, bytes};
    }
  };
  std::array<Column<T>, Dim> lower, upper;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    lower[axis] = column(axis);
    if (elements_.shape == Shape::box) upper[axis] = column(Dim + axis);
  }
  if (elements_.shape == Shape::box) return {lower, upper};
  if (storage_.common_radius) return {lower, elements_.radius[0]};
  return {lower, column(Dim)};
}

template <class T>
ElementView StoredElements::view_of(const std::vector<T>& memory) const {
  return elements_.dimensions == 2 ? view_of<T, 2>(memory) : view_of<T, 3>(memory);
}

ElementView StoredElements::view() const {
  return storage_.precision == Precision::float32 ? view_of(floats_) : view_of(doubles_);
}

}  // namespace abut::fuzz
