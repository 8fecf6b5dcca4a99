// Contacts on a GPU, in a CUDA stream of the caller's: positions go to the device, contacts are
// found there and read there, each piece of work behind the one before it. Without CUDA, a driver
// or a device it says so in one sentence, which is no failure.
#include <abut/abut.hpp>
#include <abut/device.hpp>

#include <cstdio>
#include <exception>

#ifdef EXAMPLE_HAS_CUDA

#include <cuda_runtime_api.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void require(cudaError_t result, const char* action) {
  if (result == cudaSuccess) return;
  throw std::runtime_error(std::string("cannot ") + action + ": " + cudaGetErrorString(result));
}

class Stream {
 public:
  Stream() { require(cudaStreamCreateWithFlags(&handle_, cudaStreamNonBlocking), "make a stream"); }
  ~Stream() { static_cast<void>(cudaStreamDestroy(handle_)); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  operator cudaStream_t() const { return handle_; }

 private:
  cudaStream_t handle_ = nullptr;
};

/// Numbers in the memory of the device.
class DeviceColumn {
 public:
  explicit DeviceColumn(std::size_t count) : count_(count) {
    require(cudaMalloc(reinterpret_cast<void**>(&numbers_), count * sizeof(double)),
            "take memory of the device");
  }
  ~DeviceColumn() { static_cast<void>(cudaFree(numbers_)); }
  DeviceColumn(const DeviceColumn&) = delete;
  DeviceColumn& operator=(const DeviceColumn&) = delete;

  void set(const std::vector<double>& numbers, cudaStream_t stream) {
    require(cudaMemcpyAsync(numbers_, numbers.data(), count_ * sizeof(double),
                            cudaMemcpyHostToDevice, stream),
            "copy to the device");
  }
  [[nodiscard]] abut::Column<double> column() const { return {numbers_, count_}; }

 private:
  double* numbers_ = nullptr;
  std::size_t count_;
};

/// Prints pairs by work that stands behind the detection. Kernels of yours take `pairs.data()` in
/// the same way.
void print(const abut::device::PairList& pairs, cudaStream_t stream) {
  std::vector<abut::ContactPair> copy(pairs.size());
  // The list need not be there yet: what is put into the stream from here on runs behind it.
  require(cudaMemcpyAsync(copy.data(), pairs.data(), copy.size() * sizeof(abut::ContactPair),
                          cudaMemcpyDeviceToHost, stream),
          "copy to the host");
  require(cudaStreamSynchronize(stream), "finish the work of a step");
  for (const abut::ContactPair pair : copy) std::printf(" %u-%u", pair.first, pair.second);
  std::printf("\n");
}

/// A row of discs of diameter 1 that is pushed together from the right.
void push(std::vector<double>& x) {
  for (std::size_t k = 1; k < x.size(); ++k) x[k] -= 0.125 * static_cast<double>(k);
}

void run_steps() {
  // Declared first, so that it is destroyed last: a detector releases its memory in the order of
  // the stream of its last call. That stream must be there until the next call, or until then.
  const Stream stream;
  abut::device::Detector detector;

  std::vector<double> x{0.0, 1.0, 2.25, 3.5};
  const std::vector<double> y(x.size(), 0.0);
  DeviceColumn device_x(x.size());
  DeviceColumn device_y(y.size());
  device_y.set(y, stream);
  const abut::ElementView discs = abut::discs(device_x.column(), device_y.column(), 0.5);

  for (int step = 0; step < 3; ++step, push(x)) {
    // Work of yours, such as a kernel<<<blocks, threads, 0, stream>>> that moves the discs.
    device_x.set(x, stream);
    // In the same stream, and so behind it.
    const abut::device::PairList& pairs =
        detector.find_contact_pairs(discs, abut::Domain::open(), {stream});
    std::printf("step %d, %llu in all:", step, static_cast<unsigned long long>(pairs.size()));
    print(pairs, stream);
  }

  // An error names the element. It leaves no list, and stream and detector as they were.
  x[2] = -std::numeric_limits<double>::infinity();
  device_x.set(x, stream);
  try {
    detector.find_contact_pairs(discs, abut::Domain::open(), {stream});
  } catch (const abut::Error& error) {
    std::printf("error %d: %s\n", static_cast<int>(error.code()), error.what());
  }
  x[2] = 2.0;
  device_x.set(x, stream);
  std::printf("mended:");
  print(detector.find_contact_pairs(discs, abut::Domain::open(), {stream}), stream);
}

}  // namespace

#else

namespace {

void run_steps() {
  std::printf("there is a device, but this example was compiled without CUDA\n");
}

}  // namespace

#endif

int main() {
  try {
    static_cast<void>(abut::device::Detector());  // says why there is no device
    run_steps();
    return 0;
  } catch (const abut::Error& error) {
    std::printf("%s\n", error.what());
    return error.code() == abut::ErrorCode::unavailable ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "device_stream: %s\n", error.what());
    return 1;
  }
}
