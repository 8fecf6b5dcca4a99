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

template <int Dim>
void widen(grid::Bounds<Dim>& bounds, const base::Sphere<Dim>& sphere) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    bounds.lower[axis] = std::min(bounds.lower[axis], sphere.center[axis]);
    bounds.upper[axis] = std::max(bounds.upper[axis], sphere.center[axis]);
  }
  if (sphere.radius > bounds.second_largest_radius) {
    bounds.second_largest_radius = std::min(sphere.radius, bounds.largest_radius);
    bounds.largest_radius = std::max(sphere.radius, bounds.largest_radius);
  }
}

template <int Dim, Real T>
void read_all(const ElementView& elements, GatheredElements<Dim>& gathered,
              base::DetectionContext& context) {
  const base::Sphere<Dim> first = read<Dim, T>(elements, 0);
  std::copy_n(first.center, Dim, gathered.bounds.lower.begin());
  std::copy_n(first.center, Dim, gathered.bounds.upper.begin());
  for (std::size_t k = 0; k < elements.size(); ++k) {
    context.progress.at(k);
    const base::Sphere<Dim> sphere = read<Dim, T>(elements, k);
    if (!valid(sphere)) reject(k, sphere);
    widen(gathered.bounds, sphere);
    gathered.spheres[k] = sphere;
  }
}

}  // namespace

template <int Dim>
GatheredElements<Dim> gather(const ElementView& elements, base::DetectionContext& context) {
  GatheredElements<Dim> gathered{
      base::make_array_for_overwrite<base::Sphere<Dim>>(context.memory, elements.size()), {}};
  if (elements.size() == 0) return gathered;
  if (elements.precision() == Precision::float32) {
    read_all<Dim, float>(elements, gathered, context);
  } else {
    read_all<Dim, double>(elements, gathered, context);
  }
  return gathered;
}

template <int Dim>
base::Sphere<Dim> element_at(const ElementView& elements, std::size_t number) {
  return elements.precision() == Precision::float32 ? read<Dim, float>(elements, number)
                                                    : read<Dim, double>(elements, number);
}

template GatheredElements<2> gather(const ElementView&, base::DetectionContext&);
template GatheredElements<3> gather(const ElementView&, base::DetectionContext&);
template base::Sphere<2> element_at(const ElementView&, std::size_t);
template base::Sphere<3> element_at(const ElementView&, std::size_t);

}  // namespace abut::api
