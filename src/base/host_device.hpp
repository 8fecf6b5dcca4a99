#pragma once

/// Marks a function that runs on the host and in CUDA kernels. For any other compiler it is
/// nothing, so that sources which carry it need no CUDA.
#if defined(__CUDACC__)
#define ABUT_HD __host__ __device__
#else
#define ABUT_HD
#endif

/// Marks such a function that kernels call instead of having a copy in each place: a large one,
/// whose copies take the compiler minutes.
#if defined(__CUDACC__)
#define ABUT_HD_CALLED ABUT_HD __noinline__
#else
#define ABUT_HD_CALLED
#endif
