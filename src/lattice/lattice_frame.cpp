#include "lattice/lattice_frame.hpp"

#include "lattice/rounding_factors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::lattice {
namespace {

constexpr double most_cells = 0x1p28;

template <int Dim>
double length_of(const double* vector) {
  double largest = 0.0;
  for (std::size_t k = 0; k < Dim; ++k) largest = std::max(largest, std::fabs(vector[k]));
  if (largest == 0.0 || std::isinf(largest)) return largest;
  double sum = 0.0;
  for (std::size_t k = 0; k < Dim; ++k) sum += (vector[k] / largest) * (vector[k] / largest);
  return std::sqrt(sum) * largest * up + std::numeric_limits<double>::denorm_min();
}

/// Upper bound of how far the vector of an axis has moved.
template <int Dim>
double moved(const exact::Lattice& then, const exact::Lattice& now, std::size_t axis) {
  if (!now.periodic[axis]) return 0.0;
  std::array<double, Dim> difference{};
  for (std::size_t k = 0; k < Dim; ++k) {
    difference[k] = now.vectors[axis][k] - then.vectors[axis][k];
  }
  return length_of<Dim>(difference.data());
}

}  // namespace

template <int Dim>
LatticeFrame<Dim>::LatticeFrame(const exact::Lattice& lattice)
    : lattice_(lattice), reduced_(lattice) {
  derive_dual();
}

/// x = sum of f_k b_k and b_k = sum of to_given[k][l] A_l: the dual of A_l sums over k.
template <int Dim>
void LatticeFrame<Dim>::derive_dual() {
  for (std::size_t l = 0; l < reduced_.count; ++l) {
    Vector& dual = dual_[reduced_.axis_of[l]];
    for (std::size_t k = 0; k < reduced_.count; ++k) {
      const auto number = static_cast<double>(reduced_.to_given[k][l]);
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        dual[axis] += number * (reduced_.dual[k][axis] * reduced_.scale);
      }
    }
    dual_length_[reduced_.axis_of[l]] = length_of<Dim>(dual.data());
  }
  // Verified rather than proven: the products with the given vectors are 1 and 0, but for little.
  double worst = 0.0;
  for (std::size_t l = 0; l < Dim; ++l) {
    if (!lattice_.periodic[l]) continue;
    double error = 0.0;
    for (std::size_t m = 0; m < Dim; ++m) {
      if (!lattice_.periodic[m]) continue;
      const double* const vector = lattice_.vectors[m].data();
      error += std::fabs(fraction(l, vector) - (l == m ? 1.0 : 0.0));
      error += 0x1p-49 * dual_length_[l] * length_of<Dim>(vector);
    }
    worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(worst, error);
  }
  accurate_ = worst < 0x1p-21;
}

template <int Dim>
bool LatticeFrame<Dim>::nearest(const double* difference, CellNumbers& numbers) const noexcept {
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < reduced_.count; ++k) {
    const double number = std::nearbyint(reduced_.fraction(k, difference));
    for (std::size_t l = 0; l < reduced_.count; ++l) {
      sum[reduced_.axis_of[l]] += number * static_cast<double>(reduced_.to_given[k][l]);
    }
  }
  numbers = {};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    if (!(std::fabs(sum[axis]) < most_cells)) return false;
    numbers[axis] = static_cast<std::int32_t>(sum[axis]);
  }
  return true;
}

template <int Dim>
bool LatticeFrame<Dim>::close_by(const grid::Bounds<Dim>& bounds, double reach) const noexcept {
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < reduced_.count; ++k) {
    double cells = reach * (reduced_.dual_length[k] * reduced_.scale);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double farthest =
          std::max(std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis]));
      cells += farthest * std::fabs(reduced_.dual[k][axis] * reduced_.scale);
    }
    if (!(cells < most_cells)) return false;
    for (std::size_t l = 0; l < reduced_.count; ++l) {
      sum[l] += (cells + 1.0) * std::fabs(static_cast<double>(reduced_.to_given[k][l]));
    }
  }
  return std::all_of(sum.begin(), sum.end(), [](double cells) { return cells < most_cells; });
}

template <int Dim>
double image_motion(const LatticeFrame<Dim>& then, const LatticeFrame<Dim>& now,
                    const typename LatticeFrame<Dim>::Vector& spread, double distance) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  // What the inaccuracy of fractions adds to the number along one axis, from all others.
  constexpr double cross = 0x1p-18;
  std::array<double, Dim> motion{};
  double motions = 0.0, spreads = 0.0, duals = 0.0;
  for (std::size_t k = 0; k < Dim; ++k) {
    motion[k] = moved<Dim>(then.lattice(), now.lattice(), k);
    motions += motion[k];
    spreads += spread[k];
    duals += then.dual_length(k);
  }
  if (motions == 0.0) return 0.0;
  if (!then.accurate()) return infinite;

  const auto own_spread = [&](std::size_t k) { return spread[k] + cross * spreads; };
  const auto own_dual = [&](std::size_t k) { return then.dual_length(k) + cross * duals; };
  double slope = 0.0, linear = 0.0;
  for (std::size_t k = 0; k < Dim; ++k) {
    slope += motion[k] * own_dual(k);
    linear += motion[k] * (own_spread(k) + own_dual(k) * distance);
  }
  if (!(slope <= 0.5)) return infinite;
  const double bound = linear / (1.0 - slope) * up;
  double total = 0.0;
  for (std::size_t k = 0; k < Dim; ++k) {
    const double number = own_spread(k) + own_dual(k) * (distance + bound);
    if (motion[k] > 0.0) total += std::floor(number * up) * motion[k];
  }
  return std::isnan(total) ? infinite : total * up;
}

template class LatticeFrame<2>;
template class LatticeFrame<3>;
template double image_motion(const LatticeFrame<2>&, const LatticeFrame<2>&,
                             const std::array<double, 2>&, double);
template double image_motion(const LatticeFrame<3>&, const LatticeFrame<3>&,
                             const std::array<double, 3>&, double);

}  // namespace abut::lattice
