// Munjiza-NBS ("no binary search") in 3D: lists of layers, of rows for two layers, of cells for
// the central row and for its four neighbours merged.
// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, section 3.10, p. 118-127,
// eq. 3.73-3.80, Figures 3.59 to 3.63.
//
//   layer_head[n_z]      C   first element of each layer       next_in_layer[N]   Z
//   row_head[2][n_y]     B   first element of each row of two  next_in_row[N]     Y
//                            layers: 0 the central layer iz, 1 the layer below it, iz - 1
//   cell_head[2][n_x]    A   0 cells of the central row (iy, iz)   next_in_cell[N]   X
//                            1 cells of four rows merged (eq. 3.79): (iy - 1, iz) and
//                              (iy - 1, iz - 1), (iy, iz - 1), (iy + 1, iz - 1)
//
// Merging four rows is right because the mask holds all three cells ix - 1, ix, ix + 1 of each.
// Memory 3N + n_z + 2 n_y + 2 n_x integers (eq. 3.80) and the cells of the mapping.

#include "reference/algorithms.hpp"
#include "reference/guarded_heads.hpp"
#include "reference/pair_decider.hpp"

#include <array>
#include <cstdint>

namespace abut::reference {
namespace {

template <class Test>
class MunjizaNbs3d {
 public:
  MunjizaNbs3d(const grid::CellCoordinates<3>& cells, Test& test, base::DetectionContext& context)
      : cells_(cells),
        test_(test),
        context_(context),
        layer_head_(context.memory, cells.cell_count[2]),
        next_in_layer_(context.memory, cells.element_count()),
        row_head_{{context.memory, cells.cell_count[1]}, {context.memory, cells.cell_count[1]}},
        next_in_row_(context.memory, cells.element_count()),
        cell_head_{{context.memory, cells.cell_count[0]}, {context.memory, cells.cell_count[0]}},
        next_in_cell_(context.memory, cells.element_count()) {}

  void detect() {
    const auto count = static_cast<std::int32_t>(cells_.element_count());

    show_stage(context_, "stage 1: put every element on the list of its layer");
    for (std::int32_t k = 0; k < count; ++k) {
      context_.work.did(1);
      next_in_layer_.push(k, layer_head_[z(k)]);
    }
    context_.list_insertions += cells_.element_count();
    layer_head_.show(context_, "C", "layer_head", IndexedBy::layer);
    next_in_layer_.show(context_, "Z", "next_in_layer");

    for (std::int32_t k = 0; k < count; ++k) {
      context_.progress.at(static_cast<std::uint64_t>(k));
      std::int32_t& head = layer_head_[z(k)];
      if (is_old(head)) continue;
      head = as_old(head);
      treat_central_layer(z(k));
    }

    show_stage(context_, "unload the layers");
    for (std::int32_t k = 0; k < count; ++k) {
      context_.work.did(1);
      layer_head_[z(k)] = none;
    }
    layer_head_.show(context_, "C", "layer_head", IndexedBy::layer);
  }

 private:
  enum ListSet { central = 0, adjacent = 1 };

  void treat_central_layer(std::int32_t iz) {
    load_rows(iz, central);
    load_rows(iz - 1, adjacent);
    show_stage(context_, "central layer: lists of its rows and of those below", any, any, iz);
    row_head_[central].show(context_, "B[0]", "row_head[central]", IndexedBy::row);
    row_head_[adjacent].show(context_, "B[1]", "row_head[adjacent]", IndexedBy::row);
    next_in_row_.show(context_, "Y", "next_in_row");

    for_each_in_layer(iz, [this, iz](std::int32_t e) {
      std::int32_t& head = row_head_[central][y(e)];
      if (is_old(head)) return;
      head = as_old(head);
      treat_central_row(y(e), iz);
    });

    for_each_in_layer(iz, [this](std::int32_t e) { row_head_[central][y(e)] = none; });
    for_each_in_layer(iz - 1, [this](std::int32_t e) { row_head_[adjacent][y(e)] = none; });
  }

  void treat_central_row(std::int32_t iy, std::int32_t iz) {
    load_cells(central, iy, central);
    for_each_merged_row(
        iy, [this](ListSet layer, std::int32_t row) { load_cells(layer, row, adjacent); });
    show_stage(context_, "central row: lists of its cells and of four rows merged", any, iy, iz);
    cell_head_[central].show(context_, "A[0]", "cell_head[central]", IndexedBy::cell);
    cell_head_[adjacent].show(context_, "A[1]", "cell_head[adjacent]", IndexedBy::cell);
    next_in_cell_.show(context_, "X", "next_in_cell");

    for_each_in_row(central, iy, [this, iy, iz](std::int32_t e) {
      const std::int32_t ix = x(e);
      std::int32_t& head = cell_head_[central][ix];
      if (is_old(head)) return;
      head = as_old(head);
      show_stage(context_, "central cell", ix, iy, iz);
      treat_central_cell(ix);
    });

    unload_cells(central, iy, central);
    for_each_merged_row(
        iy, [this](ListSet layer, std::int32_t row) { unload_cells(layer, row, adjacent); });
  }

