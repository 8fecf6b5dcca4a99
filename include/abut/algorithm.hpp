#pragma once

#include <abut/export.hpp>

#include <span>
#include <string_view>

namespace abut {

/// Ways to find the contact pairs. All give the same pairs; they differ in time and memory.
enum class Algorithm {
  automatic,        ///< named "auto": chosen from the number of elements
  direct_check,     ///< every element against every other
  binary_tree,      ///< a tree over the occupied cells
  screening_array,  ///< a list for each cell
  sorting_array,    ///< elements sorted by cell
  munjiza_nbs,      ///< Munjiza's NBS: lists of rows, then of cells
  rows,             ///< the production engine
};

/// Facts about one algorithm, for those who choose one. Constant; one row per algorithm.
struct AlgorithmInfo {
  Algorithm algorithm;          ///< the value to put into Options
  std::string_view name;        ///< as written on the command line
  std::string_view idea;        ///< one line
  std::string_view time;        ///< cost law
  std::string_view memory;      ///< law of its own arrays in open space, in integers
  std::string_view book_pages;  ///< Munjiza, The Combined Finite-Discrete Element Method, 2004
  int min_dimensions = 2;       ///< fewest dimensions of its elements
  int max_dimensions = 3;       ///< most dimensions of its elements
  bool periodic = false;        ///< true if it supports periodic domains
  bool traceable = false;       ///< true if trace::run shows its arrays
};

/// Lists all algorithms that have a name, in the order of the book; not `automatic`.
[[nodiscard]] ABUT_API std::span<const AlgorithmInfo> algorithms();

/// Returns the facts about one algorithm. Throws Error{wrong_usage} for `automatic`.
[[nodiscard]] ABUT_API const AlgorithmInfo& info(Algorithm algorithm);

/// Returns the algorithm of that name, "auto" included. Throws Error{wrong_usage} for an unknown
/// name; the message lists the known ones.
[[nodiscard]] ABUT_API Algorithm algorithm_named(std::string_view name);

/// Returns the name of an algorithm, "auto" for `automatic`.
[[nodiscard]] ABUT_API std::string_view name_of(Algorithm algorithm);

}  // namespace abut
