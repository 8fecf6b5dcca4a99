#include "history/cell_jumps.hpp"

#include "elements/element_ids.hpp"
#include "elements/lattice_of.hpp"
#include "lattice/lattice_frame.hpp"

#include <algorithm>
#include <cstring>

namespace abut::history {
namespace {

template <class T>
double read(const ElementView::Numbers& numbers, std::size_t k) {
  T value;
  std::memcpy(&value, numbers.first + static_cast<std::ptrdiff_t>(k) * numbers.stride_bytes,
              sizeof value);
  return static_cast<double>(value);
}

/// Square of a distance within which the nearest lattice vector is 0.
template <int Dim>
double square_of_near(const lattice::LatticeFrame<Dim>& frame) {
  double largest = 0.0;
  for (std::size_t k = 0; k < Dim; ++k) largest = std::max(largest, frame.reduced_dual_length(k));
  const double near = 0.49 / largest;
  return near * near;
}

}  // namespace

template <int Dim, class T>
void CellJumps::find_in(const ElementView& elements, const Domain& domain,
                        std::span<const std::uint32_t> before) {
  const lattice::LatticeFrame<Dim> frame(elements::lattice_of(domain));
  const double near = square_of_near(frame);
  const std::size_t count = elements.size();
  now_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    Position position{};
    for (int axis = 0; axis < Dim; ++axis) {
      position[static_cast<std::size_t>(axis)] = read<T>(elements.center(axis), k);
    }
    now_[k] = position;
    const std::size_t old = before.empty() ? k : before[k];
    if (old >= positions_.size()) continue;
    Position difference{};
    double square = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      difference[axis] = position[axis] - positions_[old][axis];
      square += difference[axis] * difference[axis];
    }
    lattice::CellNumbers cells{};
    if (square < near || !frame.nearest(difference.data(), cells)) continue;
    if (cells == lattice::CellNumbers{}) continue;
    if (!any_) jumps_.assign(count, {});
    any_ = true;
    jumps_[k] = {cells[0], cells[1], cells[2]};
  }
}

void CellJumps::find(const ElementView& elements, const Domain& domain,
                     std::span<const std::uint32_t> before) {
  any_ = false;
  now_.clear();
  if (!domain.is_periodic()) return;
  const bool single = elements.precision() == Precision::float32;
  if (elements.dimensions() == 2) {
    single ? find_in<2, float>(elements, domain, before)
           : find_in<2, double>(elements, domain, before);
  } else {
    single ? find_in<3, float>(elements, domain, before)
           : find_in<3, double>(elements, domain, before);
  }
}

void CellJumps::accept() noexcept {
  positions_.swap(now_);
}

}  // namespace abut::history
