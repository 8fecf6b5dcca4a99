#pragma once

#include "console.hpp"
#include "load_snapshot.hpp"

#include <abut/algorithm.hpp>

namespace abut::cli {

struct ExplainOptions {
  Algorithm algorithm = Algorithm::munjiza_nbs;
  InputOptions input;  ///< an empty path: the book's example
  double margin = 0.0;
  ConsoleOptions console;
};

/// Walks through an algorithm, printing its arrays.
void run(const ExplainOptions& options);

}  // namespace abut::cli
