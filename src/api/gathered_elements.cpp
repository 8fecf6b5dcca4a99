#include "api/gathered_elements.hpp"

#include "base/written.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace abut::api {
namespace {

[[noreturn]] void reject(std::size_t element, const char* field, double value, const char* rule) {
  throw Error(ErrorCode::invalid_input, "element " + std::to_string(element) + " has " + field +
                                            " = " + base::written(value) + "; " + rule);
}

/// Names what is wrong with an element, x before y before z before the radius.
template <int Dim>
[[noreturn]] void reject(std::size_t number, const base::Sphere<Dim>& sphere) {
  static constexpr const char* axis_name[] = {"x", "y", "z"};
  for (int axis = 0; axis < Dim; ++axis) {
    if (!std::isfinite(sphere.center[axis])) {
      reject(number, axis_name[axis], sphere.center[axis],
             "positions must be finite: correct or remove this element");
    }
  }
  reject(number, "radius", sphere.radius,
         "radii must be finite and not negative: correct or remove this element");
}

/// Reads strided numbers of one type.
template <Real T>
class Reader {
 public:
  explicit Reader(const ElementView::Numbers& numbers) : numbers_(numbers) {}
  double operator[](std::size_t k) const {
    T value;
    std::memcpy(&value, numbers_.first + static_cast<std::ptrdiff_t>(k) * numbers_.stride_bytes,
                sizeof value);
    return static_cast<double>(value);
  }

 private:
  ElementView::Numbers numbers_;
};

template <int Dim, Real T>
base::Sphere<Dim> read(const ElementView& elements, std::size_t k) {
  base::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = Reader<T>(elements.center(axis))[k];
  sphere.radius =
      elements.has_common_radius() ? elements.common_radius() : Reader<T>(elements.radii())[k];
  return sphere;
}

template <int Dim>
bool valid(const base::Sphere<Dim>& sphere) {
  constexpr double largest = std::numeric_limits<double>::max();
  bool finite = sphere.radius >= 0.0 && sphere.radius <= largest;
  for (const double x : sphere.center) finite = finite && std::fabs(x) <= largest;
  return finite;
}

template <int Dim, Real T>
grid::Bounds<Dim> read_all(const ElementView& elements, std::span<base::Sphere<Dim>> spheres,
                           base::DetectionContext& context) {
  grid::Bounds<Dim> bounds;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    context.progress.at(k);
    const base::Sphere<Dim> sphere = read<Dim, T>(elements, k);
    if (!valid(sphere)) reject(k, sphere);
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
    spheres[k] = sphere;
  }
  return bounds;
}

}  // namespace

template <int Dim>
grid::Bounds<Dim> gather(const ElementView& elements, base::Array<base::Sphere<Dim>>& spheres,
                         base::DetectionContext& context) {
  if (spheres.capacity() < elements.size()) spheres.clear();
  spheres.resize(elements.size());
  if (elements.size() == 0) return {.lower = {}, .upper = {}, .smallest_radius = 0.0};
  return elements.precision() == Precision::float32
             ? read_all<Dim, float>(elements, spheres, context)
             : read_all<Dim, double>(elements, spheres, context);
}

template <int Dim>
base::Sphere<Dim> element_at(const ElementView& elements, std::size_t number) {
  return elements.precision() == Precision::float32 ? read<Dim, float>(elements, number)
                                                    : read<Dim, double>(elements, number);
}

template grid::Bounds<2> gather(const ElementView&, base::Array<base::Sphere<2>>&,
                                base::DetectionContext&);
template grid::Bounds<3> gather(const ElementView&, base::Array<base::Sphere<3>>&,
                                base::DetectionContext&);
template base::Sphere<2> element_at(const ElementView&, std::size_t);
template base::Sphere<3> element_at(const ElementView&, std::size_t);

}  // namespace abut::api
