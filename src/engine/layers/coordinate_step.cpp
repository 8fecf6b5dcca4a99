#include "engine/layers/coordinate_step.hpp"

#include "base/asking_workers.hpp"
#include "exact/numbers/bit_range.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace abut::engine {
namespace {

/// Spheres that are looked at first, spread over all.
constexpr std::size_t samples = 64;

/// Returns the largest power of two in the range of which the coordinates of some spheres are
/// multiples.
template <int Dim>
std::optional<double> step_of_samples(const kernels::StridedSpheres& spheres,
                                      const StepRange& range) {
  if (spheres.size == 0 || range.largest == 0.0) return std::nullopt;
  exact::BitRange bits;
  bits.include(range.largest);
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const std::size_t k = sample * (spheres.size - 1) / (samples - 1);
    for (const double x : kernels::sphere_at<Dim>(spheres, k).center) bits.include(x);
    if (std::ldexp(1.0, bits.lowest()) < range.least) return std::nullopt;
  }
  return std::ldexp(1.0, bits.lowest());
}

/// Neither product rounds unless the first one underflows: then the second one is 0.
bool is_multiple(double x, double step) {
  return std::nearbyint(x * (1.0 / step)) * step == x;
}

template <int Dim>
bool are_in_steps(const kernels::StridedSpheres& spheres, std::size_t begin, std::size_t end,
                  double step, const kernels::LayerKernels& kernels) {
  std::size_t k = begin + kernels.count_in_steps(spheres, begin, end - begin, Dim, step);
  for (; k < end; ++k) {
    for (const double x : kernels::sphere_at<Dim>(spheres, k).center) {
      if (!is_multiple(x, step)) return false;
    }
  }
  return true;
}

}  // namespace

template <int Dim>
bool may_have_step(const kernels::StridedSpheres& spheres, const StepRange& range) {
  return step_of_samples<Dim>(spheres, range).has_value();
}

template <int Dim>
std::optional<double> coordinate_step(const kernels::StridedSpheres& spheres,
                                      const StepRange& range, const kernels::LayerKernels& kernels,
                                      std::size_t workers, base::WorkCounter& work) {
  const std::optional<double> step = step_of_samples<Dim>(spheres, range);
  if (!step) return std::nullopt;
  std::atomic<bool> are_all = true;
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers, spheres.size);
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      if (!are_all.load(std::memory_order_relaxed)) return;
      if (!are_in_steps<Dim>(spheres, begin, end, *step, kernels)) {
        are_all.store(false, std::memory_order_relaxed);
      }
    });
  });
  return are_all ? step : std::nullopt;
}

template <int Dim>
StepRange steps_for(double cell, const SearchInput<Dim>& input) {
  return {std::max(input.given.least_step, LayerGrid<Dim>::least_step_of(cell)),
          input.given.largest_step};
}

template <int Dim>
std::optional<LayerGrid<Dim>> layers_in_steps(const SearchSet<Dim>& set,
                                              const SearchInput<Dim>& input,
                                              const LayerGrid<Dim>& grid, std::size_t workers,
                                              base::WorkCounter& work) {
  if (grid.shape() != kernels::ElementShape::equal_spheres || grid.has_long_cells()) {
    return std::nullopt;
  }
  const auto step = coordinate_step<Dim>(input.given.spheres, steps_for(grid.cell(), input),
                                         input.layer_kernels, workers, work);
  if (!step) return std::nullopt;
  return grid.in_steps(set.bounds, input.margin, set.locals.size(), *step);
}

template StepRange steps_for(double, const SearchInput<2>&);
template StepRange steps_for(double, const SearchInput<3>&);
template bool may_have_step<2>(const kernels::StridedSpheres&, const StepRange&);
template bool may_have_step<3>(const kernels::StridedSpheres&, const StepRange&);
template std::optional<double> coordinate_step<2>(const kernels::StridedSpheres&, const StepRange&,
                                                  const kernels::LayerKernels&, std::size_t,
                                                  base::WorkCounter&);
template std::optional<double> coordinate_step<3>(const kernels::StridedSpheres&, const StepRange&,
                                                  const kernels::LayerKernels&, std::size_t,
                                                  base::WorkCounter&);
template std::optional<LayerGrid<2>> layers_in_steps(const SearchSet<2>&, const SearchInput<2>&,
                                                     const LayerGrid<2>&, std::size_t,
                                                     base::WorkCounter&);
template std::optional<LayerGrid<3>> layers_in_steps(const SearchSet<3>&, const SearchInput<3>&,
                                                     const LayerGrid<3>&, std::size_t,
                                                     base::WorkCounter&);

}  // namespace abut::engine
