// Sorting: elements sorted by cell, cells found by binary search.
// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, section 3.7, p. 94-102,
// eq. 3.40-3.42, Figures 3.21 to 3.27; in 3D p. 120.
//
//   sorted_cell_x, _y(, _z)[N]   X, Y(, Z)   integerised coordinates, sorted by (X, then Y, then Z)
//   sorted_element[N]            D           whose they are; last key, so that the order is unique
//
// Memory 3N integers in 2D, 4N in 3D, whatever the domain and the packing.

#include "grid/half_stencil.hpp"
#include "reference/algorithms.hpp"
#include "reference/instantiate.hpp"
#include "reference/pair_decider.hpp"
#include "reference/partition_sort.hpp"
#include "reference/show.hpp"

#include <array>
#include <bit>
#include <compare>
#include <cstdint>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

namespace abut::reference {
namespace {

template <int Dim>
class SortedCells {
 public:
  SortedCells(const grid::CellCoordinates<Dim>& cells, base::DetectionContext& context)
      : SortedCells(cells, context, std::make_index_sequence<Dim>{}) {}

  [[nodiscard]] std::array<std::int32_t, Dim> cell(std::size_t position) const noexcept {
    std::array<std::int32_t, Dim> result{};
    for (std::size_t axis = 0; axis < Dim; ++axis) result[axis] = sorted_cell_[axis][position];
    return result;
  }
  [[nodiscard]] std::int32_t element(std::size_t position) const noexcept {
    return sorted_element_[position];
  }
  [[nodiscard]] std::size_t size() const noexcept { return sorted_element_.size(); }

  /// Position of the first element of the cell, or size() if the cell is empty. Halves the arrays
  /// and rejects the part that cannot hold it (Figures 3.25 to 3.27): ceil(log2 N) steps.
  [[nodiscard]] std::size_t find(const std::array<std::int32_t, Dim>& wanted) const {
    std::size_t first = 0;
    std::size_t last = size();
    while (last - first > 1) {
      const std::size_t middle = first + (last - first) / 2;
      const bool right = cell(middle - 1) < wanted;
      if (context_.trace != nullptr) {
        context_.trace->search_step(
            {first, middle, last, right ? middle : first, right ? last : middle});
      }
      (right ? first : last) = middle;
    }
    return cell(first) == wanted ? first : size();
  }

  void show() const {
    static constexpr std::array<std::string_view, 3> symbol{"X", "Y", "Z"};
    static constexpr std::array<std::string_view, 3> name{"sorted_cell_x", "sorted_cell_y",
                                                          "sorted_cell_z"};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      show_list(context_, symbol[axis], name[axis], sorted_cell_[axis], Meaning::cell,
                IndexedBy::position);
    }
    show_list(context_, "D", "sorted_element", sorted_element_, Meaning::element,
              IndexedBy::position);
  }

 private:
  template <std::size_t... Axis>
  SortedCells(const grid::CellCoordinates<Dim>& cells, base::DetectionContext& context,
              std::index_sequence<Axis...>)
      : context_(context),
        sorted_cell_{base::Array<std::int32_t>(cells.axis(Axis))...},
        sorted_element_(
            base::make_array_for_overwrite<std::int32_t>(context.memory, cells.element_count())) {
    show_stage(context, "step 1: integerise");
    std::iota(sorted_element_.begin(), sorted_element_.end(), 0);
    show();
    show_stage(context, "step 2: sort by cell");
    CompanionArrays<Dim + 1> arrays({std::span(sorted_cell_[Axis])..., std::span(sorted_element_)});
    arrays.sort(0, size(), context.work);
    show();
  }

  base::DetectionContext& context_;
  std::array<base::Array<std::int32_t>, Dim> sorted_cell_;
  base::Array<std::int32_t> sorted_element_;
};

}  // namespace

template <int Dim, class Test>
void sorting_array(const grid::CellCoordinates<Dim>& cells, Test& test,
                   base::DetectionContext& context) {
  const SortedCells<Dim> sorted(cells, context);

  show_stage(context, "step 3: search the mask of each element");
  const std::uint64_t steps_of_mask =
      grid::HalfStencil<Dim>::offsets.size() * std::bit_width(sorted.size());
  for (std::size_t position = 0; position < sorted.size(); ++position) {
    context.progress.at(position);
    context.work.did(steps_of_mask);
    const std::int32_t e = sorted.element(position);
    const auto central = sorted.cell(position);
    for (std::size_t p = position + 1; p < sorted.size() && sorted.cell(p) == central; ++p) {
      test(e, sorted.element(p));
    }
    for (const auto& offset : grid::HalfStencil<Dim>::offsets) {
      auto neighbor = central;
      for (std::size_t axis = 0; axis < Dim; ++axis) neighbor[axis] += offset[axis];
      if (context.trace != nullptr) {
        const std::int32_t z = Dim == 3 ? neighbor.back() : any;
        show_stage(context, "binary search", neighbor[0], neighbor[1], z);
      }
      for (std::size_t p = sorted.find(neighbor); p < sorted.size() && sorted.cell(p) == neighbor;
           ++p) {
        test(e, sorted.element(p));
      }
    }
  }
}

ABUT_INSTANTIATE_2D_AND_3D(sorting_array);

}  // namespace abut::reference
