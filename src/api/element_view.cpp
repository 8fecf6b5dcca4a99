#include <abut/element_view.hpp>
#include <abut/error.hpp>

#include <string>

namespace abut {

void ElementView::require_size(std::size_t column, std::size_t size) const {
  if (size == size_) return;
  static constexpr const char* name[] = {"x", "y", "z"};
  const char* what = column == static_cast<std::size_t>(dimensions_) ? "radius" : name[column];
  throw Error(ErrorCode::invalid_input,
              "the arrays differ in length: x has " + std::to_string(size_) + " numbers and " +
                  what + " has " + std::to_string(size) + "; give one number per element in each");
}

}  // namespace abut
