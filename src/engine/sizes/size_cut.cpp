#include "engine/sizes/size_cut.hpp"

#include "exact/numbers/cube_root.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace abut::engine {
namespace {

/// Costs in units of a candidate test: to bring an element into cells, an element into the search
/// sets of a division, a coarse element into a tile, and a coarse element to a row of cells.
constexpr double cost_of_element = 120.0;
constexpr double cost_of_division = 60.0;
constexpr double cost_of_cross_level = 250.0;
constexpr double cost_of_row = 15.0;

/// The same in layers: what they cost of what tiles do, to look whether an element is coarse, and
/// two coarse elements to each other. The square of the number of coarse elements is no larger than
/// that of all.
constexpr double part_in_layers = 0.55;
constexpr double cost_of_look = 10.0;
constexpr double cost_of_coarse_pair = 5.0;

/// A cut must promise more than the error of the estimate.
constexpr double least_gain = 0.8;

template <int Dim>
constexpr double power(double x) {
  return Dim == 2 ? x * x : x * x * x;
}

/// Half of the 27 (9) cells that an element meets.
template <int Dim>
constexpr double half_stencil = Dim == 2 ? 4.5 : 13.5;

template <int Dim>
class Estimate {
 public:
  Estimate(const SizeClasses& classes, double margin, double volume)
      : classes_(classes), margin_(margin), volume_(volume) {
    for (std::size_t k = 0; k < classes.size(); ++k) {
      count_below_[k + 1] = count_below_[k] + classes[k].count;
    }
  }

  /// Elements of the classes [first, last) in cells of one size.
  [[nodiscard]] double alone(std::size_t first, std::size_t last) const {
    const double count = count_of(first, last);
    return count * (cost_of_element + half_stencil<Dim> * in_cell(first, last));
  }

  /// The same that share a cell.
  [[nodiscard]] double in_cell(std::size_t first, std::size_t last) const {
    const double count = count_of(first, last);
    const double cell = 2.0 * classes_[last - 1].radius + margin_;
    return std::min(count * power<Dim>(cell) / volume_, count);
  }

  /// Elements from class `cut` on visit those below it.
  [[nodiscard]] double cross_level(std::size_t cut) const {
    const double small_count = count_of(0, cut);
    const double small_radius = classes_[cut - 1].radius;
    const double cell =
        std::max(2.0 * small_radius + margin_, exact::root<Dim>(volume_ / small_count));
    const double cells_along_axis = exact::root<Dim>(small_count);
    double sum = 0.0;
    for (std::size_t k = cut; k < classes_.size(); ++k) {
      const double reached = 2.0 * (classes_[k].radius + small_radius + margin_);
      const double wide = std::min(reached / cell, cells_along_axis) + 1.0;
      const double rows = Dim == 2 ? wide : wide * wide;
      const double tests = std::min(small_count * power<Dim>(reached) / volume_, small_count);
      sum += classes_[k].count * (cost_of_cross_level + cost_of_row * rows + tests);
    }
    return sum;
  }

  [[nodiscard]] std::size_t size() const { return classes_.size(); }
  [[nodiscard]] double count() const { return count_of(0, size()); }
  [[nodiscard]] double count_above(std::size_t cut) const { return count_of(cut, size()); }
  [[nodiscard]] double cut_above(std::size_t k) const { return classes_[k].cut; }

 private:
  [[nodiscard]] double count_of(std::size_t first, std::size_t last) const {
    return count_below_[last] - count_below_[first];
  }

  const SizeClasses& classes_;
  double margin_;
  double volume_;
  std::array<double, SizeClasses::most + 2> count_below_{};  ///< of elements in smaller classes
};

}  // namespace

template <int Dim>
SizePlan plan_sizes(const SizeClasses& classes, const SizeDistribution& sizes) {
  const Estimate<Dim> estimate(classes, sizes.margin / sizes.reach(), sizes.volume);
  const double division = cost_of_division * estimate.count();
  SizePlan plan{std::nullopt, estimate.alone(0, estimate.size())};
  double least = least_gain * plan.cost;
  for (std::size_t k = 1; k < estimate.size(); ++k) {
    const double cost = division + estimate.alone(0, k) + estimate.cross_level(k) +
                        estimate.alone(k, estimate.size());
    if (cost >= least) continue;
    least = cost;
    plan = {estimate.cut_above(k - 1), cost};
  }
  return plan;
}

template <int Dim>
SizePlan plan_coarse(const SizeClasses& classes, const SizeDistribution& sizes,
                     double most_in_cell) {
  const Estimate<Dim> estimate(classes, sizes.margin / sizes.reach(), sizes.volume);
  const double count = estimate.count();
  SizePlan plan{std::nullopt, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 1; k < estimate.size(); ++k) {
    const double coarse = estimate.count_above(k);
    if (coarse * coarse > count || estimate.in_cell(0, k) > most_in_cell) continue;
    const double cost = cost_of_look * count + part_in_layers * estimate.alone(0, k) +
                        estimate.cross_level(k) + cost_of_coarse_pair * coarse * coarse / 2.0;
    if (cost >= plan.cost) continue;
    plan.cut = estimate.cut_above(k - 1);
    plan.cost = cost;
  }
  return plan;
}

template SizePlan plan_sizes<2>(const SizeClasses&, const SizeDistribution&);
template SizePlan plan_sizes<3>(const SizeClasses&, const SizeDistribution&);
template SizePlan plan_coarse<2>(const SizeClasses&, const SizeDistribution&, double);
template SizePlan plan_coarse<3>(const SizeClasses&, const SizeDistribution&, double);

}  // namespace abut::engine
