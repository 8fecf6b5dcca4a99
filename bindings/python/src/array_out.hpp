#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut::python {

namespace nb = nanobind;

/// An array of NumPy that cannot be written.
template <class T>
using ReadOnlyArray = nb::ndarray<nb::numpy, const T>;

/// Shows numbers that `owner` holds; the array keeps the owner alive. No copy.
template <class T>
[[nodiscard]] ReadOnlyArray<T> array_of(std::span<const T> numbers, nb::handle owner) {
  return ReadOnlyArray<T>(numbers.data(), {numbers.size()}, owner);
}

/// Shows records of `width` numbers of type T each as rows of a table. No copy.
template <class T, class Record>
[[nodiscard]] ReadOnlyArray<T> table_of(std::span<const Record> records, nb::handle owner) {
  constexpr std::size_t width = sizeof(Record) / sizeof(T);
  static_assert(width * sizeof(T) == sizeof(Record));
  return ReadOnlyArray<T>(static_cast<const void*>(records.data()), {records.size(), width}, owner);
}

/// Makes a vector one that Python owns.
template <class Vector>
[[nodiscard]] std::pair<Vector&, nb::capsule> owned_by_python(Vector numbers) {
  auto kept = std::make_unique<Vector>(std::move(numbers));
  nb::capsule owner(kept.get(), [](void* vector) noexcept { delete static_cast<Vector*>(vector); });
  return {*kept.release(), std::move(owner)};
}

/// Gives a vector to NumPy, which may write to it.
template <class T, class Allocator>
[[nodiscard]] nb::ndarray<nb::numpy, T> given_away(std::vector<T, Allocator> numbers) {
  const auto [vector, owner] = owned_by_python(std::move(numbers));
  return nb::ndarray<nb::numpy, T>(vector.data(), {vector.size()}, owner);
}

/// Gives points or vectors to NumPy, as rows of a table.
template <class T, std::size_t Width, class Allocator>
[[nodiscard]] nb::ndarray<nb::numpy, T> table_given_away(
    std::vector<std::array<T, Width>, Allocator> records) {
  const auto [vector, owner] = owned_by_python(std::move(records));
  return nb::ndarray<nb::numpy, T>(static_cast<void*>(vector.data()), {vector.size(), Width},
                                   owner);
}

}  // namespace abut::python
