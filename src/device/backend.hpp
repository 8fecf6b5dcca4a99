#pragma once

#include "base/progress_reporter.hpp"
#include "device/device_request.hpp"

#include <abut/device.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace abut::device {

/// One set of spheres or boxes, or two.
struct SphereSets {
  const ElementView& first;
  const ElementView* second = nullptr;
};

/// What a build has of a processor with memory of its own. There is one file that defines the two
/// functions below for CUDA, and one for a build without.
class Backend {
 public:
  virtual ~Backend() = default;
  Backend(const Backend&) = delete;
  Backend& operator=(const Backend&) = delete;

  /// What a detection leaves: arrays are memory of the device, valid until the next detection.
  struct Answer {
    const ContactPair* pairs = nullptr;
    const PairCount* offsets = nullptr;  ///< of a neighbor list, which has no pairs
    const ElementIndex* neighbors = nullptr;
    const ImageShift* shifts = nullptr;  ///< of the entries, where they are asked for
    const double* gaps = nullptr;        ///< of the entries, where they are asked for
    std::uint64_t entries = 0;           ///< pairs, or neighbors of all elements
    std::uint64_t contact_pairs = 0;
    std::uint64_t exact_decisions = 0;
    std::uint64_t candidate_tests = 0;
    std::uint64_t peak_bytes = 0;
  };

  [[nodiscard]] virtual Answer list(const SphereSets& spheres, const DeviceRequest& request,
                                    std::uint64_t max_bytes, const Stream& stream,
                                    base::ProgressReporter& progress) = 0;
  [[nodiscard]] virtual Answer count(const SphereSets& spheres, const DeviceRequest& request,
                                     std::uint64_t max_bytes, const Stream& stream,
                                     base::ProgressReporter& progress) = 0;

  /// Copies bytes that the last answer holds; waits for them.
  virtual void copy_to_host(void* target, const void* source, std::uint64_t bytes) = 0;

  /// Waits until the last answer is complete.
  virtual void wait() = 0;

  /// Memory of the device for the caller's own arrays, until it is released. The copy has been made
  /// when the call returns.
  [[nodiscard]] virtual void* allocate(std::uint64_t bytes) = 0;
  virtual void release(void* block) noexcept = 0;
  virtual void copy_to_device(void* target, const void* source, std::uint64_t bytes) = 0;

 protected:
  Backend() = default;
};

/// Throws Error{unavailable} with the reason. An allocator without functions is that of the
/// runtime.
[[nodiscard]] std::unique_ptr<Backend> open_backend(int device, Allocator allocator = {});

/// The devices of this machine; none where there is no driver, or no CUDA in this build.
[[nodiscard]] std::vector<DeviceInfo> found_devices();

}  // namespace abut::device
