#include "device/levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace abut::device {
namespace {

// Costs in units of a candidate test, for a coarse element that meets a level, and a row that it
// looks at. Estimates: no device has been measured yet.
constexpr double cost_of_coarse = 40.0;
constexpr double cost_of_row = 12.0;
constexpr double cost_of_level = 1000.0;

/// Some elements of nearly one size. Lengths in cells of the largest reach.
struct SizeGroup {
  double count;
  double radius;  ///< upper end
  double end;     ///< the same as it was given
};

template <int Dim>
double power(double x) {
  return Dim == 2 ? x * x : x * x * x;
}

template <int Dim>
class LevelCosts {
 public:
  LevelCosts(std::vector<SizeGroup> groups, double margin, double volume)
      : groups_(std::move(groups)), margin_(margin), volume_(volume) {}

  /// One level of the groups [first, last), the smallest of all being number 0.
  [[nodiscard]] double of_level(std::size_t first, std::size_t last) const {
    double count = 0.0;
    for (std::size_t k = first; k < last; ++k) count += groups_[k].count;
    const double largest = groups_[last - 1].radius;
    const double cell = 2.0 * largest + margin_;
    constexpr double half_stencil = Dim == 2 ? 4.5 : 13.5;
    double cost = cost_of_level + count * half_stencil * within(count, cell);
    for (std::size_t k = last; k < groups_.size(); ++k) {
      cost += groups_[k].count * of_coarse(groups_[k].radius + largest + margin_, cell, count);
    }
    return cost;
  }

  [[nodiscard]] const std::vector<SizeGroup>& groups() const { return groups_; }

 private:
  [[nodiscard]] double within(double count, double side) const {
    return std::min(count * power<Dim>(side) / volume_, count);
  }

  [[nodiscard]] double of_coarse(double reach, double cell, double count) const {
    const double wide = 2.0 * reach / cell + 1.0;
    const double rows = std::min(Dim == 2 ? wide : wide * wide, count);
    return cost_of_coarse + cost_of_row * rows + within(count, 2.0 * reach);
  }

  std::vector<SizeGroup> groups_;
  double margin_;
  double volume_;
};

/// The largest reach that there can be, and lengths in it.
class ReachUnit {
 public:
  ReachUnit(double largest_radius, double margin)
      : scale_(std::max(largest_radius, margin) > 1.0 ? 0.25 : 1.0),
        cell_(2.0 * (largest_radius * scale_) + margin * scale_) {}

  [[nodiscard]] double cells(double length) const { return length * scale_ / cell_; }

 private:
  double scale_;  ///< a quarter where twice the largest radius could overflow
  double cell_;
};

template <int Dim>
double volume_in_cells(const Extent<Dim>& extent, const ReachUnit& cell) {
  double volume = 1.0;
  for (int axis = 0; axis < Dim; ++axis) {
    volume *= std::max(cell.cells(extent.upper[axis]) - cell.cells(extent.lower[axis]), 1.0);
  }
  return volume;
}

/// Groups of ascending size; those of no element are left out.
std::vector<SizeGroup> groups_of(const SizeCounts& counts, double largest_radius,
                                 const ReachUnit& cell) {
  const std::uint32_t largest = half_octave_of(largest_radius);
  std::vector<SizeGroup> groups;
  for (std::uint32_t k = size_classes; k-- > 0;) {
    if (counts[k] == 0) continue;
    const double end = end_of_half_octave(largest - std::min(k, largest));
    const double radius = cell.cells(std::min(end, largest_radius));
    groups.push_back({static_cast<double>(counts[k]), radius, end});
  }
  return groups;
}

/// cost[l][k]: the least cost of the groups below k in l levels, and where the last of these
/// begins.
struct LevelChoice {
  explicit LevelChoice(std::size_t groups)
      : cost(most_levels + 1,
             std::vector<double>(groups + 1, std::numeric_limits<double>::infinity())),
        begin(most_levels + 1, std::vector<std::size_t>(groups + 1, 0)) {
    cost[0][0] = 0.0;
  }

  std::vector<std::vector<double>> cost;
  std::vector<std::vector<std::size_t>> begin;
};

template <int Dim>
LevelChoice best_cuts(const LevelCosts<Dim>& costs) {
  const std::size_t groups = costs.groups().size();
  LevelChoice best(groups);
  for (std::size_t first = 0; first < groups; ++first) {
    for (std::size_t last = first + 1; last <= groups; ++last) {
      const double cost = costs.of_level(first, last);
      for (std::size_t levels = 0; levels < most_levels; ++levels) {
        const double sum = best.cost[levels][first] + cost;
        if (!(sum < best.cost[levels + 1][last])) continue;
        best.cost[levels + 1][last] = sum;
        best.begin[levels + 1][last] = first;
      }
    }
  }
  return best;
}

}  // namespace

template <int Dim>
Levels choose_levels(const SizeCounts& counts, const Extent<Dim>& extent, double margin) {
  const ReachUnit cell(extent.largest_radius, margin);
  const LevelCosts<Dim> costs(groups_of(counts, extent.largest_radius, cell), cell.cells(margin),
                              volume_in_cells(extent, cell));
  const std::vector<SizeGroup>& groups = costs.groups();
  const LevelChoice best = best_cuts(costs);
  std::size_t levels = 1;
  for (std::size_t k = 2; k <= most_levels; ++k) {
    if (best.cost[k][groups.size()] < best.cost[levels][groups.size()]) levels = k;
  }
  Levels result;
  result.count = static_cast<std::uint32_t>(levels);
  std::size_t end = groups.size();
  for (std::size_t level = levels; level-- > 0;) {
    const std::size_t begin = best.begin[level + 1][end];
    const bool is_last = level + 1 == levels;
    result.ends[level] = is_last ? std::numeric_limits<double>::infinity() : groups[end - 1].end;
    for (std::size_t k = begin; k < end; ++k) {
      result.elements[level] += static_cast<std::uint64_t>(groups[k].count);
    }
    end = begin;
  }
  return result;
}

template Levels choose_levels(const SizeCounts&, const Extent<2>&, double);
template Levels choose_levels(const SizeCounts&, const Extent<3>&, double);

}  // namespace abut::device
