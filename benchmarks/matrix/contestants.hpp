#pragma once

#include "benchmarks/matrix/contestant.hpp"

#include <vector>

namespace abut::benchmarks {

/// All contestants that were found when the benchmarks were configured, yardsticks first.
[[nodiscard]] std::vector<Entry> all_contestants();

}  // namespace abut::benchmarks
