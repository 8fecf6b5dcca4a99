#pragma once

#include <cstddef>

namespace abut::benchmarks {

/// Has OpenMP give each of its threads a processor of its own. OpenMP reads that when the program
/// is loaded, so this starts the program anew unless it was told before. Call it first in main.
void bind_openmp_threads(char** argv);

/// Keeps this thread, and what it starts later, on the first processor it may use. OpenMP's other
/// threads have places of their own.
void pin_to_one_processor();

/// Keeps this thread on the processor of that number, from 0 on, of those that this machine gives
/// the program; for threads that one on a single processor has started.
void pin_to_processor(std::size_t number);

}  // namespace abut::benchmarks
