#pragma once

#include <abut/column.hpp>
#include <abut/export.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <ranges>
#include <type_traits>
#include <utility>

namespace abut {

/// Precision of the caller's numbers.
enum class Precision {
  float32,  ///< float
  float64,  ///< double
};

/// Shape of the elements of a view.
enum class Shape {
  sphere,  ///< spheres, in 2D discs
  box,     ///< closed axis-aligned boxes, in 2D rectangles
};

/// The elements of a detection, seen through the caller's arrays: spheres or boxes in 3D, discs or
/// rectangles in 2D, in float or double, structs or separate arrays. It owns nothing and copies
/// nothing; the arrays must outlive it and must not change while a detection runs.
///
/// The functions `spheres(...)`, `discs(...)`, `boxes(...)` and `rectangles(...)` make views.
class ElementView {
 public:
  /// A strided array of float or double; `precision()` says which.
  struct Numbers {
    const std::byte* first = nullptr;  ///< address of the number of element 0
    std::ptrdiff_t stride_bytes = 0;   ///< distance from one element to the next
  };

  /// Views spheres with a radius each. Columns of unequal length throw Error{invalid_input}.
  template <Real T, std::size_t Dim>
  ElementView(const std::array<Column<T>, Dim>& centers, Column<T> radii)
      : ElementView(Shape::sphere, centers, radii.size, numbers(radii), 0.0) {}

  /// Views spheres with one radius for all.
  template <Real T, std::size_t Dim>
  ElementView(const std::array<Column<T>, Dim>& centers, double radius)
      : ElementView(Shape::sphere, centers, centers[0].size, std::nullopt, radius) {}

  /// Views boxes by their lower and upper corners.
  template <Real T, std::size_t Dim>
  ElementView(const std::array<Column<T>, Dim>& lower, const std::array<Column<T>, Dim>& upper)
      : ElementView(Shape::box, lower, lower[0].size, std::nullopt, 0.0) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      uppers_[axis] = numbers(upper[axis]);
      require_size(Dim + axis, upper[axis].size);
    }
  }

  /// Number of elements.
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// Shape of all elements.
  [[nodiscard]] Shape shape() const noexcept { return shape_; }
  /// Number of dimensions, 2 or 3.
  [[nodiscard]] int dimensions() const noexcept { return dimensions_; }
  /// Precision of the caller's numbers.
  [[nodiscard]] Precision precision() const noexcept { return precision_; }

  /// Centers of spheres along an axis; for boxes the same as `lower`.
  [[nodiscard]] const Numbers& center(int axis) const noexcept {
    return centers_[static_cast<std::size_t>(axis)];
  }
  /// Lower bounds of boxes along an axis.
  [[nodiscard]] const Numbers& lower(int axis) const noexcept { return center(axis); }
  /// Upper bounds of boxes along an axis.
  [[nodiscard]] const Numbers& upper(int axis) const noexcept {
    return uppers_[static_cast<std::size_t>(axis)];
  }
  /// True if one radius holds for all spheres; also for boxes.
  [[nodiscard]] bool has_common_radius() const noexcept { return !radii_.has_value(); }
  /// Radius of all spheres, if there is a common one; 0 for boxes.
  [[nodiscard]] double common_radius() const noexcept { return common_radius_; }
  /// Radii of spheres. Call it only if there is no common radius.
  [[nodiscard]] const Numbers& radii() const noexcept { return *radii_; }

 private:
  template <Real T, std::size_t Dim>
  ElementView(Shape shape, const std::array<Column<T>, Dim>& centers, std::size_t radius_count,
              std::optional<Numbers> radii, double common_radius)
      : size_(centers[0].size),
        shape_(shape),
        dimensions_(static_cast<int>(Dim)),
        precision_(std::same_as<T, float> ? Precision::float32 : Precision::float64),
        radii_(radii),
        common_radius_(common_radius) {
    static_assert(Dim == 2 || Dim == 3);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      centers_[axis] = numbers(centers[axis]);
      require_size(axis, centers[axis].size);
    }
    require_size(Dim, radius_count);
  }

  template <Real T>
  static Numbers numbers(const Column<T>& column) {
    return {reinterpret_cast<const std::byte*>(column.first), column.stride_bytes};
  }

  /// Columns count the axes, then the radii or once more the axes.
  ABUT_API void require_size(std::size_t column, std::size_t size) const;

  std::size_t size_ = 0;
  Shape shape_ = Shape::sphere;
  int dimensions_ = 0;
  Precision precision_ = Precision::float64;
  std::array<Numbers, 3> centers_{};  ///< lower corners of boxes
  std::array<Numbers, 3> uppers_{};
  std::optional<Numbers> radii_;
  double common_radius_ = 0.0;
};

