// Binary tree: the cells are the leaves of a tree that halves space in x, y(, z) in turn.
// A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, section 3.5, p. 81-87,
// eq. 3.16-3.23, Figures 3.11 to 3.14.
//
//   left_child, right_child[nodes]   left, right node   -1 if that half is empty
//   cell_head[leaves]                HEAD               first element of the leaf's cell
//   next_in_cell[N]                  E                  following element of the same cell
//
// The book halves real intervals (eq. 3.16) and goes left if x < x_mid. The bits of the integer
// cell, from the highest down, are the same decisions without rounding: 0 left, 1 right. Only
// occupied cells have nodes.

#include "grid/half_stencil.hpp"
#include "reference/algorithms.hpp"
#include "reference/instantiate.hpp"
#include "reference/list_heads.hpp"
#include "reference/pair_decider.hpp"
#include "reference/show.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace abut::reference {
namespace {

template <int Dim>
class CellTree {
 public:
  using Cell = std::array<std::int32_t, Dim>;

  CellTree(const grid::CellCoordinates<Dim>& cells, base::DetectionContext& context)
      : cell_count_(cells.cell_count),
        left_child_(base::make_array_for_overwrite<std::int32_t>(context.memory, 0)),
        right_child_(base::make_array_for_overwrite<std::int32_t>(context.memory, 0)),
        cell_head_(base::make_array_for_overwrite<std::int32_t>(context.memory, 0)) {
    // A square (cube) whose side is a power of two times the cell.
    const std::int32_t widest = *std::max_element(cell_count_.begin(), cell_count_.end());
    bits_ = static_cast<int>(std::bit_width(static_cast<std::uint32_t>(widest - 1)));
    root_ = level_count() == 0 ? new_leaf() : new_node();
  }

  /// The leaf of a cell, made with its path where it is missing.
  std::int32_t grow_to(const Cell& cell) {
    std::int32_t here = root_;
    for (int level = 0; level < level_count(); ++level) {
      const bool right = goes_right(cell, level);
      std::int32_t child = (right ? right_child_ : left_child_)[index(here)];
      if (child == none) {
        child = level + 1 == level_count() ? new_leaf() : new_node();
        (right ? right_child_ : left_child_)[index(here)] = child;
      }
      here = child;
    }
    return here;
  }

  /// First element of a cell; none if it is empty or outside the domain.
  [[nodiscard]] std::int32_t first_in(const Cell& cell) const {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (cell[axis] < 0 || cell[axis] >= cell_count_[axis]) return none;
    }
    std::int32_t here = root_;
    for (int level = 0; level < level_count() && here != none; ++level) {
      here = (goes_right(cell, level) ? right_child_ : left_child_)[index(here)];
    }
    return here == none ? none : cell_head_[index(here)];
  }

  [[nodiscard]] std::uint64_t steps_to_leaf() const {
    return 1 + static_cast<std::uint64_t>(level_count());
  }

  [[nodiscard]] std::int32_t& head(std::int32_t leaf) { return cell_head_[index(leaf)]; }

  void show(base::DetectionContext& context) const {
    show_list(context, "left node", "left_child", left_child_, Meaning::cell, IndexedBy::position);
    show_list(context, "right node", "right_child", right_child_, Meaning::cell,
              IndexedBy::position);
    show_list(context, "HEAD", "cell_head", cell_head_, Meaning::element, IndexedBy::position);
  }

 private:
  static std::size_t index(std::int32_t number) { return static_cast<std::size_t>(number); }

  /// The book's b: Dim halvings for each bit of the cell number.
  [[nodiscard]] int level_count() const { return bits_ * Dim; }

  [[nodiscard]] bool goes_right(const Cell& cell, int level) const {
    const auto axis = static_cast<std::size_t>(level % Dim);
    return ((cell[axis] >> (bits_ - 1 - level / Dim)) & 1) != 0;
  }

  std::int32_t new_node() {
    left_child_.push_back(none);
    right_child_.push_back(none);
    return last_of(left_child_);
  }

  std::int32_t new_leaf() {
    cell_head_.push_back(none);
    return last_of(cell_head_);
  }

  static std::int32_t last_of(const base::Array<std::int32_t>& array) {
    if (array.size() > std::numeric_limits<std::int32_t>::max()) {
      throw Error(ErrorCode::limit_exceeded,
                  "binary_tree would need more than 2147483647 nodes; use sorting_array");
    }
    return static_cast<std::int32_t>(array.size() - 1);
  }

  std::array<std::int32_t, Dim> cell_count_;
  int bits_ = 0;
  base::Array<std::int32_t> left_child_;
  base::Array<std::int32_t> right_child_;
  base::Array<std::int32_t> cell_head_;
  std::int32_t root_ = none;
};

template <int Dim>
std::array<std::int32_t, Dim> cell_of(const grid::CellCoordinates<Dim>& cells,
                                      std::size_t element) {
  std::array<std::int32_t, Dim> cell{};
  for (std::size_t axis = 0; axis < Dim; ++axis) cell[axis] = cells.axis(axis)[element];
  return cell;
}

}  // namespace

template <int Dim, class Test>
void binary_tree(const grid::CellCoordinates<Dim>& cells, Test& test,
                 base::DetectionContext& context) {
  const std::size_t element_count = cells.element_count();
  if (element_count == 0) return;
  CellTree<Dim> tree(cells, context);
  auto next_in_cell = base::make_array<std::int32_t>(context.memory, element_count, none);

  show_stage(context, "build: put every element on the list of its leaf");
  for (std::size_t k = 0; k < element_count; ++k) {
    context.work.did(tree.steps_to_leaf());
    std::int32_t& head = tree.head(tree.grow_to(cell_of(cells, k)));
    next_in_cell[k] = head;
    head = static_cast<std::int32_t>(k);
  }
  context.list_insertions += element_count;
  tree.show(context);
  show_list(context, "E", "next_in_cell", next_in_cell);

  // The elements that follow k in its own list, and the lists of the mask: every pair once.
  show_stage(context, "detect: descend to the mask of each element");
  for (std::size_t k = 0; k < element_count; ++k) {
    context.progress.at(k);
    const auto e = static_cast<std::int32_t>(k);
    for (std::int32_t f = next_in_cell[k]; f != none;
         f = next_in_cell[static_cast<std::size_t>(f)]) {
      test(e, f);
    }
    const auto central = cell_of(cells, k);
    context.work.did(grid::HalfStencil<Dim>::offsets.size() * tree.steps_to_leaf());
    for (const auto& offset : grid::HalfStencil<Dim>::offsets) {
      auto neighbor = central;
      for (std::size_t axis = 0; axis < Dim; ++axis) neighbor[axis] += offset[axis];
      for (std::int32_t f = tree.first_in(neighbor); f != none;
           f = next_in_cell[static_cast<std::size_t>(f)]) {
        test(e, f);
      }
    }
  }
}

ABUT_INSTANTIATE_2D_AND_3D(binary_tree);

}  // namespace abut::reference
