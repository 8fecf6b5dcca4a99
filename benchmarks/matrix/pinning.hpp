#pragma once

namespace abut::benchmarks {

/// Has OpenMP give each of its threads a processor of its own. OpenMP reads that when the program
/// is loaded, so this starts the program anew unless it was told before. Call it first in main.
void bind_openmp_threads(char** argv);

/// Keeps this thread, and what it starts later, on the first processor it may use. OpenMP's other
/// threads have places of their own.
void pin_to_one_processor();

}  // namespace abut::benchmarks
