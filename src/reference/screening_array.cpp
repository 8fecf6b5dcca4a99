// Screening array: one list of elements for each cell, empty or not.
// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, section 3.6, p. 89-94,
// eq. 3.31, Figures 3.19 and 3.20.
//
//   cell_head[n_x][n_y](...[n_z])   C   first element of each cell's list, -1 if empty
//   next_in_cell[N]                 E   following element of the same cell, -1 at the end
//
// Left out by the book and added here: guard cells around the array, so that the mask never leaves
// it; decoding of the heads that are marked as treated; clearing with the cells of the mapping.

#include "grid/half_stencil.hpp"
#include "reference/algorithms.hpp"
#include "reference/instantiate.hpp"
#include "reference/list_heads.hpp"
#include "reference/pair_decider.hpp"
#include "reference/show.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::reference {
namespace {

/// Lays the cells and one guard on each side of every axis out in a row:
///   index = ((x + 1) * (n_y + 2) + (y + 1)) * (n_z + 2) + (z + 1)
/// Cell (0, 0) of a 10 x 10 array has index 1 * 12 + 1 = 13.
template <int Dim>
class GuardedCells {
 public:
  explicit GuardedCells(const grid::CellCoordinates<Dim>& cells) : cells_(cells) {
    std::ptrdiff_t stride = 1;
    for (std::size_t axis = Dim; axis-- > 0;) {
      stride_[axis] = stride;
      stride *= cells.cell_count[axis] + 2;
    }
    size_ = static_cast<std::size_t>(stride);
    for (std::size_t k = 0; k < offset_.size(); ++k) {
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        offset_[k] += grid::HalfStencil<Dim>::offsets[k][axis] * stride_[axis];
      }
    }
  }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] std::size_t index_of(std::size_t element) const noexcept {
    std::ptrdiff_t index = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      index += (cells_.axis(axis)[element] + std::ptrdiff_t{1}) * stride_[axis];
    }
    return static_cast<std::size_t>(index);
  }

  /// Steps from the central cell to those of the contact mask.
  [[nodiscard]] const auto& mask() const noexcept { return offset_; }

 private:
  const grid::CellCoordinates<Dim>& cells_;
  std::array<std::ptrdiff_t, Dim> stride_{};
  std::array<std::ptrdiff_t, grid::HalfStencil<Dim>::offsets.size()> offset_{};
  std::size_t size_ = 0;
};

/// C as the book prints it, without guards.
template <int Dim>
void show_array_c(base::DetectionContext& context, const grid::CellCoordinates<Dim>& cells,
                  const base::Array<std::int32_t>& cell_head) {
  if (context.trace == nullptr) return;
  std::array<std::int32_t, 3> extent{1, 1, 1};
  for (std::size_t axis = 0; axis < Dim; ++axis) extent[axis] = cells.cell_count[axis];
  std::vector<std::int32_t> inner;
  for (std::int32_t x = 0; x < extent[0]; ++x) {
    for (std::int32_t y = 0; y < extent[1]; ++y) {
      for (std::int32_t z = 0; z < extent[2]; ++z) {
        std::ptrdiff_t index = (x + 1) * (extent[1] + std::ptrdiff_t{2}) + (y + 1);
        if constexpr (Dim == 3) index = index * (extent[2] + 2) + (z + 1);
        inner.push_back(first_of(cell_head[static_cast<std::size_t>(index)]));
      }
    }
  }
  context.trace->array({"C", "cell_head", Meaning::element, IndexedBy::cell, extent, inner});
}

}  // namespace

template <int Dim>
double screening_array_bytes(const grid::CellCoordinates<Dim>& cells) {
  double heads = 1.0;
  for (const double count : cells.uncollapsed_cell_count) heads *= count + 2.0;
  return 4.0 * (heads + static_cast<double>(cells.element_count()));
}

template <int Dim, class Test>
void screening_array(const grid::CellCoordinates<Dim>& cells, Test& test,
                     base::DetectionContext& context) {
  const GuardedCells<Dim> guarded(cells);
  const std::size_t element_count = cells.element_count();
  auto cell_head = base::make_array<std::int32_t>(context.memory, guarded.size(), none);
  auto next_in_cell = base::make_array<std::int32_t>(context.memory, element_count, none);

  show_stage(context, "step 1: put every element on the list of its cell");
  context.work.in_pieces(0, element_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      std::int32_t& head = cell_head[guarded.index_of(k)];
      next_in_cell[k] = head;
      head = static_cast<std::int32_t>(k);
    }
  });
  context.list_insertions += element_count;
  show_array_c(context, cells, cell_head);
  show_list(context, "E", "next_in_cell", next_in_cell);

  show_stage(context, "step 2: check each non-empty cell against its mask");
  for (std::size_t k = 0; k < element_count; ++k) {
    context.progress.at(k);
    const std::size_t central = guarded.index_of(k);
    if (is_old(cell_head[central])) continue;
    const std::int32_t first = cell_head[central];
    cell_head[central] = as_old(first);
    for (std::int32_t e = first; e != none; e = next_in_cell[static_cast<std::size_t>(e)]) {
      context.work.did(guarded.mask().size());
      for (std::int32_t f = next_in_cell[static_cast<std::size_t>(e)]; f != none;
           f = next_in_cell[static_cast<std::size_t>(f)]) {
        test(e, f);
      }
      for (const std::ptrdiff_t offset : guarded.mask()) {
        const auto neighbor =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(central) + offset);
        for (std::int32_t f = first_of(cell_head[neighbor]); f != none;
             f = next_in_cell[static_cast<std::size_t>(f)]) {
          test(e, f);
        }
      }
    }
  }

  show_stage(context, "step 3: empty the lists, without a loop over cells");
  context.work.in_pieces(0, element_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      next_in_cell[k] = none;
      cell_head[guarded.index_of(k)] = none;
    }
  });
  show_array_c(context, cells, cell_head);
  show_list(context, "E", "next_in_cell", next_in_cell);
}

template double screening_array_bytes(const grid::CellCoordinates<2>&);
template double screening_array_bytes(const grid::CellCoordinates<3>&);
ABUT_INSTANTIATE_2D_AND_3D(screening_array);

}  // namespace abut::reference
