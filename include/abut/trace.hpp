#pragma once

#include <abut/algorithm.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// A look inside the algorithms of the book: the arrays that its figures draw, stage by stage.
/// Element numbers and cells are counted from 0, "none" is -1; the book counts from 1.
namespace abut::trace {

/// What the numbers of an array mean, hence which of them the book counts from 1.
enum class Meaning {
  element,  ///< element numbers, -1 for none
  cell,     ///< integerised coordinates
};

/// What an array is indexed by.
enum class IndexedBy { element, position, cell, row, layer };

/// One array as it stands. `values` are in order of the index; for two axes [i][j] row by row,
/// for three [i][j][k].
struct Array {
  std::string_view book_symbol;  ///< "C", "E", "A[0]", ...
  std::string_view name;         ///< the identifier in the source: "cell_head", ...
  Meaning meaning = Meaning::element;
  IndexedBy indexed_by = IndexedBy::element;
  std::array<std::int32_t, 3> extent{0, 1, 1};
  std::span<const std::int32_t> values;
};

/// One halving of the binary search: positions [first, last) were split before `middle`, and
/// [kept_first, kept_last) was kept.
struct SearchStep {
  std::size_t first, middle, last, kept_first, kept_last;
};

/// Receives what an algorithm shows. The spans live only during the call.
class ABUT_API Sink {
 public:
  virtual ~Sink();
  /// A stage begins. `cell` holds what it treats (a cell, a row, a layer), -1 on axes without one.
  virtual void stage(std::string_view title, std::array<std::int32_t, 3> cell) = 0;
  virtual void array(const Array& array) = 0;
  virtual void search_step(const SearchStep& step) = 0;
  virtual void candidate_pair(ElementIndex first, ElementIndex second) = 0;
};

/// Elements by their cells alone: all that the algorithms of the book look at before the test.
struct CellSystem {
  int dimensions = 2;
  std::array<std::int32_t, 3> cell_count{1, 1, 1};
  std::vector<std::array<std::int32_t, 3>> cells;  ///< one per element, z = 0 in 2D
};

/// The cells that a detection gives the elements. Throws as find_contact_pairs does; calls no hook.
[[nodiscard]] ABUT_API CellSystem integerise(const ElementView& elements, const Options& options);

/// Runs the algorithm on the cells and shows its arrays and its candidate pairs.
/// Throws Error{wrong_usage} for `automatic`, an algorithm that is not traceable or a cell outside
/// cell_count, Error{limit_exceeded} for arrays too long to read, and what the sink throws.
ABUT_API void run(Algorithm algorithm, const CellSystem& system, Sink& sink);

/// Sorts the keys with the partition sort of the sorting algorithm and returns, for each array
/// the first split leaves behind, the numbers as they lie then (book, Figures 3.28 to 3.38).
struct Partition {
  std::vector<std::int32_t> values;
  std::size_t left_size = 0;
};
[[nodiscard]] ABUT_API Partition first_partition(std::span<const std::int32_t> values);

}  // namespace abut::trace
