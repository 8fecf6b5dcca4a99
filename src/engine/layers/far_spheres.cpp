#include "engine/layers/far_spheres.hpp"

#include "base/asking_workers.hpp"
#include "engine/layers/large_elements.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::engine {
namespace {

/// Far elements that take as long to sort as threads take to wake.
constexpr std::size_t least_shared = 1024;

}  // namespace

template <int Dim>
void FarSpheres<Dim>::start(std::size_t workers) {
  workers_ = workers;
  while (noted_.size() < workers) noted_.push_back(empty(memory_));
  for (List& list : noted_) list.clear();
}

template <int Dim>
void FarSpheres<Dim>::note(const LayerSpheres<Dim>& spheres, const LayerGrid<Dim>& grid,
                           std::size_t begin, std::size_t end, std::size_t worker) {
  for_each_block_with_large(spheres, grid.least_far_radius(), begin, end,
                            [&](std::size_t, std::size_t, std::span<const std::uint32_t> large) {
                              note_far(large, spheres, grid, noted_[worker]);
                            });
}

/// Adds to a list those of some spheres that are far.
template <int Dim>
void FarSpheres<Dim>::note_far(std::span<const std::uint32_t> numbers,
                               const LayerSpheres<Dim>& spheres, const LayerGrid<Dim>& grid,
                               List& list) {
  const auto note = [&](kernels::FarSphere far) {
    const auto layers = grid.layers_around(far);
    far.first_layer = layers.first;
    far.last_layer = layers.last;
    list.push_back(far);
  };
  for (const std::uint32_t number : numbers) {
    const exact::Sphere<Dim> sphere = spheres[number];
    if (grid.has_widths()) {
      const kernels::BoxSize<Dim> size = grid.size_of(spheres.boxes(), number);
      if (grid.is_far(size.radius)) note(grid.far_box(grid.record(sphere, number), size));
      continue;
    }
    const float radius = grid.units_of(sphere.radius);
    if (grid.is_far(radius)) note(grid.far_sphere(grid.record(sphere, number), radius));
  }
}

template <int Dim>
void FarSpheres<Dim>::note_coarse(const kernels::FarSphere& coarse, std::size_t worker) {
  if (coarse.first_layer <= coarse.last_layer) noted_[worker].push_back(coarse);
}

/// The workers that sort: all of them, where what was noted takes longer, and more memory, than
/// their counts.
template <int Dim>
std::size_t FarSpheres<Dim>::sorters_for(std::size_t layers) const {
  std::size_t noted = 0;
  for (const List& list : noted_) noted += list.size();
  return noted >= std::max(least_shared, layers * workers_) ? workers_ : 1;
}

/// Calls body(far, sorter) for all that were noted, in this order for each sorter.
template <int Dim>
template <class Body>
void FarSpheres<Dim>::for_each_noted(std::size_t sorters, base::WorkCounter& work,
                                     const Body& body) const {
  const auto visit = [&](const List& list, std::size_t sorter, base::WorkCounter& its_work) {
    its_work.in_pieces(0, list.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) body(list[k], sorter);
    });
  };
  if (sorters == 1) {
    for (const List& list : noted_) visit(list, 0, work);
    return;
  }
  base::for_each_share(sorters, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    visit(noted_[worker], worker, its_work);
  });
}

template <int Dim>
void FarSpheres<Dim>::sort(const LayerGrid<Dim>& grid, base::WorkCounter& work) {
  const std::size_t layers = grid.layer_count();
  const std::size_t sorters = sorters_for(layers);
  cursors_.start(layers, sorters);
  leaving_.start(layers, sorters);
  for_each_noted(sorters, work, [&](const kernels::FarSphere& far, std::size_t sorter) {
    ++cursors_.of(sorter)[far.first_layer];
    ++leaving_.of(sorter)[far.last_layer];
  });
  cursors_.lay_out();
  leaving_.lay_out();
  base::make_room(elements_, cursors_.total());
  for_each_noted(sorters, work, [&](const kernels::FarSphere& far, std::size_t sorter) {
    elements_[cursors_.of(sorter)[far.first_layer]++] = far;
  });
  count_in_reach(layers);
}

template <int Dim>
void FarSpheres<Dim>::count_in_reach(std::size_t layers) {
  most_in_reach_ = 0;
  std::size_t in_reach = 0;
  for (std::size_t k = 0; k < layers; ++k) {
    in_reach += cursors_.size(k);
    most_in_reach_ = std::max(most_in_reach_, in_reach);
    in_reach -= leaving_.size(k);
  }
}

template <int Dim>
FarSpheresInReach<Dim>::FarSpheresInReach(base::MemoryMeter& memory)
    : elements_(base::make_array_for_overwrite<kernels::FarSphere>(memory, 0)) {}

template <int Dim>
void FarSpheresInReach<Dim>::start(const FarSpheres<Dim>& all, std::size_t k) {
  elements_.clear();
  append(all.from_before(k), k);
  append(all.from(k), k);
}

template <int Dim>
void FarSpheresInReach<Dim>::advance(const FarSpheres<Dim>& all, std::size_t k) {
  std::erase_if(elements_, [&](const kernels::FarSphere& far) { return far.last_layer < k; });
  append(all.from(k), k);
}

template <int Dim>
void FarSpheresInReach<Dim>::append(std::span<const kernels::FarSphere> elements, std::size_t k) {
  for (const kernels::FarSphere& far : elements) {
    if (far.last_layer >= k) elements_.push_back(far);
  }
}

template class FarSpheres<2>;
template class FarSpheres<3>;
template class FarSpheresInReach<2>;
template class FarSpheresInReach<3>;

}  // namespace abut::engine
