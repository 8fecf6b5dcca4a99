#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <memory>
#include <span>

namespace abut::python {

namespace nb = nanobind;

/// Memory of a Python array that is held, unmoved, as long as this lives: NumPy's own, whatever its
/// strides. Needs the interpreter's lock to be made and released.
class NumberBuffer {
 public:
  /// Holds the memory of an array. Throws nb::python_error if the object has none to show.
  explicit NumberBuffer(nb::handle array);

  [[nodiscard]] int axes() const noexcept { return view_->ndim; }
  [[nodiscard]] std::size_t size(int axis) const noexcept {
    return static_cast<std::size_t>(view_->shape[axis]);
  }
  [[nodiscard]] std::ptrdiff_t stride_bytes(int axis) const noexcept {
    return view_->strides[axis];
  }
  [[nodiscard]] const std::byte* first() const noexcept {
    return static_cast<const std::byte*>(view_->buf);
  }
  [[nodiscard]] std::size_t number_bytes() const noexcept {
    return static_cast<std::size_t>(view_->itemsize);
  }
  /// The letter of the type as the module `struct` has it: 'f', 'd', 'I', ...
  [[nodiscard]] char letter() const noexcept;
  /// True if the numbers lie side by side, row after row.
  [[nodiscard]] bool is_contiguous() const noexcept;

 private:
  struct Release {
    void operator()(Py_buffer* view) const noexcept {
      PyBuffer_Release(view);
      delete view;
    }
  };

  // A view may point into itself, so it stays where it was filled.
  std::unique_ptr<Py_buffer, Release> view_;
};

/// Returns whole numbers that lie side by side in the memory of an array; the package makes arrays
/// so. Throws nb::type_error for others.
template <class T>
[[nodiscard]] std::span<const T> whole_numbers_of(const NumberBuffer& buffer) {
  if (buffer.number_bytes() != sizeof(T) || !buffer.is_contiguous()) {
    throw nb::type_error("an array of whole numbers side by side is needed");
  }
  std::size_t count = 1;
  for (int axis = 0; axis < buffer.axes(); ++axis) count *= buffer.size(axis);
  return {reinterpret_cast<const T*>(buffer.first()), count};
}

}  // namespace abut::python
