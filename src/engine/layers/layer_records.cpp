#include "engine/layers/layer_records.hpp"

#include "base/asking_workers.hpp"
#include "base/fetch_next_line.hpp"

namespace abut::engine {

template <int Dim>
LayerRecords<Dim>::LayerRecords(base::MemoryMeter& memory)
    : records_(base::make_array_for_overwrite<kernels::PositionRecord>(memory, 0)),
      radii_(base::make_array_for_overwrite<float>(memory, 0)),
      spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      cursors_(memory) {}

template <int Dim>
void LayerRecords<Dim>::sort(const kernels::SphereParts& spheres, const LayerGrid<Dim>& grid,
                             LayerItems items, const kernels::LayerKernels& kernels,
                             std::size_t workers, base::WorkCounter& work, FarSpheres<Dim>& far) {
  if (grid.is_by_size()) far.start(workers);
  cursors_.start(grid.layer_count(), workers);
  base::make_room(records_, spheres.size());
  has_radii_ = !grid.has_equal_radii();
  if (has_radii_) base::make_room(radii_, spheres.size());
  has_spheres_ = items == LayerItems::records_and_spheres;
  if (has_spheres_) base::make_room(spheres_, spheres.size());
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    std::uint64_t* const counts = cursors_.of(worker);
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      count(spheres.some(begin, end), grid, counts);
    });
  });
  cursors_.lay_out();
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      scatter(spheres.some(begin, end), grid, kernels, cursors_.of(worker));
      // Their numbers are in a cache now.
      if (grid.is_by_size()) far.note(spheres, grid, begin, end, worker);
    });
  });
  if (grid.is_by_size()) far.sort(grid);
}

template <int Dim>
void LayerRecords<Dim>::count(const kernels::SomeSpheres& some, const LayerGrid<Dim>& grid,
                              std::uint64_t* counts) const {
  for (const auto& [columns, begin, end, number_of_first] : some) {
    for (std::size_t k = begin; k < end; ++k) {
      ++counts[grid.layer_of_coordinate(*columns.place(grid.layer_axis(), k))];
    }
  }
}

template <int Dim>
void LayerRecords<Dim>::scatter(const kernels::SomeSpheres& some, const LayerGrid<Dim>& grid,
                                const kernels::LayerKernels& kernels, std::uint64_t* cursors) {
  for (const auto& [columns, begin, end, number_of_first] : some) {
    const kernels::RecordsByLayer to{cursors, records_.data(), has_radii_ ? radii_.data() : nullptr,
                                     number_of_first};
    std::size_t k = begin;
    if (!has_spheres_) k += kernels.scatter(columns, begin, end - begin, Dim, grid.map(), to);
    for (; k < end; ++k) {
      const exact::Sphere<Dim> sphere = kernels::sphere_at<Dim>(columns, k);
      const std::uint64_t place = to.cursors[grid.layer(sphere)]++;
      base::fetch_next_line(to.records + place);
      to.records[place] = grid.record(sphere, number_of_first + static_cast<std::uint32_t>(k));
      if (has_radii_) to.radii[place] = grid.units_of(sphere.radius);
      if (!has_spheres_) continue;
      base::fetch_next_line(spheres_.data() + place);
      spheres_[place] = sphere;
    }
  }
}

template class LayerRecords<2>;
template class LayerRecords<3>;

}  // namespace abut::engine
