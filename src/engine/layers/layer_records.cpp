#include "engine/layers/layer_records.hpp"

#include "base/asking_workers.hpp"

#include <algorithm>

namespace abut::engine {

template <int Dim>
LayerRecords<Dim>::LayerRecords(base::MemoryMeter& memory)
    : records_(base::make_array_for_overwrite<kernels::PositionRecord>(memory, 0)),
      radii_(base::make_array_for_overwrite<float>(memory, 0)),
      begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
      cursors_(begin_) {}

template <int Dim>
void LayerRecords<Dim>::sort(std::span<const exact::Sphere<Dim>> spheres,
                             const LayerGrid<Dim>& grid, const kernels::LayerKernels& kernels,
                             std::size_t workers, base::WorkCounter& work) {
  const std::size_t layers = grid.layer_count();
  base::make_room(cursors_, workers * layers);
  base::make_room(records_, spheres.size());
  has_radii_ = !grid.has_equal_radii();
  if (has_radii_) base::make_room(radii_, spheres.size());
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    std::uint64_t* const counts = cursors_.data() + worker * layers;
    std::fill_n(counts, layers, std::uint64_t{0});
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++counts[grid.layer(spheres[k])];
    });
  });
  lay_out(layers, workers);
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const kernels::RecordsByLayer to{cursors_.data() + worker * layers, records_.data(),
                                     has_radii_ ? radii_.data() : nullptr};
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      std::size_t k = begin + kernels.scatter(spheres[begin].center, end - begin, Dim, grid.map(),
                                              static_cast<std::uint32_t>(begin), to);
      for (; k < end; ++k) {
        const std::uint64_t place = to.cursors[grid.layer(spheres[k])]++;
        to.records[place] = grid.record(spheres[k], static_cast<std::uint32_t>(k));
        if (has_radii_) to.radii[place] = grid.units_of(spheres[k].radius);
      }
    });
  });
}

/// Turns counts into places.
template <int Dim>
void LayerRecords<Dim>::lay_out(std::size_t layers, std::size_t workers) {
  base::make_room(begin_, layers + 1);
  largest_ = 0;
  std::uint64_t filled = 0;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    begin_[layer] = filled;
    for (std::size_t w = 0; w < workers; ++w) {
      std::uint64_t& cursor = cursors_[w * layers + layer];
      const std::uint64_t count = cursor;
      cursor = filled;
      filled += count;
    }
    largest_ = std::max(largest_, static_cast<std::size_t>(filled - begin_[layer]));
  }
  begin_[layers] = filled;
}

template class LayerRecords<2>;
template class LayerRecords<3>;

}  // namespace abut::engine
