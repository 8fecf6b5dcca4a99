#include "api/gathered_elements.hpp"

#include "base/workers.hpp"
#include "base/written.hpp"
#include "kernels/element_kernels.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace abut::api {
namespace {

constexpr std::size_t elements_between_polls = 4096;

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

/// The columns that the vector kernels can read: contiguous doubles.
std::optional<kernels::ElementColumns> contiguous_columns(const ElementView& elements) {
  if (elements.precision() != Precision::float64 || elements.has_common_radius()) return {};
  kernels::ElementColumns columns{};
  bool contiguous = true;
  const auto column = [&](const ElementView::Numbers& numbers) {
    contiguous = contiguous && numbers.stride_bytes == sizeof(double) &&
                 reinterpret_cast<std::uintptr_t>(numbers.first) % alignof(double) == 0;
    return reinterpret_cast<const double*>(numbers.first);
  };
  for (int axis = 0; axis < elements.dimensions(); ++axis) {
    columns.center[axis] = column(elements.center(axis));
  }
  columns.radius = column(elements.radii());
  return contiguous ? std::optional(columns) : std::nullopt;
}

/// Reads parts of the elements, one part a worker.
template <int Dim>
class Gatherer {
 public:
  Gatherer(const ElementView& elements, std::span<base::Sphere<Dim>> spheres, Simd simd)
      : elements_(elements),
        spheres_(spheres),
        columns_(contiguous_columns(elements)),
        kernels_(kernels::element_kernels(simd)) {}

  /// Bounds of the elements [first, last). Throws at the first bad one.
  [[nodiscard]] grid::Bounds<Dim> read(std::size_t first, std::size_t last) const {
    grid::Bounds<Dim> bounds;
    std::size_t k = first;
    if (columns_) k += pack(first, last - first, bounds);
    for (; k < last; ++k) {
      const base::Sphere<Dim> sphere = element_at<Dim>(elements_, k);
      if (!valid(sphere)) reject(k, sphere);
      bounds.include_center(sphere);
      bounds.include_radius(sphere.radius);
      spheres_[k] = sphere;
    }
    return bounds;
  }

 private:
  std::size_t pack(std::size_t first, std::size_t count, grid::Bounds<Dim>& bounds) const {
    kernels::ElementColumns columns = *columns_;
    for (int axis = 0; axis < Dim; ++axis) columns.center[axis] += first;
    columns.radius += first;
    kernels::ElementBounds packed{};
    std::copy(bounds.lower.begin(), bounds.lower.end(), packed.lower);
    std::copy(bounds.upper.begin(), bounds.upper.end(), packed.upper);
    packed.smallest_radius = bounds.smallest_radius;
    const std::size_t done = kernels_.pack(columns, count, Dim, spheres_[first].center, packed);
    if (done == 0) return 0;
    std::copy_n(packed.lower, Dim, bounds.lower.begin());
    std::copy_n(packed.upper, Dim, bounds.upper.begin());
    bounds.smallest_radius = packed.smallest_radius;
    bounds.largest_radius = packed.largest_radius;
    bounds.second_largest_radius = packed.second_largest_radius;
    return done;
  }

  const ElementView& elements_;
  std::span<base::Sphere<Dim>> spheres_;
  std::optional<kernels::ElementColumns> columns_;
  kernels::ElementKernels kernels_;
};

}  // namespace

template <int Dim>
void gather(const ElementView& elements, const GatherSettings& settings,
            GatheredElements<Dim>& gathered, base::DetectionContext& context) {
  auto& spheres = gathered.spheres;
  if (spheres.capacity() < elements.size()) spheres.clear();
  spheres.resize(elements.size());
  gathered.bounds = {.lower = {}, .upper = {}, .smallest_radius = 0.0};
  if (elements.size() == 0) return;

  const Gatherer<Dim> gatherer(elements, spheres, settings.simd);
  gathered.parts.assign(settings.workers, {});
  // Each worker its part in order, and of two exceptions the first worker's is thrown: that of the
  // first bad element.
  base::for_each_worker(settings.workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, settings.workers, elements.size());
    for (std::size_t k = first; k < last; k += elements_between_polls) {
      if (worker == 0) context.progress.report(k);
      gathered.parts[worker].include(gatherer.read(k, std::min(k + elements_between_polls, last)));
    }
  });
  gathered.bounds = {};
  for (const grid::Bounds<Dim>& part : gathered.parts) gathered.bounds.include(part);
}

template <int Dim>
base::Sphere<Dim> element_at(const ElementView& elements, std::size_t number) {
  return elements.precision() == Precision::float32 ? read<Dim, float>(elements, number)
                                                    : read<Dim, double>(elements, number);
}

template void gather(const ElementView&, const GatherSettings&, GatheredElements<2>&,
                     base::DetectionContext&);
template void gather(const ElementView&, const GatherSettings&, GatheredElements<3>&,
                     base::DetectionContext&);
template base::Sphere<2> element_at(const ElementView&, std::size_t);
template base::Sphere<3> element_at(const ElementView&, std::size_t);

}  // namespace abut::api
