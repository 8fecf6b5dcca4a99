#include "engine/layers/layer_records.hpp"

#include "base/asking_workers.hpp"
#include "base/fetch_next_line.hpp"

#include <algorithm>
#include <array>

namespace abut::engine {
namespace {

/// Spheres one after the other from which on it pays to scatter them in vectors.
constexpr std::size_t least_in_vectors = 8;

/// Calls visit(from, to) with the places in a part of stretches that stand in layers.
template <int Dim, class Visit>
void for_each_stretch(const LayerSpheres<Dim>& spheres, const kernels::SpheresOfPart& some,
                      const Visit& visit) {
  const std::size_t first = some.number_of_first;
  spheres.for_each_stretch(
      first + some.begin, first + some.end,
      [&](std::size_t from, std::size_t to) { visit(from - first, to - first); });
}

/// Spheres that are moved with their clusters, a block of them side by side.
template <int Dim>
class MovedBlock {
 public:
  static constexpr std::size_t size = 128;

  /// The spheres from place `first` of the columns on, which have these numbers. Radii stay where
  /// they are.
  kernels::StridedSpheres of(const LayerSpheres<Dim>& spheres,
                             const kernels::StridedSpheres& columns, std::size_t first,
                             std::size_t count, std::size_t number_of_first) noexcept {
    kernels::StridedSpheres block{{}, {1, 1, 1, 1}, count};
    constexpr int radii = kernels::StridedSpheres::radii;
    block.begin[radii] = columns.place(radii, first);
    block.stride[radii] = columns.stride[radii];
    for (std::size_t axis = 0; axis < Dim; ++axis) block.begin[axis] = centers_[axis].data();
    for (std::size_t k = 0; k < count; ++k) {
      const auto sphere =
          spheres.moved(kernels::sphere_at<Dim>(columns, first + k), number_of_first + k);
      for (std::size_t axis = 0; axis < Dim; ++axis) centers_[axis][k] = sphere.center[axis];
    }
    return block;
  }

 private:
  std::array<std::array<double, size>, Dim> centers_;
};

/// Scatters moved spheres [from, last) of the columns, the first of which has the number
/// `to.number_of_first`, and returns the end of those that it treated.
template <int Dim>
std::size_t scatter_moved(const LayerSpheres<Dim>& spheres, const kernels::StridedSpheres& columns,
                          std::size_t from, std::size_t last, const LayerGrid<Dim>& grid,
                          const kernels::LayerKernels& kernels, kernels::RecordsByLayer to) {
  const std::uint32_t number_of_columns = to.number_of_first;
  MovedBlock<Dim> block;
  while (last - from >= least_in_vectors) {
    const std::size_t count = std::min(MovedBlock<Dim>::size, last - from);
    to.number_of_first = number_of_columns + static_cast<std::uint32_t>(from);
    const auto moved = block.of(spheres, columns, from, count, to.number_of_first);
    const std::size_t treated = kernels.scatter(moved, 0, count, Dim, grid.map(), to);
    if (treated == 0) break;
    from += treated;
  }
  return from;
}

}  // namespace

template <int Dim>
LayerRecords<Dim>::LayerRecords(base::MemoryMeter& memory)
    : records_(base::make_array_for_overwrite<kernels::PositionRecord>(memory, 0)),
      radii_(base::make_array_for_overwrite<float>(memory, 0)),
      widths_(base::make_array_for_overwrite<std::array<float, Dim>>(memory, 0)),
      spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      cursors_(memory) {}

template <int Dim>
void LayerRecords<Dim>::sort(const LayerSpheres<Dim>& spheres, const LayerGrid<Dim>& grid,
                             LayerItems items, const kernels::LayerKernels& kernels,
                             std::size_t workers, base::WorkCounter& work, FarSpheres<Dim>& far) {
  if (grid.is_by_size()) far.start(workers);
  cursors_.start(grid.layer_count(), workers);
  base::make_room(records_, spheres.size());
  has_radii_ = grid.has_radii();
  if (has_radii_) base::make_room(radii_, spheres.size());
  has_widths_ = grid.has_widths();
  if (has_widths_) base::make_room(widths_, spheres.size());
  has_spheres_ = items == LayerItems::records_and_spheres;
  if (has_spheres_) base::make_room(spheres_, spheres.size());
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    std::uint64_t* const counts = cursors_.of(worker);
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      count(spheres, grid, kernels, {begin, end, counts});
    });
  });
  cursors_.lay_out();
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      scatter(spheres, grid, kernels, {begin, end, cursors_.of(worker)});
      // Their numbers are in a cache now.
      if (grid.is_by_size()) far.note(spheres, grid, begin, end, worker);
    });
  });
  if (grid.is_by_size()) far.sort(grid, work);
}

