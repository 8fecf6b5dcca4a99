// A caller's kernel has failed before a detection: that is told, and nothing ends the program. It
// is a program of its own, since nothing works in the context of such a failure. Exit code 0 where
// the sentence is right, 1 where not, 6 without a device.

#include <abut/device.hpp>
#include <abut/device_elements.hpp>
#include <abut/error.hpp>

#include <cuda_runtime.h>

#include <iostream>
#include <string>
#include <vector>

namespace {

__global__ void fail() {
  __trap();
}

}  // namespace

int main() {
  try {
    const std::vector<double> x{0.0, 1.0, 2.0};
    const abut::device::ElementCopy copy(abut::discs(x, x, 1.0));
    abut::device::Detector detector;
    fail<<<1, 1>>>();
    static_cast<void>(cudaDeviceSynchronize());
    detector.find_contact_pairs(copy.elements());
  } catch (const abut::Error& error) {
    if (error.code() == abut::ErrorCode::unavailable) {
      std::cerr << "after_failure: " << error.what() << '\n';
      return static_cast<int>(error.code());
    }
    const std::string sentence = error.what();
    if (sentence.find("put into the stream before this detection has failed") != sentence.npos) {
      return 0;
    }
    std::cerr << "another sentence: " << sentence << '\n';
    return 1;
  }
  std::cerr << "no error\n";
  return 1;
}
