#include "history/cell_jumps.hpp"

#include "base/workers.hpp"
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

template <int Dim, class T>
std::array<double, 3> position_of(const ElementView& elements, std::size_t k) {
  std::array<double, 3> position{};
  for (int axis = 0; axis < Dim; ++axis) {
    position[static_cast<std::size_t>(axis)] = read<T>(elements.center(axis), k);
  }
  return position;
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
                        std::span<const std::uint32_t> before, std::size_t workers) {
  const lattice::LatticeFrame<Dim> frame(elements::lattice_of(domain));
  const double near = square_of_near(frame);
  now_.resize(elements.size());
  found_.resize(workers);
  base::for_each_worker(workers, [&](std::size_t worker) {
    found_[worker].clear();
    const auto [first, last] = base::share_of(worker, workers, elements.size());
    for (std::size_t k = first; k < last; ++k) {
      now_[k] = position_of<Dim, T>(elements, k);
      const std::size_t old = before.empty() ? k : before[k];
      if (old >= positions_.size()) continue;
      Position difference{};
      double square = 0.0;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        difference[axis] = now_[k][axis] - positions_[old][axis];
        square += difference[axis] * difference[axis];
      }
      lattice::CellNumbers cells{};
      if (square < near || !frame.nearest(difference.data(), cells)) continue;
      if (cells == lattice::CellNumbers{}) continue;
      found_[worker].push_back({k, {cells[0], cells[1], cells[2]}});
    }
  });
  collect(elements.size());
}

/// Gives each element that has jumped its jump, and all others none.
void CellJumps::collect(std::size_t elements) {
  for (const std::vector<Jump>& jumps : found_) {
    if (jumps.empty()) continue;
    if (!any_) jumps_.assign(elements, {});
    any_ = true;
    for (const Jump& jump : jumps) jumps_[jump.number] = jump.cells;
  }
}

void CellJumps::find(const ElementView& elements, const Domain& domain,
                     std::span<const std::uint32_t> before, std::size_t workers) {
  any_ = false;
  now_.clear();
  if (!domain.is_periodic()) return;
  const bool single = elements.precision() == Precision::float32;
  if (elements.dimensions() == 2) {
    single ? find_in<2, float>(elements, domain, before, workers)
           : find_in<2, double>(elements, domain, before, workers);
  } else {
    single ? find_in<3, float>(elements, domain, before, workers)
           : find_in<3, double>(elements, domain, before, workers);
  }
}

void CellJumps::accept() noexcept {
  positions_.swap(now_);
}

}  // namespace abut::history
