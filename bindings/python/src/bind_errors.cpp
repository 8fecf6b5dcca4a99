#include "bind.hpp"

#include <abut/error.hpp>

#include <exception>

namespace abut::python {

namespace {

/// Raises the exception of the package that stands for the code; abut/_errors.py has the table.
void raise(const Error& error) {
  const nb::object errors = nb::module_::import_("abut._errors");
  const nb::object made = errors.attr("made")(static_cast<int>(error.code()), error.what());
  PyErr_SetObject(made.type().ptr(), made.ptr());
}

}  // namespace

void bind_errors(nb::module_&) {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace abut::python
