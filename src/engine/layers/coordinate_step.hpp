#pragma once

#include "base/progress_reporter.hpp"
#include "kernels/layers/layer_kernels.hpp"
#include "kernels/strided_spheres.hpp"

#include <cstddef>
#include <optional>

namespace abut::engine {

/// Powers of two.
struct StepRange {
  double least;
  double largest;
};

/// Returns the largest power of two in the range of which all coordinates of the spheres are
/// multiples, as those of a lattice may be. A look at a few of them shows what it must be, or that
/// there is none; all are looked at, by all workers, where those few agree.
template <int Dim>
[[nodiscard]] std::optional<double> coordinate_step(const kernels::StridedSpheres& spheres,
                                                    const StepRange& range,
                                                    const kernels::LayerKernels& kernels,
                                                    std::size_t workers, base::WorkCounter& work);

}  // namespace abut::engine
