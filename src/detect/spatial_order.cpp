#include <abut/spatial_order.hpp>

#include "base/asking_workers.hpp"
#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/curve_sort.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/hilbert_curve.hpp"
#include "kernels/simd_level.hpp"
#include "kernels/strided_boxes.hpp"

#include <abut/domain.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut {
namespace {

/// Steps that a number along the curve takes, compared to a test in a vector.
constexpr std::uint64_t steps_of_number = 32;

/// The cells of the cube around the centers. Halves are subtracted, since the width of the cube may
/// exceed the largest double.
template <int Dim>
class CurveCells {
 public:
  explicit CurveCells(const grid::Bounds<Dim>& bounds) : lower_(bounds.lower) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      half_width_ = std::max(half_width_, 0.5 * bounds.upper[axis] - 0.5 * bounds.lower[axis]);
    }
  }

  [[nodiscard]] std::uint64_t along(const exact::Sphere<Dim>& sphere) const noexcept {
    std::array<std::uint32_t, Dim> cell{};
    for (std::size_t axis = 0; axis < Dim && half_width_ > 0.0; ++axis) {
      const double part = (0.5 * sphere.center[axis] - 0.5 * lower_[axis]) / half_width_;
      cell[axis] = static_cast<std::uint32_t>(std::min(part * cells, cells - 1.0));
    }
    return elements::HilbertCurve<Dim, bits>::number(cell);
  }

 private:
  static constexpr int bits = Dim == 2 ? 31 : 21;
  static constexpr double cells = std::uint32_t{1} << bits;

  std::array<double, Dim> lower_;
  double half_width_ = 0.0;
};

/// A sphere whose center is where the element lies: a box where its lower corner is.
template <int Dim>
exact::Sphere<Dim> sphere_in_place_of(const ElementView& elements, std::size_t k) {
  if (elements.shape() == Shape::box) {
    return kernels::stand_in(elements::box_at<Dim>(elements, k));
  }
  return elements::sphere_at<Dim>(elements, k);
}

template <int Dim>
std::vector<ElementIndex> order_along_curve(const ElementView& elements, const Options& options,
                                            base::DetectionContext& context) {
  const std::size_t count = elements.size();
  const std::size_t workers = base::worker_count(options.threads, count);
  elements::GatheredElements<Dim> gathered(context.memory);
  context.progress.begin("gather", count);
  elements::bound<Dim>(elements, {workers, kernels::level_to_run(options.simd)}, gathered, context);
  if (count == 0) return {};

  context.progress.begin("order", count);
  elements::CurveSort sort(context.memory, count, workers);
  const CurveCells<Dim> cells(gathered.bounds);
  base::for_each_share(workers, context.work, [&](std::size_t share, base::WorkCounter& work) {
    const auto [first, last] = base::share_of(share, workers, count);
    work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        sort.places()[k] = {cells.along(sphere_in_place_of<Dim>(elements, k)),
                            static_cast<ElementIndex>(k)};
      }
      work.did(steps_of_number * (end - begin));
    });
  });
  std::vector<ElementIndex> order(count);
  sort.write_order(order, context.work);
  return order;
}

}  // namespace

std::vector<ElementIndex> spatial_order(const ElementView& elements, const Options& options) {
  const base::FloatEnvironment environment;
  base::MemoryMeter memory;
  return base::reporting_lack_of_memory(memory, [&] {
    detect::validate(options, elements, Domain::open());
    memory.start_anew(detect::memory_bound(options));
    base::DetectionContext context(memory, options.progress);
    return base::letting_through([&] {
      return elements.dimensions() == 2 ? order_along_curve<2>(elements, options, context)
                                        : order_along_curve<3>(elements, options, context);
    });
  });
}

}  // namespace abut
