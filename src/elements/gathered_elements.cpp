#include "elements/gathered_elements.hpp"

#include "base/asking_workers.hpp"
#include "elements/number_reader.hpp"
#include "elements/reject_element.hpp"
#include "elements/sphere_reader.hpp"
#include "elements/strided_elements.hpp"
#include "elements/valid_element.hpp"
#include "grid/kernel_bounds.hpp"
#include "kernels/element_kernels.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace abut::elements {
namespace {

constexpr std::size_t elements_at_a_time = 1024;
/// Columns of an element are read one by one.
constexpr std::uint64_t steps_of_reading = 8;

template <int Dim, Real T>
exact::Sphere<Dim> read_sphere(const ElementView& elements, std::size_t k) {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis)
    sphere.center[axis] = NumberReader<T>(elements.center(axis))[k];
  sphere.radius = elements.has_common_radius() ? elements.common_radius()
                                               : NumberReader<T>(elements.radii())[k];
  return sphere;
}

template <int Dim, Real T>
exact::Box<Dim> read_box(const ElementView& elements, std::size_t k) {
  exact::Box<Dim> box{};
  for (int axis = 0; axis < Dim; ++axis) {
    box.lower[axis] = NumberReader<T>(elements.lower(axis))[k];
    box.upper[axis] = NumberReader<T>(elements.upper(axis))[k];
  }
  return box;
}

/// Reads parts of the elements, one part a worker, and keeps them where there is room for all.
template <int Dim>
class Gatherer {
 public:
  Gatherer(const ElementView& view, GatheredElements<Dim>& gathered, Simd simd)
      : elements_(view),
        spheres_(gathered.spheres),
        boxes_(gathered.boxes),
        kernels_(kernels::element_kernels(simd)) {
    if (view.shape() == Shape::box) {
      boxes_in_place_ = strided_boxes(view);
      return;
    }
    reader_.emplace(view);
    common_radius_ = view.common_radius();
    in_place_ = strided_spheres(view, &common_radius_);
  }

  Gatherer(const Gatherer&) = delete;
  Gatherer& operator=(const Gatherer&) = delete;
  ~Gatherer() = default;

  /// Bounds of the elements [first, last). Throws at the first bad one.
  [[nodiscard]] grid::Bounds<Dim> read(std::size_t first, std::size_t last) const {
    grid::Bounds<Dim> bounds;
    if (elements_.shape() == Shape::box) {
      read_boxes(first, last, bounds);
    } else {
      read_spheres(first, last, bounds);
    }
    return bounds;
  }

 private:
  [[nodiscard]] bool keeps() const noexcept { return !spheres_.empty(); }

  /// At most elements_at_a_time.
  void read_spheres(std::size_t first, std::size_t last, grid::Bounds<Dim>& bounds) const {
    if (in_place_) first += read_vectors(*in_place_, first, {first, last}, bounds);
    if (first == last) return;
    // Columns, which suit vectors, or the last spheres of such as suited them before.
    std::array<double, SphereReader::numbers * elements_at_a_time> room;
    const std::size_t count = last - first;
    const kernels::ElementColumns columns = reader_->read(first, count, room);
    std::size_t k =
        read_vectors(kernels::strided_spheres(columns, count), 0, {first, last}, bounds);
    for (; k < count; ++k) {
      const exact::Sphere<Dim> sphere = sphere_at<Dim>(columns, k);
      if (!is_valid(sphere)) reject_element(first + k, sphere);
      if (keeps()) spheres_[first + k] = sphere;
      bounds.include_center(sphere);
      bounds.include_radius(sphere.radius);
    }
  }

  struct NumberRange {
    std::size_t first;
    std::size_t last;
  };

  /// Reads spheres in vectors, from this place of the columns on, and returns how many.
  std::size_t read_vectors(const kernels::StridedSpheres& columns, std::size_t place,
                           const NumberRange& numbers, grid::Bounds<Dim>& bounds) const {
    const std::size_t count = numbers.last - numbers.first;
    return grid::widen(bounds, [&](kernels::ElementBounds& widened) {
      return keeps() ? kernels_.pack(columns, place, count, Dim, spheres_[numbers.first].center,
                                     widened)
                     : kernels_.check(columns, place, count, Dim, widened);
    });
  }

  void read_boxes(std::size_t first, std::size_t last, grid::Bounds<Dim>& bounds) const {
    if (boxes_in_place_) {
      const kernels::StridedBoxes columns = *boxes_in_place_;
      read_boxes({first, last}, bounds,
                 [columns](std::size_t k) { return kernels::box_at<Dim>(columns, k); });
    } else {
      read_boxes({first, last}, bounds,
                 [this](std::size_t k) { return box_at<Dim>(elements_, k); });
    }
  }

