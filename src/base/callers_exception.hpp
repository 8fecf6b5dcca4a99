#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace abut::base {

/// Carries an exception of the caller's hook or visitor through a detection that would take it for
/// its own lack of memory.
struct CallersException {
  std::exception_ptr exception;
};

/// Calls back; lack of memory in there is the caller's own.
template <class Callback>
decltype(auto) call_back(Callback&& callback) {
  try {
    return std::forward<Callback>(callback)();
  } catch (const std::bad_alloc&) {
    throw CallersException{std::current_exception()};
  } catch (const std::length_error&) {
    throw CallersException{std::current_exception()};
  }
}

}  // namespace abut::base
