#pragma once

#include <abut/error.hpp>

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace abut::base {

/// Carries an exception of the caller's hook or visitor through a detection that would take it for
/// its own lack of memory or its own error.
struct CallersException {
  std::exception_ptr exception;
};

/// Calls back; lack of memory and errors in there are the caller's own.
template <class Callback>
decltype(auto) call_back(Callback&& callback) {
  try {
    return std::forward<Callback>(callback)();
  } catch (const std::bad_alloc&) {
    throw CallersException{std::current_exception()};
  } catch (const std::length_error&) {
    throw CallersException{std::current_exception()};
  } catch (const Error&) {
    throw CallersException{std::current_exception()};
  }
}

/// Runs `body`, and throws the caller's exception as it was.
template <class Body>
decltype(auto) letting_through(Body&& body) {
  try {
    return std::forward<Body>(body)();
  } catch (const CallersException& theirs) {
    std::rethrow_exception(theirs.exception);
  }
}

}  // namespace abut::base
