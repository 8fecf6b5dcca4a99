#pragma once

#include <abut/export.hpp>

#include <span>
#include <string_view>

namespace abut {

/// The ways to find the contact pairs. All give the same pairs; they differ in time and memory.
enum class Algorithm {
  automatic,  ///< named "auto": chosen from the number of elements
  direct_check,
  binary_tree,
  screening_array,
  sorting_array,
  munjiza_nbs,
  rows,  ///< the production engine
};

/// What a user must know to choose an algorithm. Constant; one row per algorithm.
struct AlgorithmInfo {
  Algorithm algorithm;
  std::string_view name;        ///< as written on the command line
  std::string_view idea;        ///< one line
  std::string_view time;        ///< cost law
  std::string_view memory;      ///< law of its own arrays, in integers
  std::string_view book_pages;  ///< Munjiza, The Combined Finite-Discrete Element Method, 2004
  int min_dimensions;
  int max_dimensions;
  bool periodic;   ///< whether it carries periodic domains
  bool traceable;  ///< whether trace::run shows its arrays
};

/// All algorithms that can be asked for by name, in the order of the book. `automatic` is not one.
[[nodiscard]] ABUT_API std::span<const AlgorithmInfo> algorithms();

/// The row of one algorithm. Throws Error{wrong_usage} for `automatic`.
[[nodiscard]] ABUT_API const AlgorithmInfo& info(Algorithm algorithm);

/// The algorithm of that name, "auto" included. Throws Error{wrong_usage} naming those there are.
[[nodiscard]] ABUT_API Algorithm algorithm_named(std::string_view name);

/// The name of an algorithm, "auto" for `automatic`.
[[nodiscard]] ABUT_API std::string_view name_of(Algorithm algorithm);

}  // namespace abut
