#include "engine/layers/layer_search.hpp"

#include "engine/memory_law.hpp"

#include "base/asking_workers.hpp"
#include "engine/layers/coarse_in_layers.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace abut::engine {
namespace {

/// Several workers take stretches of layers. The first layer of each stretch but one is sorted
/// twice, so that short ones do not pay; but the last ones must be short, or one worker is done
/// long before another. Where each worker has few layers, all are in one stretch.
constexpr std::size_t few_layers_for_each = 12;
constexpr std::size_t shortest_stretch = 3;

/// The integers of an element that the law of memory leaves for sorted layers, beside its record.
constexpr std::size_t integers_of_sorted = 24;

/// Spheres that are sorted along take no more than one of so many parts of what memory is left.
constexpr std::uint64_t parts_of_memory = 8;

/// Coarse elements whose layers take as long to find as a thread takes to wake.
constexpr std::size_t coarse_worth_a_worker = 256;

/// Tells whether most spheres lie in the layer of the next one: of some spread over all. A single
/// sphere does.
template <int Dim>
bool are_along_space(const LayerSpheres<Dim>& spheres, const LayerGrid<Dim>& grid) {
  constexpr std::size_t samples = 64;
  if (spheres.size() < 2) return true;
  const auto layer = [&](std::size_t k) { return grid.layer(spheres[spheres.in_layers(k)]); };
  std::size_t in_one_layer = 0;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    const std::size_t k = sample * (spheres.size() - 1) / samples;
    if (layer(k) == layer(k + 1)) ++in_one_layer;
  }
  return 2 * in_one_layer > samples;
}

/// The stretches one after the other: each is two thirds of a worker's share of the layers left.
class Stretches {
 public:
  Stretches(std::size_t layers, std::size_t workers) : layers_(layers), workers_(workers) {}

  [[nodiscard]] std::size_t count() const noexcept {
    std::size_t stretches = 0;
    for (std::size_t end = 0; end < layers_; end += length_from(end)) ++stretches;
    return stretches;
  }
  [[nodiscard]] std::size_t begin(std::size_t stretch) const noexcept {
    std::size_t layer = 0;
    for (std::size_t k = 0; k < stretch; ++k) layer += length_from(layer);
    return layer;
  }

 private:
  [[nodiscard]] std::size_t length_from(std::size_t layer) const noexcept {
    if (workers_ == 1) return layers_;
    const std::size_t left = layers_ - layer;
    const bool are_few = layers_ < few_layers_for_each * workers_;
    const std::size_t share = are_few ? (layers_ + workers_ - 1) / workers_
                                      : std::max(2 * left / (3 * workers_), shortest_stretch);
    return std::min(left, share);
  }

  std::size_t layers_;
  std::size_t workers_;
};

}  // namespace

template <int Dim>
std::uint64_t LayerSearch<Dim>::search(const SearchSet<Dim>& set, const LayerGrid<Dim>& grid,
                                       std::uint64_t unit, CoarsePairs coarse_pairs) {
  LayerRecords<Dim>& records = workspace_.layer_records;
  base::WorkCounter& work = workspace_.workers[0]->work();
  const LayerSpheres<Dim> spheres = input_.spheres.first(set.locals.size());
  records.sort(spheres, grid, what_to_sort(spheres, grid), input_.layer_kernels, worker_count_,
               work, workspace_.far_spheres);
  if (crowds_ != nullptr) unit = crowds_->search(grid, records, unit);
  if (has_coarse()) {
    sort_coarse(grid);
    if (coarse_pairs == CoarsePairs::searched) unit = search_coarse_pairs(grid, unit);
  }
  const std::size_t workers = workers_for(grid, set.locals.size());
  const Stretches stretches(grid.layer_count(), workers);
  const std::size_t count = stretches.count();
  input_.sink.expect_units(unit, count);
  base::for_each_index(workers, count, work,
                       [&](std::size_t w, std::size_t stretch, base::WorkCounter& its_work) {
                         const std::size_t first = stretches.begin(stretch);
                         const std::size_t last = stretches.begin(stretch + 1);
                         SearchWorker<Dim>& worker = *workspace_.workers[w];
                         worker.begin_unit(unit + stretch);
                         if (grid.is_by_size()) {
                           search_stretch_by_size(grid, first, last, worker, its_work);
                         } else {
                           search_stretch(grid, first, last, worker, its_work);
                         }
                         if (worker_count_ > 1) worker.finish_unit();
                       });
  if (!input_.part.is_part()) {
    workspace_.had_many_undecided = 2 * layers_with_many_undecided_ > grid.layer_count();
  }
  context_.progress.poll();
  return unit + count;
}

