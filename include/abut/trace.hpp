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

/// Meaning of the numbers of an array; it tells which of them the book counts from 1.
enum class Meaning {
  element,  ///< element numbers, -1 for none
  cell,     ///< integerised coordinates
};

/// Things that an array may be indexed by.
enum class IndexedBy {
  element,   ///< element number
  position,  ///< position in a sorted array
  cell,      ///< cell
  row,       ///< row of cells
  layer,     ///< layer of rows
};

/// One array at one moment. `values` are in order of the index; for two axes [i][j] row by row,
/// for three [i][j][k].
struct Array {
  std::string_view book_symbol;                 ///< "C", "E", "A[0]", ...
  std::string_view name;                        ///< the identifier in the source: "cell_head", ...
  Meaning meaning = Meaning::element;           ///< meaning of the values
  IndexedBy indexed_by = IndexedBy::element;    ///< meaning of the index
  std::array<std::int32_t, 3> extent{0, 1, 1};  ///< number of values along each axis
  std::span<const std::int32_t> values;         ///< the numbers
};

/// One halving of the binary search: positions [first, last) were split before `middle`, and
/// [kept_first, kept_last) was kept.
struct SearchStep {
  std::size_t first;       ///< first position searched
  std::size_t middle;      ///< position of the split
  std::size_t last;        ///< position behind those searched
  std::size_t kept_first;  ///< first position kept
  std::size_t kept_last;   ///< position behind those kept
};

/// Receives what an algorithm shows. The spans live only during the call.
class ABUT_API Sink {
 public:
  /// Releases the sink.
  virtual ~Sink();
  /// Called when a stage begins. `cell` names its cell, row or layer, with -1 on axes without one.
  virtual void stage(std::string_view title, std::array<std::int32_t, 3> cell) = 0;
  /// Called with each array that the stage has filled.
  virtual void array(const Array& array) = 0;
  /// Called for each halving of a binary search.
  virtual void search_step(const SearchStep& step) = 0;
  /// Called for each candidate pair, in the order in which the algorithm finds them.
  virtual void candidate_pair(ElementIndex first, ElementIndex second) = 0;

 protected:
  Sink() = default;
  /// Copies are those of a derived class, never of a part of it.
  Sink(const Sink&) = default;
  /// Assigns as the constructor copies.
  Sink& operator=(const Sink&) = default;
};

/// The cells of the elements: all that the algorithms of the book look at before the test.
struct CellSystem {
  int dimensions = 2;                               ///< 2 or 3
  std::array<std::int32_t, 3> cell_count{1, 1, 1};  ///< number of cells along each axis
  std::vector<std::array<std::int32_t, 3>> cells;   ///< one per element, z = 0 in 2D
};

/// Computes the cells that a detection gives the elements. Throws what find_contact_pairs throws;
/// calls no hook.
[[nodiscard]] ABUT_API CellSystem integerise(const ElementView& elements, const Options& options);

/// Runs the algorithm on the cells and shows its arrays and its candidate pairs.
/// Throws Error{wrong_usage} for `automatic`, an algorithm that is not traceable or a cell outside
/// cell_count, Error{limit_exceeded} for arrays too long to read, and what the sink throws.
ABUT_API void run(Algorithm algorithm, const CellSystem& system, Sink& sink);

/// Numbers after the first split of the partition sort (book, Figures 3.28 to 3.38).
struct Partition {
  std::vector<std::int32_t> values;  ///< the numbers in their new order
  std::size_t left_size = 0;         ///< how many of them the split puts to the left
};

/// Splits the keys once, as the partition sort of `sorting_array` does first.
[[nodiscard]] ABUT_API Partition first_partition(std::span<const std::int32_t> values);

}  // namespace abut::trace