template <int Dim>
void LayerRecords<Dim>::count(const Spheres& spheres, const LayerGrid<Dim>& grid,
                              const kernels::LayerKernels& kernels,
                              const SpheresOfWorker& share) const {
  const int axis = grid.layer_axis();
  const auto layer_axis = static_cast<std::size_t>(axis);
  const bool are_moved = spheres.are_moved();
  for (const auto& some : spheres.given().some(share.begin, share.end)) {
    const kernels::StridedSpheres columns = some.columns;
    for_each_stretch(spheres, some, [&](std::size_t from, std::size_t to) {
      if (!are_moved && columns.stride[axis] == 1) {
        return kernels.count_layers(columns.place(axis, from), to - from, grid.map(),
                                    share.by_layer);
      }
      for (std::size_t k = from; k < to; ++k) {
        const double given = *columns.place(axis, k);
        const std::size_t number = some.number_of_first + k;
        const double x = are_moved ? spheres.moved(given, number, layer_axis) : given;
        ++share.by_layer[grid.layer_of_coordinate(x)];
      }
    });
  }
}

template <int Dim>
void LayerRecords<Dim>::scatter(const Spheres& spheres, const LayerGrid<Dim>& grid,
                                const kernels::LayerKernels& kernels,
                                const SpheresOfWorker& share) {
  const bool in_vectors = !has_spheres_;
  for (const auto& some : spheres.given().some(share.begin, share.end)) {
    const kernels::StridedSpheres columns = some.columns;
    const kernels::RecordsByLayer to{share.by_layer,
                                     records_.data(),
                                     has_radii_ ? radii_.data() : nullptr,
                                     has_widths_ ? widths_.data()->data() : nullptr,
                                     has_widths_ ? &spheres.boxes() : nullptr,
                                     some.number_of_first};
    for_each_stretch(spheres, some, [&](std::size_t from, std::size_t last) {
      std::size_t k = from;
      if (in_vectors && spheres.are_moved()) {
        k = scatter_moved(spheres, columns, from, last, grid, kernels, to);
      } else if (in_vectors && last - from >= least_in_vectors) {
        k += kernels.scatter(columns, from, last - from, Dim, grid.map(), to);
      }
      for (; k < last; ++k) {
        const auto number = to.number_of_first + static_cast<std::uint32_t>(k);
        const exact::Sphere<Dim> given = kernels::sphere_at<Dim>(columns, k);
        const exact::Sphere<Dim> sphere = spheres.moved(given, number);
        const std::uint64_t place = to.cursors[grid.layer(sphere)]++;
        base::fetch_next_line(to.records + place);
        to.records[place] = grid.record(sphere, number);
        if (has_widths_) {
          kernels::write_size(to, place, grid.size_of(spheres.boxes(), number));
        } else if (has_radii_) {
          to.radii[place] = grid.units_of(sphere.radius);
        }
        if (!has_spheres_) continue;
        base::fetch_next_line(spheres_.data() + place);
        spheres_[place] = given;
      }
    });
  }
}

template class LayerRecords<2>;
template class LayerRecords<3>;

}  // namespace abut::engine