/// Spheres are sorted along where the last search had to decide on most, or crowds are copied, and
/// where those that are neighbors in memory are none in space, nor in a cache: else a layer's are
/// copied in less time when it is sorted. What a later call takes more than the first one is a
/// small part of the memory that is left.
template <int Dim>
LayerItems LayerSearch<Dim>::what_to_sort(const LayerSpheres<Dim>& spheres,
                                          const LayerGrid<Dim>& grid) const {
  const bool decides_on_spheres =
      input_.deciding_spheres() != nullptr && !grid.is_by_size() && !grid.is_exact();
  const LayerLimits& limits = input_.layer_limits;
  const bool are_copied = crowds_ != nullptr && !input_.part.is_part() &&
                          !spheres.stand_for_boxes() &&
                          spheres.size() >= limits.least_elements_copied_along;
  const bool are_read = decides_on_spheres && workspace_.had_many_undecided &&
                        spheres.size() >= limits.least_elements_with_spheres;
  const bool pays = (are_read || are_copied) && !are_along_space(spheres, grid);
  const base::MemoryMeter& memory = context_.memory;
  const std::uint64_t left = memory.bound() - std::min(memory.bound(), memory.held());
  const std::uint64_t bytes = workspace_.layer_records.bytes_for_spheres(spheres.size());
  return pays && bytes <= left / parts_of_memory ? LayerItems::records_and_spheres
                                                 : LayerItems::records;
}

/// The workers that have room for their layers, each for two or three of the largest, and for the
/// far elements in their reach: fewer than there are only where one layer holds much of all, or
/// meets it.
template <int Dim>
std::size_t LayerSearch<Dim>::workers_for(const LayerGrid<Dim>& grid, std::size_t elements) const {
  constexpr std::size_t integers_of_cursor = sizeof(std::uint64_t) / sizeof(std::uint32_t);
  std::size_t integers =
      integers_of_cursor * grid.layer_count() +
      workspace_.workers[0]->scratch().layers.integers_for(grid, largest_layer());
  if (grid.is_by_size() || has_coarse()) {
    constexpr std::size_t integers_of_far = sizeof(kernels::FarSphere) / sizeof(std::uint32_t);
    integers += workspace_.far_spheres.most_in_reach() * integers_of_far;
  }
  if (integers <= integers_of_worker) return worker_count_;
  const std::size_t room = integers_of_sorted * elements;
  return std::clamp(room / (integers - integers_of_worker), std::size_t{1}, worker_count_);
}

/// Sorts the coarse elements by the layers in which they look.
template <int Dim>
void LayerSearch<Dim>::sort_coarse(const LayerGrid<Dim>& grid) {
  base::WorkCounter& work = workspace_.workers[0]->work();
  const CoarseElements<Dim>& coarse = workspace_.coarse;
  const std::size_t count = coarse.numbers().size();
  const std::size_t workers = base::workers_worth(count, coarse_worth_a_worker, worker_count_);
  workspace_.far_spheres.start(workers);
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers, count);
    workspace_.far_spheres.expect_coarse(last - first, worker);
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto element = coarse_in_layers(grid, coarse.elements(), k, coarse.numbers()[k]);
        if (element) workspace_.far_spheres.note_coarse(*element, worker);
      }
    });
  });
  workspace_.far_spheres.sort(grid, work);
}

/// Finds the pairs of two coarse elements, which are a unit of their own. Returns the next one.
template <int Dim>
std::uint64_t LayerSearch<Dim>::search_coarse_pairs(const LayerGrid<Dim>& grid,
                                                    std::uint64_t unit) {
  const CoarseElements<Dim>& coarse = workspace_.coarse;
  SearchWorker<Dim>& worker = *workspace_.workers[0];
  input_.sink.expect_units(unit, 1);
  worker.begin_unit(unit);
  const double wider = input_.margin + position_slack * grid.cell();
  for (std::size_t k = 0; k < coarse.numbers().size(); ++k) {
    worker.work().did(coarse.numbers().size() - k);
    coarse.for_each_partner(
        k, wider, [&](std::uint32_t number) { worker.test_pair(coarse.numbers()[k], number); });
  }
  if (worker_count_ > 1) worker.finish_unit();
  return unit + 1;
}

