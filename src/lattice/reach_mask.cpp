#include "lattice/reach_mask.hpp"

#include "grid/scaling.hpp"

#include <cmath>
#include <limits>

namespace abut::lattice {
namespace {

/// Reciprocals of smaller ones would not be finite.
constexpr double smallest_side = 0x1p-900;

/// 2 MiB stay in the second cache.
constexpr double most_bits = 0x1p24;

/// Cells of half the reach: what they cover is about four reaches wide where a ball of two is
/// meant.
constexpr double reaches_of_cell = 0.5;

double rounded_up(double value) noexcept {
  return std::nextafter(value, std::numeric_limits<double>::infinity());
}

double rounded_down(double value) noexcept {
  return std::nextafter(value, -std::numeric_limits<double>::infinity());
}

}  // namespace

template <int Dim>
double ReachMask<Dim>::reach_of(double radius) const noexcept {
  return rounded_up(rounded_up(radius + others_radius_) + margin_);
}

template <int Dim>
void ReachMask<Dim>::cover_box(const grid::Bounds<Dim>& bounds, double others_radius,
                               double margin) noexcept {
  others_radius_ = others_radius;
  margin_ = margin;
  has_cells_ = false;
  // Sums of larger numbers might overflow; such elements are covered by all of space.
  const double largest = std::max(grid::largest_number(bounds, margin), others_radius);
  in_range_ = largest <= grid::largest_unscaled;
  largest_reach_ = in_range_ ? reach_of(bounds.largest_radius) : 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    lower_[axis] = in_range_ ? rounded_down(bounds.lower[axis] - largest_reach_) : -everywhere;
    upper_[axis] = in_range_ ? rounded_up(bounds.upper[axis] + largest_reach_) : everywhere;
  }
}

/// Sides of cells; false where there is no use in any.
template <int Dim>
bool ReachMask<Dim>::divide() noexcept {
  double extents[Dim];
  for (std::size_t axis = 0; axis < Dim; ++axis) extents[axis] = upper_[axis] - lower_[axis];
  const double longest = *std::max_element(extents, extents + Dim);
  double side = std::max({largest_reach_ * reaches_of_cell, longest * 0x1p-23, smallest_side});
  const auto bits = [&] {
    double product = 64.0 * (std::floor(extents[0] / side / 64.0) + 1.0);
    for (std::size_t axis = 1; axis < Dim; ++axis)
      product *= std::floor(extents[axis] / side) + 1.0;
    return product;
  };
  while (bits() > most_bits) side *= 1.25;
  std::size_t cells = 1;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    counts_[axis] = static_cast<std::size_t>(extents[axis] / side) + 1;
    per_length_[axis] = 1.0 / side;
    last_cell_[axis] = static_cast<double>(counts_[axis] - 1);
    cells *= counts_[axis];
  }
  words_of_row_ = (counts_[0] + 63) / 64;
  return cells > 1;
}

template <int Dim>
void ReachMask<Dim>::cover_cells(std::span<const exact::Sphere<Dim>> spheres) {
  if (!in_range_ || !divide()) return;
  std::size_t words = words_of_row_;
  for (std::size_t axis = 1; axis < Dim; ++axis) words *= counts_[axis];
  base::make_room(bits_, words);
  std::fill_n(bits_.begin(), words, std::uint64_t{0});
  for (const exact::Sphere<Dim>& sphere : spheres) cover(sphere);
  has_cells_ = true;
}

template <int Dim>
void ReachMask<Dim>::cover(const exact::Sphere<Dim>& sphere) noexcept {
  const double reach = reach_of(sphere.radius);
  std::size_t first[3] = {};
  std::size_t last[3] = {};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    first[axis] = cell(axis, rounded_down(sphere.center[axis] - reach));
    last[axis] = cell(axis, rounded_up(sphere.center[axis] + reach));
  }
  for (std::size_t z = first[2]; z <= last[2]; ++z) {
    for (std::size_t y = first[1]; y <= last[1]; ++y) {
      cover_row(z * counts_[1] + y, first[0], last[0]);
    }
  }
}

template <int Dim>
void ReachMask<Dim>::cover_row(std::size_t row, std::size_t first, std::size_t last) noexcept {
  std::uint64_t* const words = bits_.data() + row * words_of_row_;
  const std::uint64_t from_first = ~std::uint64_t{0} << (first % 64);
  const std::uint64_t to_last = ~std::uint64_t{0} >> (63 - last % 64);
  if (first / 64 == last / 64) {
    words[first / 64] |= from_first & to_last;
    return;
  }
  words[first / 64] |= from_first;
  for (std::size_t w = first / 64 + 1; w < last / 64; ++w) words[w] = ~std::uint64_t{0};
  words[last / 64] |= to_last;
}

template class ReachMask<2>;
template class ReachMask<3>;

}  // namespace abut::lattice
