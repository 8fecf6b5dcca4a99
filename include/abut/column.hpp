#pragma once

#include <abut/export.hpp>

#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>
#include <type_traits>

namespace abut {

template <class T>
concept Real = std::same_as<T, float> || std::same_as<T, double>;

/// One number per element in the caller's memory: element k lies `k * stride_bytes` behind `first`.
/// A view: the caller's array must outlive it.
template <Real T>
struct Column {
  const T* first = nullptr;
  std::size_t size = 0;
  std::ptrdiff_t stride_bytes = sizeof(T);
};

/// Contiguous numbers: a vector, span or array. Temporaries that own their numbers do not compile.
template <std::ranges::contiguous_range R>
requires std::ranges::borrowed_range<R> && std::ranges::sized_range<R> &&
    Real<std::ranges::range_value_t<R>>
[[nodiscard]] constexpr auto column(R&& numbers) {
  using T = std::ranges::range_value_t<R>;
  return Column<T>{std::ranges::data(numbers), std::ranges::size(numbers), sizeof(T)};
}

template <Real T>
[[nodiscard]] constexpr Column<T> column(Column<T> numbers) {
  return numbers;
}

/// One member of an array of structs: `column(particles, &Particle::x)`.
template <std::ranges::contiguous_range R, class Struct, Real T>
requires std::ranges::borrowed_range<R> && std::ranges::sized_range<R> &&
    std::same_as<std::remove_cv_t<std::ranges::range_value_t<R>>, Struct>
[[nodiscard]] constexpr Column<T> column(R&& structs, T Struct::*member) {
  const std::size_t size = std::ranges::size(structs);
  if (size == 0) return {nullptr, 0, sizeof(Struct)};
  return {&(std::ranges::data(structs)[0].*member), size, sizeof(Struct)};
}

template <class X>
concept ColumnLike = requires(X&& numbers) {
  abut::column(static_cast<X&&>(numbers));
};

template <class X>
using ColumnScalar =
    std::remove_cv_t<std::remove_pointer_t<decltype(abut::column(std::declval<X>()).first)>>;

}  // namespace abut