namespace detail {

/// Radii are a column of the positions' type, or one number.
template <class R, class T>
concept RadiiOf = (ColumnLike<R> && std::same_as<ColumnScalar<R>, T>) ||
                  std::is_arithmetic_v<std::remove_cvref_t<R>>;

template <Real T, std::size_t Dim, class R>
ElementView view(const std::array<Column<T>, Dim>& centers, R&& radii) {
  if constexpr (std::is_arithmetic_v<std::remove_cvref_t<R>>) {
    return {centers, static_cast<double>(radii)};
  } else {
    return {centers, column(static_cast<R&&>(radii))};
  }
}

/// A point is anything indexable that lies in memory as Dim numbers in a row: std::array<T, Dim>,
/// T[Dim], a vector of a linear-algebra library.
template <class P>
using PointScalar = std::remove_cvref_t<decltype(std::declval<const P&>()[0])>;

/// A type of points: not a container or a view, whose numbers lie elsewhere.
template <class P>
concept HoldsItsNumbers = std::is_trivially_destructible_v<P> && !std::ranges::borrowed_range<P>;

template <class Points, std::size_t Dim>
concept PointsOf = std::ranges::contiguous_range<Points> && std::ranges::borrowed_range<Points> &&
                   std::ranges::sized_range<Points> && !ColumnLike<Points> &&
                   HoldsItsNumbers<std::ranges::range_value_t<Points>> &&
                   Real<PointScalar<std::ranges::range_value_t<Points>>> &&
                   sizeof(std::ranges::range_value_t<Points>) >=
                       Dim * sizeof(PointScalar<std::ranges::range_value_t<Points>>);

template <class R, class Points>
concept RadiiOfPoints = RadiiOf<R, PointScalar<std::ranges::range_value_t<Points>>>;

template <std::size_t Dim, class Points>
auto columns(Points&& points) {
  using Point = std::ranges::range_value_t<Points>;
  using T = PointScalar<Point>;
  std::array<Column<T>, Dim> result{};
  const std::size_t size = std::ranges::size(points);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const T* first = size == 0 ? nullptr : &std::ranges::data(points)[0][0] + axis;
    result[axis] = {first, size, sizeof(Point)};
  }
  return result;
}

}  // namespace detail

/// Views spheres in separate arrays. `radii` is an array of the same type or one number for all.
template <ColumnLike X, ColumnLike Y, ColumnLike Z, detail::RadiiOf<ColumnScalar<X>> R>
requires std::same_as<ColumnScalar<X>, ColumnScalar<Y>> &&
    std::same_as<ColumnScalar<X>, ColumnScalar<Z>>
[[nodiscard]] ElementView spheres(X&& x, Y&& y, Z&& z, R&& radii) {
  using T = ColumnScalar<X>;
  return detail::view(
      std::array<Column<T>, 3>{column(static_cast<X&&>(x)), column(static_cast<Y&&>(y)),
                               column(static_cast<Z&&>(z))},
      static_cast<R&&>(radii));
}

/// Views discs in separate arrays. `radii` is an array of the same type or one number for all.
template <ColumnLike X, ColumnLike Y, detail::RadiiOf<ColumnScalar<X>> R>
requires std::same_as<ColumnScalar<X>, ColumnScalar<Y>>
[[nodiscard]] ElementView discs(X&& x, Y&& y, R&& radii) {
  using T = ColumnScalar<X>;
  return detail::view(
      std::array<Column<T>, 2>{column(static_cast<X&&>(x)), column(static_cast<Y&&>(y))},
      static_cast<R&&>(radii));
}

/// Views spheres in an array of points of three numbers.
template <class Points, class R>
requires detail::PointsOf<Points, 3> && detail::RadiiOfPoints<R, Points>
[[nodiscard]] ElementView spheres(Points&& centers, R&& radii) {
  return detail::view(detail::columns<3>(static_cast<Points&&>(centers)), static_cast<R&&>(radii));
}

/// Views discs in an array of points of two numbers.
template <class Points, class R>
requires detail::PointsOf<Points, 2> && detail::RadiiOfPoints<R, Points>
[[nodiscard]] ElementView discs(Points&& centers, R&& radii) {
  return detail::view(detail::columns<2>(static_cast<Points&&>(centers)), static_cast<R&&>(radii));
}

/// Views closed boxes in six arrays of one type: xmin, ymin, zmin, xmax, ymax, zmax. The detection
/// checks that no lower bound exceeds the upper one.
template <ColumnLike X, ColumnLike... Others>
requires(sizeof...(Others) == 5 && (std::same_as<ColumnScalar<X>, ColumnScalar<Others>> && ...))
    [[nodiscard]] ElementView boxes(X&& xmin, Others&&... ymin_zmin_xmax_ymax_zmax) {
  using T = ColumnScalar<X>;
  const std::array<Column<T>, 6> all{column(static_cast<X&&>(xmin)),
                                     column(static_cast<Others&&>(ymin_zmin_xmax_ymax_zmax))...};
  return ElementView(std::array<Column<T>, 3>{all[0], all[1], all[2]},
                     std::array<Column<T>, 3>{all[3], all[4], all[5]});
}