/// What is searched of layer k; nothing behind the last one.
template <int Dim>
LayerElements<Dim> LayerSearch<Dim>::elements_of(const LayerGrid<Dim>& grid, std::size_t k,
                                                 SearchWorker<Dim>& worker) const {
  const LayerRecords<Dim>& records = workspace_.layer_records;
  if (k >= grid.layer_count()) return {};
  return crowds_ != nullptr ? crowds_->rest(grid, records, k, worker) : records.layer(k);
}

/// The most elements of a layer that are searched.
template <int Dim>
std::size_t LayerSearch<Dim>::largest_layer() const {
  return crowds_ != nullptr ? crowds_->largest_rest() : workspace_.layer_records.largest_layer();
}

template <int Dim>
void LayerSearch<Dim>::search_stretch(const LayerGrid<Dim>& grid, std::size_t first,
                                      std::size_t last, SearchWorker<Dim>& worker,
                                      base::WorkCounter& work) {
  const LayerRecords<Dim>& records = workspace_.layer_records;
  SortedLayers<Dim>& sorted = worker.scratch().layers;
  FarSpheresInReach<Dim>& coarse = worker.scratch().far;
  sorted.start(grid, largest_layer());
  if (has_coarse()) coarse.start(workspace_.far_spheres, first);
  const kernels::StridedSpheres* const spheres = input_.deciding_spheres();
  const auto sort = [&](std::size_t k) {
    // Where most pairs are decided by the spheres themselves, these are sorted along.
    const bool with_spheres =
        (records.has_spheres() && crowds_ == nullptr) || worker.has_many_undecided();
    const LayerElements<Dim> elements = elements_of(grid, k, worker);
    sorted.sort(grid, k, elements, with_spheres ? spheres : nullptr, input_.layer_kernels, work);
    return elements.records.size();
  };
  std::size_t next_size = sort(first);
  for (std::size_t k = first; k < last; ++k) {
    const std::size_t size = std::exchange(next_size, sort(k + 1));
    worker.search(sorted.pair(grid, k));
    if (worker.has_many_undecided()) ++layers_with_many_undecided_;
    if (has_coarse()) {
      if (k > first) coarse.advance(workspace_.far_spheres, k);
      work.did(coarse.elements().size());
      worker.search_coarse(sorted.layer_alone(grid, k), coarse.elements());
    }
    context_.progress.advance(size);
  }
}

template <int Dim>
void LayerSearch<Dim>::search_stretch_by_size(const LayerGrid<Dim>& grid, std::size_t first,
                                              std::size_t last, SearchWorker<Dim>& worker,
                                              base::WorkCounter& work) {
  const LayerRecords<Dim>& records = workspace_.layer_records;
  SortedLayers<Dim>& sorted = worker.scratch().layers;
  FarSpheresInReach<Dim>& far = worker.scratch().far;
  sorted.start(grid, records.largest_layer());
  const auto sort = [&](std::size_t k, const LayerElements<Dim>& elements) {
    sorted.sort(grid, k, elements, nullptr, input_.layer_kernels, work);
  };
  const auto sort_layer = [&](std::size_t k) {
    sort(k, k < grid.layer_count() ? records.layer(k) : LayerElements<Dim>{});
  };
  if (first == 0) {
    sort(sorted.before(0), {});
  } else {
    sort_layer(first - 1);
  }
  sort_layer(first);
  far.start(workspace_.far_spheres, first);
  for (std::size_t k = first; k < last; ++k) {
    sort_layer(k + 1);
    if (k > first) far.advance(workspace_.far_spheres, k);
    work.did(far.elements().size());
    worker.search(sorted.three_layers(grid, k), far.elements());
    context_.progress.advance(records.layer(k).records.size());
  }
}

template class LayerSearch<2>;
template class LayerSearch<3>;

}  // namespace abut::engine
