#pragma once

#include "base/progress_reporter.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
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

/// The steps of coordinates with which distances are exact in cells of that size.
template <int Dim>
[[nodiscard]] StepRange steps_for(double cell, const SearchInput<Dim>& input);

/// Tells whether a look at a few spheres leaves it open that there is a power of two in the range
/// of which all coordinates are multiples.
template <int Dim>
[[nodiscard]] bool may_have_step(const kernels::StridedSpheres& spheres, const StepRange& range);

/// Returns the largest such power of two, as the coordinates of a lattice may have. A look at a few
/// shows what it must be, or that there is none; all are looked at, by all workers, where those few
/// agree.
template <int Dim>
[[nodiscard]] std::optional<double> coordinate_step(const kernels::StridedSpheres& spheres,
                                                    const StepRange& range,
                                                    const kernels::LayerKernels& kernels,
                                                    std::size_t workers, base::WorkCounter& work);

/// Returns a grid like this one in which all distances of a set are exact, if its elements as given
/// have coordinates that allow it: no pair will be left undecided.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> layers_in_steps(const SearchSet<Dim>& set,
                                                            const SearchInput<Dim>& input,
                                                            const LayerGrid<Dim>& grid,
                                                            std::size_t workers,
                                                            base::WorkCounter& work);

}  // namespace abut::engine
