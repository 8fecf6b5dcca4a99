#include <abut/spatial_order.hpp>

#include "base/array.hpp"
#include "base/asking_workers.hpp"
#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/fetch_next_line.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/hilbert_curve.hpp"
#include "kernels/simd_level.hpp"

#include <abut/domain.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace abut {
namespace {

/// Steps that a number along the curve takes, compared to a test in a vector.
constexpr std::uint64_t steps_of_number = 32;

/// An element and its number along the curve.
struct CurvePlace {
  std::uint64_t along;
  ElementIndex element;
};

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

/// Sorts by the number along the curve, digit by digit, stably. Digits that all have in common are
/// passed over.
void sort(base::Array<CurvePlace>& places, base::MemoryMeter& memory, base::WorkCounter& work) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  base::Array<CurvePlace> sorted =
      base::make_array_for_overwrite<CurvePlace>(memory, places.size());
  for (int shift = 0; shift < 64; shift += digit_bits) {
    const auto digit_of = [shift](const CurvePlace& place) {
      return place.along >> shift & (digits - 1);
    };
    std::array<std::size_t, digits> next{};
    work.in_pieces(0, places.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++next[digit_of(places[k])];
    });
    if (next[digit_of(places[0])] == places.size()) continue;
    std::exclusive_scan(next.begin(), next.end(), next.begin(), std::size_t{0});
    work.in_pieces(0, places.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        CurvePlace* const place = sorted.data() + next[digit_of(places[k])]++;
        base::fetch_next_line(place);
        *place = places[k];
      }
    });
    std::swap(places, sorted);
  }
}

template <int Dim>
std::vector<ElementIndex> order_along_curve(const ElementView& elements, const Options& options,
                                            base::DetectionContext& context) {
  const std::size_t workers = base::worker_count(options.threads, elements.size());
  elements::GatheredElements<Dim> gathered(context.memory);
  context.progress.begin("gather", elements.size());
  elements::gather<Dim>(elements, {workers, kernels::level_to_run(options.simd)}, gathered,
                        context);
  if (elements.size() == 0) return {};

  context.progress.begin("order", elements.size());
  auto places = base::make_array_for_overwrite<CurvePlace>(context.memory, elements.size());
  const CurveCells<Dim> cells(gathered.bounds);
  base::for_each_share(workers, context.work, [&](std::size_t share, base::WorkCounter& work) {
    const auto [first, last] = base::share_of(share, workers, places.size());
    work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        places[k] = {cells.along(gathered.spheres[k]), static_cast<ElementIndex>(k)};
      }
      work.did(steps_of_number * (end - begin));
    });
  });
  sort(places, context.memory, context.work);
  std::vector<ElementIndex> order(places.size());
  std::ranges::transform(places, order.begin(), &CurvePlace::element);
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
