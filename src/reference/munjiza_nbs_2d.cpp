// Munjiza-NBS ("no binary search") in 2D: lists of rows, then lists of cells for two rows only.
// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, section 3.8, p. 102-117,
// eq. 3.59-3.65, Figures 3.40 to 3.44; A. Munjiza, K. R. F. Andrews, Int. J. Numer. Meth. Engng
// 43 (1998) 131-149.
//
//   row_head[n_y]        B      first element of each row
//   next_in_row[N]       Y      following element of the same row
//   cell_head[2][n_x]    A      first element of each cell of two rows: 0 the central row iy,
//                               1 the row below it, iy - 1
//   next_in_cell[N]      X      following element of the same cell; an element is in one row, so
//                               one array serves both
//
// Memory 2N + n_y + 2 n_x integers (eq. 3.65) and the cells of the mapping. No loop runs over
// cells, nothing is searched: time c N, with c independent of N and of the packing (eq. 3.64).

#include "reference/algorithms.hpp"
#include "reference/guarded_heads.hpp"
#include "reference/pair_decider.hpp"

#include <array>
#include <cstdint>

namespace abut::reference {
namespace {

template <class Test>
class MunjizaNbs2d {
 public:
  MunjizaNbs2d(const grid::CellCoordinates<2>& cells, Test& test, base::DetectionContext& context)
      : cells_(cells),
        test_(test),
        context_(context),
        row_head_(context.memory, cells.cell_count[1]),
        next_in_row_(context.memory, cells.element_count()),
        cell_head_{{context.memory, cells.cell_count[0]}, {context.memory, cells.cell_count[0]}},
        next_in_cell_(context.memory, cells.element_count()) {}

  void detect() {
    const auto count = static_cast<std::int32_t>(cells_.element_count());

    show_stage(context_, "stage 1: put every element on the list of its row");
    for (std::int32_t k = 0; k < count; ++k) {
      context_.work.did(1);
      next_in_row_.push(k, row_head_[y(k)]);
    }
    context_.list_insertions += cells_.element_count();
    row_head_.show(context_, "B", "row_head", IndexedBy::row);
    next_in_row_.show(context_, "Y", "next_in_row");

    for (std::int32_t k = 0; k < count; ++k) {
      context_.progress.at(static_cast<std::uint64_t>(k));
      std::int32_t& head = row_head_[y(k)];
      if (is_old(head)) continue;
      head = as_old(head);
      treat_central_row(y(k));
    }

    show_stage(context_, "unload the rows");
    for (std::int32_t k = 0; k < count; ++k) {
      context_.work.did(1);
      row_head_[y(k)] = none;
    }
    row_head_.show(context_, "B", "row_head", IndexedBy::row);
  }

 private:
  enum RowSet { central = 0, adjacent = 1 };

  void treat_central_row(std::int32_t iy) {
    load(iy, central);
    load(iy - 1, adjacent);
    show_stage(context_, "central row: lists of its cells and of those below", any, iy, any);
    cell_head_[central].show(context_, "A[0]", "cell_head[central]", IndexedBy::cell);
    cell_head_[adjacent].show(context_, "A[1]", "cell_head[adjacent]", IndexedBy::cell);
    next_in_cell_.show(context_, "X", "next_in_cell");

    for_each_in_row(iy, [this, iy](std::int32_t e) {
      const std::int32_t ix = x(e);
      std::int32_t& head = cell_head_[central][ix];
      if (is_old(head)) return;
      head = as_old(head);
      show_stage(context_, "central cell", ix, iy, any);
      treat_central_cell(ix);
    });

    for_each_in_row(iy, [this](std::int32_t e) { cell_head_[central][x(e)] = none; });
    for_each_in_row(iy - 1, [this](std::int32_t e) { cell_head_[adjacent][x(e)] = none; });
  }

  void load(std::int32_t row, RowSet set) {
    for_each_in_row(row, [this, set](std::int32_t e) {
      next_in_cell_.push(e, cell_head_[set][x(e)]);
      ++context_.list_insertions;
    });
  }

  void treat_central_cell(std::int32_t ix) {
    const std::int32_t left = first_of(cell_head_[central][ix - 1]);
    const std::int32_t below_left = cell_head_[adjacent][ix - 1];
    const std::int32_t below = cell_head_[adjacent][ix];
    const std::int32_t below_right = cell_head_[adjacent][ix + 1];
    for (std::int32_t f = first_of(cell_head_[central][ix]); f != none; f = next_in_cell_[f]) {
      check(f, next_in_cell_[f]);
      check(f, left);
      check(f, below_left);
      check(f, below);
      check(f, below_right);
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

  template <class Visit>
  void for_each_in_row(std::int32_t row, Visit visit) {
    for (std::int32_t e = first_of(row_head_[row]); e != none; e = next_in_row_[e]) {
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

  const grid::CellCoordinates<2>& cells_;
  Test& test_;
  base::DetectionContext& context_;
  GuardedHeads row_head_;
  NextInList next_in_row_;
  GuardedHeads cell_head_[2];
  NextInList next_in_cell_;
};

}  // namespace

template <class Test>
void munjiza_nbs_2d(const grid::CellCoordinates<2>& cells, Test& test,
                    base::DetectionContext& context) {
  MunjizaNbs2d<Test>(cells, test, context).detect();
}

template <>
double munjiza_nbs_bytes(const grid::CellCoordinates<2>& cells) {
  const auto& n = cells.uncollapsed_cell_count;
  return 4.0 * (2.0 * static_cast<double>(cells.element_count()) + n[1] + 2.0 * n[0]);
}

template void munjiza_nbs_2d(const grid::CellCoordinates<2>&, PairDecider<2>&,
                             base::DetectionContext&);
template void munjiza_nbs_2d(const grid::CellCoordinates<2>&, CandidateRecorder&,
                             base::DetectionContext&);

}  // namespace abut::reference
