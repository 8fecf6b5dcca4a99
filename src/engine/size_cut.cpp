#include "engine/size_cut.hpp"

#include "exact/numbers/cube_root.hpp"

#include <algorithm>
#include <array>

namespace abut::engine {
namespace {

/// Costs in units of a candidate test: to bring an element into cells, an element into the search
/// sets of a division, a coarse element into a tile, and a coarse element to a row of cells.
constexpr double cost_of_element = 120.0;
constexpr double cost_of_division = 60.0;
constexpr double cost_of_cross_level = 250.0;
constexpr double cost_of_row = 15.0;

/// A cut must promise more than the error of the estimate.
constexpr double least_gain = 0.8;

/// Lengths in cells of the largest reach.
struct SizeClass {
  double count;
  double radius;  ///< upper end
  double cut;     ///< the same as it was given
};

constexpr std::size_t most_classes = 129;

/// A short array that needs no memory of its own.
class SizeClasses {
 public:
  void push_back(const SizeClass& one) { classes_[size_++] = one; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const SizeClass& operator[](std::size_t k) const { return classes_[k]; }

 private:
  std::array<SizeClass, most_classes> classes_;
  std::size_t size_ = 0;
};

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
      : classes_(classes), margin_(margin), volume_(volume) {}

  /// Elements of the classes [first, last) in cells of one size.
  [[nodiscard]] double alone(std::size_t first, std::size_t last) const {
    const double count = count_of(first, last);
    const double cell = 2.0 * classes_[last - 1].radius + margin_;
    const double in_cell = std::min(count * power<Dim>(cell) / volume_, count);
    return count * (cost_of_element + half_stencil<Dim> * in_cell);
  }

  /// Elements from class `cut` on visit those below it.
  [[nodiscard]] double cross_level(std::size_t cut) const {
    const double small_count = count_of(0, cut);
    const double small_radius = classes_[cut - 1].radius;
    const double cell =
        std::max(2.0 * small_radius + margin_, exact::root<Dim>(volume_ / small_count));
    double sum = 0.0;
    for (std::size_t k = cut; k < classes_.size(); ++k) {
      const double reached = 2.0 * (classes_[k].radius + small_radius + margin_);
      const double wide = std::min(reached / cell, exact::root<Dim>(small_count)) + 1.0;
      const double rows = Dim == 2 ? wide : wide * wide;
      const double tests = std::min(small_count * power<Dim>(reached) / volume_, small_count);
      sum += classes_[k].count * (cost_of_cross_level + cost_of_row * rows + tests);
    }
    return sum;
  }

  [[nodiscard]] std::size_t size() const { return classes_.size(); }
  [[nodiscard]] double count() const { return count_of(0, size()); }
  [[nodiscard]] double cut_above(std::size_t k) const { return classes_[k].cut; }

 private:
  [[nodiscard]] double count_of(std::size_t first, std::size_t last) const {
    double sum = 0.0;
    for (std::size_t k = first; k < last; ++k) sum += classes_[k].count;
    return sum;
  }

  SizeClasses classes_;
  double margin_;
  double volume_;
};

SizeClasses occupied_classes(const RadiusHistogram& histogram, const SizeDistribution& sizes,
                             double cell) {
  constexpr std::size_t most = most_classes - 1;
  const std::size_t first = RadiusHistogram::class_of(sizes.smallest_radius);
  const std::size_t last = RadiusHistogram::class_of(sizes.largest_radius);
  const std::size_t width = (last - first) / most + 1;
  SizeClasses classes;
  for (std::size_t k = first; k <= last; k += width) {
    double count = 0.0;
    for (std::size_t j = k; j < k + width && j <= last; ++j) count += histogram.count(j);
    if (count == 0.0) continue;
    const std::size_t end = std::min(k + width - 1, last);
    const double upper_end = RadiusHistogram::upper_end(end);
    classes.push_back({count, std::min(upper_end, sizes.largest_radius) / cell, upper_end});
  }
  return classes;
}

}  // namespace

template <int Dim>
std::optional<double> choose_size_cut(const RadiusHistogram& histogram,
                                      const SizeDistribution& sizes) {
  const double cell = 2.0 * sizes.largest_radius + sizes.margin;
  const Estimate<Dim> estimate(occupied_classes(histogram, sizes, cell), sizes.margin / cell,
                               sizes.volume);
  const double division = cost_of_division * estimate.count();
  double least = least_gain * estimate.alone(0, estimate.size());
  std::optional<double> cut;
  for (std::size_t k = 1; k < estimate.size(); ++k) {
    const double cost = division + estimate.alone(0, k) + estimate.cross_level(k) +
                        estimate.alone(k, estimate.size());
    if (cost >= least) continue;
    least = cost;
    cut = estimate.cut_above(k - 1);
  }
  return cut;
}

template std::optional<double> choose_size_cut<2>(const RadiusHistogram&, const SizeDistribution&);
template std::optional<double> choose_size_cut<3>(const RadiusHistogram&, const SizeDistribution&);

}  // namespace abut::engine
