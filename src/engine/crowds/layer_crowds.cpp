#include "engine/crowds/layer_crowds.hpp"

#include "base/asking_workers.hpp"

#include <algorithm>
#include <span>

namespace abut::engine {

template <int Dim>
LayerCrowds<Dim>::CrowdScratch::CrowdScratch(base::MemoryMeter& memory)
    : counts(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      records(base::make_array_for_overwrite<kernels::PositionRecord>(memory, 0)),
      radii(base::make_array_for_overwrite<float>(memory, 0)),
      widths(base::make_array_for_overwrite<std::array<float, Dim>>(memory, 0)) {}

template <int Dim>
LayerCrowds<Dim>::LayerCrowds(base::MemoryMeter& memory)
    : memory_(memory),
      columns_(base::make_array_for_overwrite<CrowdedColumns>(memory, 0)),
      layers_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim>
void LayerCrowds<Dim>::find(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                            const LayerLimits& limits, std::size_t workers,
                            base::WorkCounter& work) {
  const std::size_t layers = grid.layer_count();
  while (scratch_.size() < workers) scratch_.emplace_back(memory_);
  columns_.assign(layers, {});
  layers_.clear();
  elements_ = 0;
  most_crowded_ = 0;
  largest_rest_ = 0;
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers, layers);
    for (std::size_t k = first; k < last; ++k) {
      const auto its = records.layer(k).records;
      its_work.did(1);
      if (its.size() < limits.least_in_crowd) continue;
      columns_[k] = find_in(grid, its, limits, scratch_[worker], its_work);
    }
  });
  for (std::size_t k = 0; k < layers; ++k) {
    const std::size_t crowd = columns_[k].crowd;
    const std::size_t all = records.layer(k).records.size();
    elements_ += all;
    if (crowd > 0) layers_.push_back(static_cast<std::uint32_t>(k));
    if (crowd > columns_[most_crowded_].crowd) most_crowded_ = k;
    largest_rest_ = std::max(largest_rest_, all - crowd);
  }
}

/// Counts the elements of each column, which then tell how many a run has.
template <int Dim>
CrowdedColumns LayerCrowds<Dim>::find_in(const LayerGrid<Dim>& grid,
                                         std::span<const kernels::PositionRecord> records,
                                         const LayerLimits& limits, CrowdScratch& scratch,
                                         base::WorkCounter& work) const {
  const std::size_t columns = grid.column_count();
  const std::size_t row_length = columns + 1;
  const std::size_t cells = grid.row_count() * row_length;
  base::make_room(scratch.counts, cells);
  std::fill_n(scratch.counts.begin(), cells, std::uint32_t{0});
  work.did(cells);
  const auto for_each_record = [&](const auto& visit) {
    work.in_pieces(0, records.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) visit(records[r]);
    });
  };
  for_each_record([&](const kernels::PositionRecord& record) {
    ++scratch.counts[grid.row(record) * row_length + grid.column(record) + 1];
  });
  CrowdedColumns crowded;
  std::size_t in_crowded = 0;
  const std::size_t reach = grid.columns_in_reach();
  for (std::uint32_t row = 0; row < grid.row_count(); ++row) {
    std::uint32_t* const before = scratch.counts.data() + row * row_length;
    for (std::size_t column = 0; column < columns; ++column) before[column + 1] += before[column];
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t own = before[column + 1] - before[column];
      const std::uint32_t in_run = before[std::min(column + reach + 1, columns)] -
                                   before[column < reach ? 0 : column - reach];
      if (own == 0 || in_run < limits.least_in_run_of_crowd) continue;
      crowded.include(row, column);
      in_crowded += own;
    }
  }
  if (in_crowded < limits.least_in_crowd) return {};
  for_each_record([&](const kernels::PositionRecord& record) {
    if (crowded.hold(grid, record)) ++crowded.crowd;
  });
  return crowded;
}

template <int Dim>
LayerElements<Dim> LayerCrowds<Dim>::rest(const LayerGrid<Dim>& grid,
                                          const LayerRecords<Dim>& records, std::size_t k,
                                          std::size_t worker, base::WorkCounter& work) {
  LayerElements<Dim> layer = records.layer(k);
  layer.spheres = {};
  if (columns_[k].crowd == 0) return layer;
  CrowdScratch& scratch = scratch_[worker];
  const std::size_t most = layer.records.size() - columns_[k].crowd;
  base::make_room(scratch.records, most);
  if (!layer.radii.empty()) base::make_room(scratch.radii, most);
  if (!layer.widths.empty()) base::make_room(scratch.widths, most);
  std::size_t size = 0;
  work.in_pieces(0, layer.records.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      if (columns_[k].hold(grid, layer.records[r])) continue;
      scratch.records[size] = layer.records[r];
      if (!layer.radii.empty()) scratch.radii[size] = layer.radii[r];
      if (!layer.widths.empty()) scratch.widths[size] = layer.widths[r];
      ++size;
    }
  });
  layer.records = std::span(scratch.records).first(size);
  if (!layer.radii.empty()) layer.radii = std::span(scratch.radii).first(size);
  if (!layer.widths.empty()) layer.widths = std::span(scratch.widths).first(size);
  return layer;
}

template class LayerCrowds<2>;
template class LayerCrowds<3>;

}  // namespace abut::engine
