#pragma once

#include <abut/export.hpp>

#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>
#include <type_traits>
#include <utility>

namespace abut {

/// Types of numbers that elements may be given in.
template <class T>
concept Real = std::same_as<T, float> || std::same_as<T, double>;

/// View of one number per element in the caller's memory: the number of element k lies
/// `k * stride_bytes` behind `first`. The caller's array must outlive it.
template <Real T>
struct Column {
  const T* first = nullptr;                 ///< number of element 0
  std::size_t size = 0;                     ///< number of elements
  std::ptrdiff_t stride_bytes = sizeof(T);  ///< distance from one element to the next
};

/// Views contiguous numbers: a vector, span or array. Temporaries that own their numbers do not
/// compile.
template <std::ranges::contiguous_range R>
requires std::ranges::borrowed_range<R> && std::ranges::sized_range<R> &&
    Real<std::ranges::range_value_t<R>>
[[nodiscard]] constexpr auto column(R&& numbers) {
  using T = std::ranges::range_value_t<R>;
  return Column<T>{std::ranges::data(numbers), std::ranges::size(numbers), sizeof(T)};
}

/// Returns a column as it is.
template <Real T>
[[nodiscard]] constexpr Column<T> column(Column<T> numbers) {
  return numbers;
}

/// Views one member of an array of structs: `column(particles, &Particle::x)`.
template <std::ranges::contiguous_range R, class Struct, Real T>
requires std::ranges::borrowed_range<R> && std::ranges::sized_range<R> &&
    std::same_as<std::remove_cv_t<std::ranges::range_value_t<R>>, Struct>
[[nodiscard]] constexpr Column<T> column(R&& structs, T Struct::*member) {
  const std::size_t size = std::ranges::size(structs);
  if (size == 0) return {nullptr, 0, sizeof(Struct)};
  return {&(std::ranges::data(structs)[0].*member), size, sizeof(Struct)};
}

/// Types that `column` views: vectors, spans and arrays of float or double, and columns.
template <class X>
concept ColumnLike = requires(X&& numbers) {
  abut::column(static_cast<X&&>(numbers));
};

/// Type of the numbers that a ColumnLike holds: float or double.
template <class X>
using ColumnScalar =
    std::remove_cv_t<std::remove_pointer_t<decltype(abut::column(std::declval<X>()).first)>>;

}  // namespace abut
