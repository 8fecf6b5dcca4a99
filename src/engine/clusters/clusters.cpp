#include "engine/clusters/clusters.hpp"

#include "base/asking_workers.hpp"
#include "engine/box_in_cells.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

/// So many elements for each coarse cell; and for each cell that holds some, on average, at least:
/// moving smaller clusters takes longer than to search them in wide cells.
constexpr double elements_of_cell = 8.0;
constexpr std::size_t least_elements_of_label = 64;
/// Labels of a few elements, at least: a small system may have strays.
constexpr std::size_t least_labels = 64;

/// Elements of a sample, to the root of the number of all, and for each label.
constexpr double sampled_for_root = 8.0;
constexpr std::size_t least_sampled_of_label = 4;

/// Cells of the size of the reach in the boxes of all clusters, for each element, at most.
constexpr double most_cells_of_element = 256.0;

/// A cluster with more of them is cut anew, if its box is so many times smaller than before.
constexpr double most_cells_of_cluster = 1000.0;
constexpr double least_shrinking = 8.0;
constexpr double least_cells_of_grid = 8.0;
constexpr std::size_t most_levels = 4;

/// The root of a label whose target is not known yet.
constexpr std::uint32_t none = ~std::uint32_t{0};

template <int Dim>
bool are_within(const grid::Bounds<Dim>& a, const grid::Bounds<Dim>& b, double reach) {
  bool are_near = true;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    are_near = are_near && a.lower[axis] - b.upper[axis] <= reach &&
               b.lower[axis] - a.upper[axis] <= reach;
  }
  return are_near;
}

template <int Dim>
bool holds(const grid::Bounds<Dim>& box, const exact::Sphere<Dim>& sphere) {
  std::uint32_t outside = 0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    outside |= static_cast<std::uint32_t>(sphere.center[axis] < box.lower[axis]);
    outside |= static_cast<std::uint32_t>(sphere.center[axis] > box.upper[axis]);
  }
  return outside == 0;
}

}  // namespace

template <int Dim>
Clusters<Dim>::Clusters(base::MemoryMeter& memory)
    : memory_(memory),
      cells_(memory),
      labels_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      joined_(labels_),
      targets_(base::make_array_for_overwrite<CellTarget>(memory, 0)),
      moves_(base::make_array_for_overwrite<ClusterMove<Dim>>(memory, 0)),
      grids_(base::MeteredAllocator<ClusterGrid<Dim>>(memory)),
      clusters_(base::make_array_for_overwrite<grid::Bounds<Dim>>(memory, 0)),
      sizes_(base::make_array_for_overwrite<std::array<double, Dim>>(memory, 0)),
      layout_(memory) {}

template <int Dim>
auto Clusters<Dim>::move(const kernels::SphereParts& spheres, const grid::Bounds<Dim>& bounds,
                         double reach, std::size_t workers, base::WorkCounter& work)
    -> std::optional<MovedSpheres> {
  reach_ = reach;
  elements_ = spheres.size();
  base::make_room(labels_, elements_);
  const auto sampled =
      static_cast<std::size_t>(sampled_for_root * std::sqrt(static_cast<double>(elements_)));
  const std::size_t step = elements_ / std::max(sampled, std::size_t{1});
  if (step > 1) {
    const ClusterSample sample{step, sampled / least_sampled_of_label + least_labels, 1};
    if (!find(spheres.every(step), bounds, sample, work) || !need_little_room()) {
      return std::nullopt;
    }
  }
  const ClusterSample all{1, elements_ / least_elements_of_label + least_labels, workers};
  if (!find(spheres, bounds, all, work) || !need_little_room()) return std::nullopt;
  const std::array<double, Dim> upper = lay_out(work);
  return MovedSpheres{LayerSpheres<Dim>(spheres, labels_.data(), moves_.data()), upper,
                      clusters_.size()};
}

