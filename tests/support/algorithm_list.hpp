#pragma once

#include <abut/algorithm.hpp>

#include <vector>

namespace abut::testing {

/// Everything that can be asked for with that many dimensions: the rows of the registry, then
/// `automatic`. A new algorithm is tested by being registered.
[[nodiscard]] inline std::vector<Algorithm> algorithms_for(int dimensions) {
  std::vector<Algorithm> result;
  for (const AlgorithmInfo& row : algorithms()) {
    if (row.min_dimensions <= dimensions && dimensions <= row.max_dimensions) {
      result.push_back(row.algorithm);
    }
  }
  result.push_back(Algorithm::automatic);
  return result;
}

/// Those whose arrays trace::run shows: the algorithms of the book.
[[nodiscard]] inline std::vector<AlgorithmInfo> traceable_algorithms() {
  std::vector<AlgorithmInfo> result;
  for (const AlgorithmInfo& row : algorithms()) {
    if (row.traceable) result.push_back(row);
  }
  return result;
}

}  // namespace abut::testing
