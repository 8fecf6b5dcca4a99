#include "number_buffer.hpp"

#include <cstring>
#include <memory>

namespace abut::python {

NumberBuffer::NumberBuffer(nb::handle array) {
  auto view = std::make_unique<Py_buffer>();
  if (PyObject_GetBuffer(array.ptr(), view.get(), PyBUF_STRIDES | PyBUF_FORMAT) != 0) {
    throw nb::python_error();
  }
  view_.reset(view.release());
}

char NumberBuffer::letter() const noexcept {
  const char* format = view_->format;
  return format != nullptr && std::strlen(format) == 1 ? *format : '?';
}

bool NumberBuffer::is_contiguous() const noexcept {
  return PyBuffer_IsContiguous(view_.get(), 'C') != 0;
}

}  // namespace abut::python
