#pragma once

/// Marks a function that runs on the host and in CUDA kernels. For any other compiler it is
/// nothing, so that sources which carry it need no CUDA.
#if defined(__CUDACC__)
#define ABUT_HD __host__ __device__
#else
#define ABUT_HD
#endif
