#include "base/lack_of_memory.hpp"

#include <abut/element_view.hpp>
#include <abut/error.hpp>

#include <string>

namespace abut {
namespace {

std::string column_name(const ElementView& elements, std::size_t column) {
  const auto axes = static_cast<std::size_t>(elements.dimensions());
  const std::string axis(1, "xyz"[column % axes]);
  if (elements.shape() == Shape::box) return axis + (column < axes ? "min" : "max");
  return column < axes ? axis : "radius";
}

}  // namespace

void ElementView::require_size(std::size_t column, std::size_t size) const {
  if (size == size_) return;
  base::reporting_lack_of_memory([&] {
    throw Error(ErrorCode::invalid_input,
                "the arrays differ in length: " + column_name(*this, 0) + " has " +
                    std::to_string(size_) + " numbers and " + column_name(*this, column) + " has " +
                    std::to_string(size) + "; give one number per element in each");
  });
}

}  // namespace abut