  void treat_central_cell(std::int32_t ix) {
    const std::int32_t left = first_of(cell_head_[central][ix - 1]);
    const std::int32_t merged_left = cell_head_[adjacent][ix - 1];
    const std::int32_t merged = cell_head_[adjacent][ix];
    const std::int32_t merged_right = cell_head_[adjacent][ix + 1];
    for (std::int32_t f = first_of(cell_head_[central][ix]); f != none; f = next_in_cell_[f]) {
      check(f, next_in_cell_[f]);
      check(f, left);
      check(f, merged_left);
      check(f, merged);
      check(f, merged_right);
    }
  }

  /// Element f against the list that begins with g.
  void check(std::int32_t f, std::int32_t g) {
    if (g != none) check_all(f, g);
  }

  /// Out of line: copies of the test in each of the five places would leave no registers for lists.
  [[gnu::noinline]] void check_all(std::int32_t f, std::int32_t g) {
    for (; g != none; g = next_in_cell_[g]) test_(f, g);
  }

  void load_rows(std::int32_t layer, ListSet set) {
    for_each_in_layer(layer, [this, set](std::int32_t e) {
      next_in_row_.push(e, row_head_[set][y(e)]);
      ++context_.list_insertions;
    });
  }

  void load_cells(ListSet layer, std::int32_t row, ListSet set) {
    for_each_in_row(layer, row, [this, set](std::int32_t e) {
      next_in_cell_.push(e, cell_head_[set][x(e)]);
      ++context_.list_insertions;
    });
  }

  void unload_cells(ListSet layer, std::int32_t row, ListSet set) {
    for_each_in_row(layer, row, [this, set](std::int32_t e) { cell_head_[set][x(e)] = none; });
  }

  /// The four rows of eq. 3.79.
  template <class Visit>
  void for_each_merged_row(std::int32_t iy, Visit visit) {
    visit(central, iy - 1);
    visit(adjacent, iy - 1);
    visit(adjacent, iy);
    visit(adjacent, iy + 1);
  }

  template <class Visit>
  void for_each_in_layer(std::int32_t layer, Visit visit) {
    for (std::int32_t e = first_of(layer_head_[layer]); e != none; e = next_in_layer_[e]) {
      context_.work.did(1);
      visit(e);
    }
  }

  template <class Visit>
  void for_each_in_row(ListSet layer, std::int32_t row, Visit visit) {
    for (std::int32_t e = first_of(row_head_[layer][row]); e != none; e = next_in_row_[e]) {
      context_.work.did(1);
      visit(e);
    }
  }

  [[nodiscard]] std::int32_t x(std::int32_t e) const {
    return cells_.x(static_cast<std::size_t>(e));
  }
  [[nodiscard]] std::int32_t y(std::int32_t e) const {
    return cells_.y(static_cast<std::size_t>(e));
  }
  [[nodiscard]] std::int32_t z(std::int32_t e) const {
    return cells_.z(static_cast<std::size_t>(e));
  }

  const grid::CellCoordinates<3>& cells_;
  Test& test_;
  base::DetectionContext& context_;
  GuardedHeads layer_head_;
  NextInList next_in_layer_;
  GuardedHeads row_head_[2];
  NextInList next_in_row_;
  GuardedHeads cell_head_[2];
  NextInList next_in_cell_;
};

}  // namespace

template <class Test>
void munjiza_nbs_3d(const grid::CellCoordinates<3>& cells, Test& test,
                    base::DetectionContext& context) {
  MunjizaNbs3d<Test>(cells, test, context).detect();
}

template <>
double munjiza_nbs_bytes(const grid::CellCoordinates<3>& cells) {
  const auto& n = cells.uncollapsed_cell_count;
  return 4.0 * (3.0 * static_cast<double>(cells.element_count()) + n[2] + 2.0 * n[1] + 2.0 * n[0]);
}

template void munjiza_nbs_3d(const grid::CellCoordinates<3>&, PairDecider<3>&,
                             base::DetectionContext&);
template void munjiza_nbs_3d(const grid::CellCoordinates<3>&, CandidateRecorder&,
                             base::DetectionContext&);

}  // namespace abut::reference
