#pragma once

#include <abut/column.hpp>
#include <abut/element_view.hpp>

#include <cstddef>
#include <cstring>

namespace abut::elements {

/// Reads strided numbers of one type, which need not be aligned.
template <Real T>
class NumberReader {
 public:
  explicit NumberReader(const ElementView::Numbers& numbers) : numbers_(numbers) {}

  double operator[](std::size_t k) const {
    T value;
    std::memcpy(&value, numbers_.first + static_cast<std::ptrdiff_t>(k) * numbers_.stride_bytes,
                sizeof value);
    return static_cast<double>(value);
  }

 private:
  ElementView::Numbers numbers_;
};

}  // namespace abut::elements