/// Views closed rectangles in four arrays of one type: xmin, ymin, xmax, ymax.
template <ColumnLike X, ColumnLike... Others>
requires(sizeof...(Others) == 3 && (std::same_as<ColumnScalar<X>, ColumnScalar<Others>> && ...))
    [[nodiscard]] ElementView rectangles(X&& xmin, Others&&... ymin_xmax_ymax) {
  using T = ColumnScalar<X>;
  const std::array<Column<T>, 4> all{column(static_cast<X&&>(xmin)),
                                     column(static_cast<Others&&>(ymin_xmax_ymax))...};
  return ElementView(std::array<Column<T>, 2>{all[0], all[1]},
                     std::array<Column<T>, 2>{all[2], all[3]});
}

/// Views boxes in two arrays, of their lower and of their upper corners: points of three numbers.
template <class Lower, class Upper>
requires detail::PointsOf<Lower, 3> && detail::PointsOf<Upper, 3>
[[nodiscard]] ElementView boxes(Lower&& lower, Upper&& upper) {
  return ElementView(detail::columns<3>(static_cast<Lower&&>(lower)),
                     detail::columns<3>(static_cast<Upper&&>(upper)));
}

/// Views rectangles in two arrays, of their lower and of their upper corners: points of two
/// numbers.
template <class Lower, class Upper>
requires detail::PointsOf<Lower, 2> && detail::PointsOf<Upper, 2>
[[nodiscard]] ElementView rectangles(Lower&& lower, Upper&& upper) {
  return ElementView(detail::columns<2>(static_cast<Lower&&>(lower)),
                     detail::columns<2>(static_cast<Upper&&>(upper)));
}

namespace detail {

namespace mistake {
struct raw_pointers_tell_no_size_pass_std_span {};
struct float_and_double_are_mixed_convert_one {};
}  // namespace mistake

template <class... Args>
concept raw_pointers_tell_no_size_pass_std_span = (std::is_pointer_v<std::remove_cvref_t<Args>> ||
                                                   ...);

/// Tells whether a type is an array of T, or of points of T.
template <class X, class T>
inline constexpr bool holds = false;
template <ColumnLike X, class T>
inline constexpr bool holds<X, T> = std::same_as<ColumnScalar<X>, T>;
template <class X, class T>
requires PointsOf<X, 2>
inline constexpr bool holds<X, T> = std::same_as<PointScalar<std::ranges::range_value_t<X>>, T>;

template <class... Args>
concept float_and_double_are_mixed_convert_one =
    !raw_pointers_tell_no_size_pass_std_span<Args...> && (holds<Args, float> || ...) &&
    (holds<Args, double> || ...);

}  // namespace detail

// Mistakes that are made often end in one sentence instead of a list of all functions: clang shows
// the text of the attribute, g++ the name of the type. Neither counts as a function that fits.
#if defined(__clang__)
#define ABUT_MISTAKE(Kind, text, function) \
  template <class... Args>                 \
  requires detail::Kind<Args...>           \
  __attribute__((unavailable(text))) ElementView function(Args&&...);
#else
#define ABUT_MISTAKE(Kind, text, function)                                 \
  template <class... Args>                                                 \
  requires detail::Kind<Args...> detail::mistake::Kind function(Args&&...) \
  = delete;
#endif
ABUT_MISTAKE(raw_pointers_tell_no_size_pass_std_span,
             "raw pointers tell no size: pass std::span(pointer, size)", spheres)
ABUT_MISTAKE(float_and_double_are_mixed_convert_one,
             "float and double are mixed: convert one of them", spheres)
ABUT_MISTAKE(raw_pointers_tell_no_size_pass_std_span,
             "raw pointers tell no size: pass std::span(pointer, size)", discs)
ABUT_MISTAKE(float_and_double_are_mixed_convert_one,
             "float and double are mixed: convert one of them", discs)
ABUT_MISTAKE(raw_pointers_tell_no_size_pass_std_span,
             "raw pointers tell no size: pass std::span(pointer, size)", boxes)
ABUT_MISTAKE(float_and_double_are_mixed_convert_one,
             "float and double are mixed: convert one of them", boxes)
ABUT_MISTAKE(raw_pointers_tell_no_size_pass_std_span,
             "raw pointers tell no size: pass std::span(pointer, size)", rectangles)
ABUT_MISTAKE(float_and_double_are_mixed_convert_one,
             "float and double are mixed: convert one of them", rectangles)
#undef ABUT_MISTAKE

}  // namespace abut
