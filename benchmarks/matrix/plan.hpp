#pragma once

#include "benchmarks/matrix/case.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <string>
#include <vector>

namespace abut::benchmarks {

/// Scenes, sizes and contestants to measure; the defaults are those of benchmarks/matrix/run.
struct Plan {
  std::vector<std::string> scenes{"dense",
                                  "dense_spread",
                                  "dense_stray",
                                  "boulders",
                                  "ordered",
                                  "gas",
                                  "sph",
                                  "sph_lattice",
                                  "sparse",
                                  "clusters",
                                  "clusters_100",
                                  "clusters_30",
                                  "shell",
                                  "crowds",
                                  "bidisperse",
                                  "polydisperse",
                                  "log_uniform",
                                  "log_uniform_1000",
                                  "graded",
                                  "graded_1000",
                                  "graded_by_place",
                                  "refined",
                                  "hexagonal_2d",
                                  "touching_cubic",
                                  "touching_fcc",
                                  "touching_cubic_shuffled",
                                  "touching_fcc_shuffled",
                                  "one_giant"};
  std::vector<double> counts{1e3, 1e4, 1e5, 1e6, 1e7};
  std::vector<std::string> contestants;  ///< empty: all
  std::vector<int> threads{1, 2};
  Effort effort;
};

struct Contestants {
  std::vector<Entry> entries;
  std::vector<Entry> referees;  ///< asked for the right pairs, one after the other
};

/// Those of the plan among all that were found. Throws Error{wrong_usage} for a name that is not
/// there.
[[nodiscard]] Contestants contestants_of(const Plan& plan);

}  // namespace abut::benchmarks
