// A backend that runs the stages of the device engine on the host, with memory of its own: what
// stands above a backend (the detector, the tool) is tested with it where there is no device. It
// stands in the place of CUDA's, and refuses arrays that were not copied to it as that does.

#include "device/answer_of.hpp"
#include "device/backend.hpp"
#include "device/columns_of.hpp"
#include "device/device_columns.hpp"
#include "device/host/host_executor.hpp"
#include "device/host/stages_on_host.hpp"
#include "device/memory/kept_memory.hpp"

#include <abut/error.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::device {
namespace {

/// Blocks that stand for the memory of the device, by their addresses.
class Blocks {
 public:
  void* add(std::uint64_t bytes) {
    void* const block = ::operator new(bytes, alignment);
    const std::lock_guard lock(mutex_);
    ends_[static_cast<std::byte*>(block)] = static_cast<std::byte*>(block) + bytes;
    return block;
  }

  void remove(void* block) noexcept {
    const std::lock_guard lock(mutex_);
    ends_.erase(static_cast<std::byte*>(block));
    ::operator delete(block, alignment);
  }

  [[nodiscard]] bool hold(const std::byte* address) {
    const std::lock_guard lock(mutex_);
    const auto behind = ends_.upper_bound(address);
    return behind != ends_.begin() && std::less<>{}(address, std::prev(behind)->second);
  }

 private:
  static constexpr std::align_val_t alignment{256};  ///< that of CUDA

  std::mutex mutex_;
  std::map<const std::byte*, const std::byte*> ends_;  ///< of each block
};

Blocks& blocks() {
  static Blocks all;
  return all;
}

/// An address that nobody knows is one of the host, as CUDA has it.
ArrayPlace place_of_array(const void* address) {
  const bool is_known = blocks().hold(static_cast<const std::byte*>(address));
  return {is_known ? ArrayPlace::Memory::device : ArrayPlace::Memory::host, 0};
}

Allocator allocator_of_blocks() {
  return {[](std::uint64_t bytes, Stream) { return blocks().add(bytes); },
          [](void* block, std::uint64_t, Stream) { blocks().remove(block); }};
}

class HostBackend final : public Backend {
 public:
  explicit HostBackend(Allocator allocator)
      : memory_(allocator.allocate ? std::move(allocator) : allocator_of_blocks()) {}

  Answer list(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
              const Stream& stream, base::ProgressReporter& progress) override {
    return answer(spheres, request, max_bytes, stream, [&](const auto& elements) {
      return list_by_stages(*executor_, elements, request, progress);
    });
  }

  Answer count(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
               const Stream& stream, base::ProgressReporter& progress) override {
    return answer(spheres, request, max_bytes, stream, [&](const auto& elements) {
      return count_by_stages(*executor_, elements, request, progress);
    });
  }

  void copy_to_host(void* target, const void* source, std::uint64_t bytes) override {
    std::memcpy(target, source, bytes);
  }

  void wait() override {}

  void* allocate(std::uint64_t bytes) override { return blocks().add(bytes); }
  void release(void* block) noexcept override { blocks().remove(block); }
  void copy_to_device(void* target, const void* source, std::uint64_t bytes) override {
    std::memcpy(target, source, bytes);
  }

 private:
  template <class Call>
  Answer answer(const SphereSets& spheres, const DeviceRequest& request, std::uint64_t max_bytes,
                const Stream& stream, const Call& call) {
    found_ = {};
    require_device_columns(spheres.first, 0, place_of_array);
    if (spheres.second != nullptr) require_device_columns(*spheres.second, 0, place_of_array);
    require_device_arrays(request.rule, 0, place_of_array);
    return memory_.run(max_bytes, stream, [&] {
      executor_.emplace(memory_, ItemOrder::shuffled, 2);
      found_ = spheres.first.dimensions() == 2
                   ? call_with_elements<2>(spheres.first, spheres.second, request, call)
                   : call_with_elements<3>(spheres.first, spheres.second, request, call);
      return answer_of(found_, memory_.peak());
    });
  }

  KeptMemory memory_;
  std::optional<HostExecutor> executor_;
  FoundList<HostExecutor> found_;
};

}  // namespace

std::unique_ptr<Backend> open_backend(int device, Allocator allocator) {
  if (device != 0) {
    throw Error(ErrorCode::unavailable, "there is no device " + std::to_string(device) +
                                            ", this machine has 1; they are numbered from 0");
  }
  return std::make_unique<HostBackend>(std::move(allocator));
}

std::vector<DeviceInfo> found_devices() {
  return {{0, "stand-in on the host", std::uint64_t{1} << 30}};
}

}  // namespace abut::device