/// Returns whether there are labels enough.
template <int Dim>
bool Clusters<Dim>::find(const kernels::SphereParts& spheres, const grid::Bounds<Dim>& bounds,
                         const ClusterSample& sample, base::WorkCounter& work) {
  start(sample);
  add_grid({bounds, spheres.size()});
  std::size_t first_grid = 0;
  for (std::size_t level = 0; first_grid < grids_.size(); ++level) {
    const std::size_t end = grids_.size();
    cells_.add_cells(grids_.back().end());
    label_cells(spheres, level, sample.workers, work);
    if (cells_.are_too_few()) return false;
    const Labels labels = cells_.in_order_of_cells(work);
    merge(labels, work);
    join_adjacent(labels, first_grid, work);
    settle(labels, first_grid, level, work);
    first_grid = end;
  }
  return true;
}

template <int Dim>
bool Clusters<Dim>::need_little_room() const noexcept {
  double cells = 0.0;
  for (const grid::Bounds<Dim>& cluster : clusters_)
    cells += BoxInCells<Dim>(cluster, reach_).cells;
  return cells <= most_cells_of_element * static_cast<double>(elements_);
}

template <int Dim>
void Clusters<Dim>::start(const ClusterSample& sample) {
  elements_of_one_ = static_cast<double>(sample.step);
  const std::size_t most_labels = sample.most_labels;
  cells_.start(most_labels);
  while (boxes_.size() < sample.workers) {
    boxes_.push_back(base::make_array_for_overwrite<LabelBox>(memory_, 0));
  }
  for (base::Array<LabelBox>& boxes : boxes_) {
    base::make_room(boxes, most_labels + 1);
    std::fill_n(boxes.begin(), most_labels + 1, LabelBox{});
  }
  base::make_room(joined_, most_labels + 1);
  base::make_room(targets_, most_labels + 1);
  std::fill_n(targets_.begin(), most_labels + 1, CellTarget{});
  base::make_room(moves_, most_labels + 1);
  grids_.clear();
  clusters_.clear();
}

template <int Dim>
void Clusters<Dim>::add_grid(const LabelBox& box) {
  const double elements = elements_of_one_ * static_cast<double>(box.elements);
  const double cells = std::max(elements / elements_of_cell, least_cells_of_grid);
  const std::uint32_t begin = grids_.empty() ? 0 : grids_.back().end();
  grids_.push_back(ClusterGrid<Dim>(box.bounds, reach_, cells, begin));
}

/// Labels the cells of the level's grids, and notes what each of them holds.
template <int Dim>
void Clusters<Dim>::label_cells(const kernels::SphereParts& spheres, std::size_t level,
                                std::size_t workers, base::WorkCounter& work) {
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      if (cells_.are_too_few()) return;
      for (const auto& some : spheres.some(begin, end)) label(some, level, boxes_[worker]);
    });
  });
}

template <int Dim>
void Clusters<Dim>::label(const kernels::SpheresOfPart& some, std::size_t level,
                          base::Array<LabelBox>& boxes) {
  // Copies, which no label that is written could change, stay in registers.
  const kernels::StridedSpheres columns = some.columns;
  const ClusterGrid<Dim> first_grid = grids_.front();
  std::uint32_t* const labels = labels_.data() + some.number_of_first;
  const auto note = [&, its = boxes.data()](std::size_t k, const ClusterGrid<Dim>& grid) {
    const auto sphere = kernels::sphere_at<Dim>(columns, k);
    const std::uint32_t label = cells_.label(grid.cell(sphere));
    labels[k] = label;
    LabelBox& box = its[label];
    // Few make the box wider, and writing to it each time would make the next one wait.
    if (!holds(box.bounds, sphere)) box.bounds.include_center(sphere);
    ++box.elements;
  };
  if (level == 0) {
    for (std::size_t k = some.begin; k < some.end; ++k) note(k, first_grid);
    return;
  }
  for (std::size_t k = some.begin; k < some.end; ++k) {
    const CellTarget target = targets_[labels[k]];
    if (target.is_grid) note(k, grids_[target.number]);
  }
}

/// Adds what all workers noted to what the first one did.
template <int Dim>
void Clusters<Dim>::merge(const Labels& labels, base::WorkCounter& work) {
  for (std::size_t worker = 1; worker < boxes_.size(); ++worker) {
    for (const std::uint32_t label : labels) boxes_[0][label].include(boxes_[worker][label]);
    work.did(labels.size());
  }
}

