#pragma once

#include "benchmarks/matrix/case.hpp"

#include "scenes/scene.hpp"

#include <cstddef>

namespace abut::benchmarks {

/// The names of the columns, on stdout. Times are nanoseconds for one element.
void write_header();

void write_case(const scenes::SceneInfo& scene, std::size_t elements, const CaseResult& result);

}  // namespace abut::benchmarks