  template <class BoxOf>
  void read_boxes(const NumberRange& numbers, grid::Bounds<Dim>& bounds,
                  const BoxOf& box_of) const {
    const auto read_all = [&](const auto& keep) {
      grid::Bounds<Dim> widened = bounds;  // in registers, whatever is kept
      for (std::size_t k = numbers.first; k < numbers.last; ++k) {
        const exact::Box<Dim> box = box_of(k);
        if (!is_valid(box)) reject_element(k, box);
        const exact::Sphere<Dim> sphere = kernels::stand_in(box);
        keep(k, box, sphere);
        widened.include_center(sphere);
        widened.include_radius(sphere.radius);
      }
      bounds = widened;
    };
    if (!keeps()) return read_all([](std::size_t, const auto&, const auto&) {});
    read_all([this](std::size_t k, const exact::Box<Dim>& box, const exact::Sphere<Dim>& sphere) {
      boxes_[k] = box;
      spheres_[k] = sphere;
    });
  }

  const ElementView& elements_;
  std::span<exact::Sphere<Dim>> spheres_;
  std::span<exact::Box<Dim>> boxes_;
  std::optional<SphereReader> reader_;               ///< of spheres
  double common_radius_ = 0.0;                       ///< if they have one
  std::optional<kernels::StridedSpheres> in_place_;  ///< if they can be read so
  std::optional<kernels::StridedBoxes> boxes_in_place_;
  kernels::ElementKernels kernels_;
};

template <int Dim>
void read_all(const ElementView& elements, const GatherSettings& settings,
              GatheredElements<Dim>& gathered, base::DetectionContext& context) {
  gathered.bounds = {.lower = {}, .upper = {}, .smallest_radius = 0.0};
  if (elements.size() == 0) return;

  const Gatherer<Dim> gatherer(elements, gathered, settings.simd);
  gathered.parts.assign(settings.workers, {});
  // Each worker reads its part in order. If several workers throw, the exception of the first one
  // counts, which names the first bad element.
  base::for_each_share(
      settings.workers, context.work, [&](std::size_t share, base::WorkCounter& work) {
        const auto [first, last] = base::share_of(share, settings.workers, elements.size());
        for (std::size_t k = first; k < last; k += elements_at_a_time) {
          const std::size_t end = std::min(k + elements_at_a_time, last);
          gathered.parts[share].include(gatherer.read(k, end));
          context.progress.advance(end - k);
          work.did(steps_of_reading * (end - k));
        }
      });
  gathered.bounds = {};
  for (const grid::Bounds<Dim>& part : gathered.parts) gathered.bounds.include(part);
  if (elements.shape() == Shape::box) gathered.bounds.count_largest_twice();
}

}  // namespace

template <int Dim>
void gather(const ElementView& elements, const GatherSettings& settings,
            GatheredElements<Dim>& gathered, base::DetectionContext& context) {
  base::resize_for_overwrite(gathered.spheres, elements.size());
  base::resize_for_overwrite(gathered.boxes, elements.shape() == Shape::box ? elements.size() : 0);
  read_all(elements, settings, gathered, context);
}

template <int Dim>
void bound(const ElementView& elements, const GatherSettings& settings,
           GatheredElements<Dim>& gathered, base::DetectionContext& context) {
  gathered.spheres.clear();
  gathered.boxes.clear();
  read_all(elements, settings, gathered, context);
}

template <int Dim>
exact::Sphere<Dim> sphere_at(const ElementView& elements, std::size_t number) {
  return elements.precision() == Precision::float32 ? read_sphere<Dim, float>(elements, number)
                                                    : read_sphere<Dim, double>(elements, number);
}

template <int Dim>
exact::Box<Dim> box_at(const ElementView& elements, std::size_t number) {
  return elements.precision() == Precision::float32 ? read_box<Dim, float>(elements, number)
                                                    : read_box<Dim, double>(elements, number);
}

template void gather(const ElementView&, const GatherSettings&, GatheredElements<2>&,
                     base::DetectionContext&);
template void gather(const ElementView&, const GatherSettings&, GatheredElements<3>&,
                     base::DetectionContext&);
template void bound(const ElementView&, const GatherSettings&, GatheredElements<2>&,
                    base::DetectionContext&);
template void bound(const ElementView&, const GatherSettings&, GatheredElements<3>&,
                    base::DetectionContext&);
template exact::Sphere<2> sphere_at(const ElementView&, std::size_t);
template exact::Sphere<3> sphere_at(const ElementView&, std::size_t);
template exact::Box<2> box_at(const ElementView&, std::size_t);
template exact::Box<3> box_at(const ElementView&, std::size_t);

}  // namespace abut::elements