/// Joins adjacent cells of a grid whose elements may be within reach of each other.
template <int Dim>
void Clusters<Dim>::join_adjacent(const Labels& labels, std::size_t first_grid,
                                  base::WorkCounter& work) {
  for (const std::uint32_t label : labels) joined_[label] = label;
  std::size_t grid = first_grid;
  work.in_pieces(0, labels.size(), [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t label : labels.subspan(begin, end - begin)) {
      while (cells_.cell_of(label) >= grids_[grid].end()) ++grid;
      join_with_next(label, grids_[grid]);
    }
  });
  for (const std::uint32_t label : labels) {
    const std::uint32_t first = root(label);
    if (first != label) boxes_[0][first].include(boxes_[0][label]);
  }
  work.did(labels.size());
}

template <int Dim>
void Clusters<Dim>::join_with_next(std::uint32_t label, const ClusterGrid<Dim>& grid) {
  grid.for_each_next(cells_.cell_of(label), [&](std::uint32_t next_cell) {
    const std::uint32_t next = cells_.label_of(next_cell);
    if (next == 0) return;
    if (are_within(boxes_[0][label].bounds, boxes_[0][next].bounds, reach_)) {
      joined_[root(next)] = root(label);
    }
  });
}

template <int Dim>
std::uint32_t Clusters<Dim>::root(std::uint32_t label) noexcept {
  while (joined_[label] != label) {
    joined_[label] = joined_[joined_[label]];
    label = joined_[label];
  }
  return label;
}

/// Tells whether what was joined is cut anew: its box is mostly empty, and much smaller than that
/// of its grid, and all cells together are about as many as elements or less.
template <int Dim>
bool Clusters<Dim>::needs_grid(const LabelBox& box, const ClusterGrid<Dim>& grid,
                               std::size_t level) const noexcept {
  const double reaches = BoxInCells<Dim>(box.bounds, reach_).cells;
  const double elements = elements_of_one_ * static_cast<double>(box.elements);
  return level + 1 < most_levels && grids_.back().end() < elements_ &&
         reaches > most_cells_of_cluster * elements && least_shrinking * reaches < grid.reaches();
}

/// Makes clusters of the cells that were joined, in the order of their first cells, or grids.
template <int Dim>
void Clusters<Dim>::settle(const Labels& labels, std::size_t first_grid, std::size_t level,
                           base::WorkCounter& work) {
  for (const std::uint32_t label : labels) targets_[label] = {false, none};
  std::size_t grid = first_grid;
  for (const std::uint32_t label : labels) {
    while (cells_.cell_of(label) >= grids_[grid].end()) ++grid;
    const std::uint32_t first = root(label);
    CellTarget& target = targets_[first];
    if (target.number == none) {
      const LabelBox& box = boxes_[0][first];
      const bool is_grid = needs_grid(box, grids_[grid], level);
      target = {is_grid, static_cast<std::uint32_t>(is_grid ? grids_.size() : clusters_.size())};
      if (is_grid) {
        add_grid(box);
      } else {
        clusters_.push_back(box.bounds);
      }
    }
    targets_[label] = target;
  }
  work.did(labels.size());
}

/// Returns the upper corner of the box in which clusters are then.
template <int Dim>
std::array<double, Dim> Clusters<Dim>::lay_out(base::WorkCounter& work) {
  base::make_room(sizes_, clusters_.size());
  for (std::size_t k = 0; k < clusters_.size(); ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sizes_[k][axis] = clusters_[k].upper[axis] - clusters_[k].lower[axis];
    }
  }
  layout_.place(std::span(sizes_).first(clusters_.size()), reach_, work);
  set_moves(work);
  std::array<double, Dim> upper{};
  for (std::size_t k = 0; k < clusters_.size(); ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      upper[axis] = std::max(upper[axis], sizes_[k][axis] + layout_.corner(k)[axis]);
    }
  }
  return upper;
}

/// Tells the move of each label, but for those that elements have no more.
template <int Dim>
void Clusters<Dim>::set_moves(base::WorkCounter& work) {
  for (std::size_t label = 1; label <= cells_.given(); ++label) {
    const CellTarget target = targets_[label];
    if (target.is_grid) continue;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      moves_[label].from[axis] = clusters_[target.number].lower[axis];
      moves_[label].to[axis] = layout_.corner(target.number)[axis];
    }
  }
  work.did(cells_.given());
}

template class Clusters<2>;
template class Clusters<3>;

}  // namespace abut::engine
