#pragma once

#include <cstddef>

/// Answers of the OpenMP runtime that the caller's program runs with, and of its environment. The
/// library starts no thread of OpenMP's; it does as OpenMP would. Where OpenMP is not built in, the
/// answers are those of a program with one thread that may be asked for more.
namespace abut::base::openmp {

/// Threads that a parallel region of the caller would have: OMP_NUM_THREADS, omp_set_num_threads,
/// OMP_THREAD_LIMIT, or the processors that the process may use. At least 1.
[[nodiscard]] std::size_t default_threads() noexcept;

/// Tells whether the caller stands in a parallel region of its own within which OpenMP would start
/// no further threads.
[[nodiscard]] bool grants_one_thread_only() noexcept;

/// Times that a thread looks for work before it sleeps, in a team of `threads`: none by
/// OMP_WAIT_POLICY=passive, and none where the threads outnumber the processors.
[[nodiscard]] unsigned looks_before_sleep(std::size_t threads) noexcept;

/// The place, as OpenMP numbers them, that OMP_PROC_BIND gives to thread `number` of `threads`,
/// counted from the caller's own. -1 where threads are not bound.
[[nodiscard]] int place_of_thread(std::size_t number, std::size_t threads) noexcept;

/// Keeps the calling thread on the processors of that place, if there is one. Does nothing where
/// the system refuses.
void stay_in_place(int place) noexcept;

}  // namespace abut::base::openmp
