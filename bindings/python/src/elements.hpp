#pragma once

#include "number_buffer.hpp"

#include <abut/element_view.hpp>

#include <string_view>
#include <utility>
#include <vector>

namespace abut::python {

/// Elements in arrays of Python, which it keeps alive and does not copy.
class Elements {
 public:
  Elements(std::vector<NumberBuffer> buffers, const ElementView& view)
      : buffers_(std::move(buffers)), view_(view) {}
  Elements(Elements&&) = default;
  Elements(const Elements&) = delete;

  [[nodiscard]] const ElementView& view() const noexcept { return view_; }
  [[nodiscard]] std::string_view shape_name() const noexcept;

 private:
  std::vector<NumberBuffer> buffers_;
  ElementView view_;
};

}  // namespace abut::python
