#pragma once

#include <cuda_runtime_api.h>

namespace abut::device {

/// Throws Error{wrong_usage} if the stream records a graph, and Error{unexpected} if what the
/// caller asked CUDA for before has failed: a detection would be blamed for it. Afterwards the
/// runtime keeps no error of the calling thread, but for those after which nothing works.
void require_sound_stream(cudaStream_t stream);

}  // namespace abut::device
