#include "device/cuda/earlier_work.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::device {
namespace {

/// The host waits for numbers of a detection, for which a graph has no place.
void require_no_capture(cudaStream_t stream) {
  cudaStreamCaptureStatus status = cudaStreamCaptureStatusNone;
  const cudaError_t result = cudaStreamIsCapturing(stream, &status);
  if (result == cudaErrorStreamCaptureImplicit) static_cast<void>(cudaGetLastError());
  if (result != cudaErrorStreamCaptureImplicit && status == cudaStreamCaptureStatusNone) return;
  throw Error(
      ErrorCode::wrong_usage,
      "the stream records a graph, and a detection waits for numbers, which a graph cannot; "
      "end the recording first, or pass another stream");
}

/// Errors that callers meet and go on from, most often without clearing them.
bool is_no_failure(cudaError_t error) {
  return error == cudaSuccess || error == cudaErrorNotReady || error == cudaErrorMemoryAllocation ||
         error == cudaErrorPeerAccessAlreadyEnabled ||
         error == cudaErrorHostMemoryAlreadyRegistered;
}

void require_no_failure(cudaError_t error, const char* what) {
  if (is_no_failure(error)) return;
  throw Error(ErrorCode::unexpected, std::string(what) + " before this detection has failed: " +
                                         cudaGetErrorString(error) + "; mend that first");
}

}  // namespace

void require_sound_stream(cudaStream_t stream) {
  require_no_capture(stream);
  // The runtime keeps the last error for whoever asks for it next, which is who starts a kernel.
  // A stream that is still busy counts as one.
  const cudaError_t last = cudaGetLastError();
  const cudaError_t state = cudaStreamQuery(stream);
  static_cast<void>(cudaGetLastError());
  require_no_failure(state, "work that was put into the stream");
  require_no_failure(last, "a call of CUDA");
}

}  // namespace abut::device
