#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>
#include <abut/statistics.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// Contacts of elements in the memory of a GPU: the pairs of the library, byte for byte. These are
/// functions of a library of their own, abut::device, and libabut knows nothing of it. A build
/// without CUDA has them as well; each that needs a device throws Error{unavailable} then.
namespace abut::device {

/// Description of a device.
struct DeviceInfo {
  int number = 0;                  ///< number by which `on` names it
  std::string name;                ///< name that its driver gives
  std::uint64_t memory_bytes = 0;  ///< bytes of its memory
};

/// Devices of this machine; none where there is no driver, or no CUDA in this build. Never throws
/// for want of a device.
[[nodiscard]] ABUT_API std::vector<DeviceInfo> devices();

/// Choice of a device; see `on`.
struct Device {
  int number = 0;  ///< number of the device, from 0
};

/// Names a device by its number.
[[nodiscard]] constexpr Device on(int number) noexcept {
  return {number};
}

/// Stream that the work of a detection is put into, as the runtime has it (cudaStream_t); without a
/// handle the default stream.
struct Stream {
  void* handle = nullptr;  ///< handle of the runtime
};

/// Most bytes that a detection holds in the memory of its device, beside the caller's arrays and
/// the scratch memory of sorts and scans.
struct MemoryPlan {
  std::uint64_t search_bytes = 0;  ///< bytes of the search, from the number of elements
  std::uint64_t pair_bytes = 0;    ///< bytes of the list while it is brought into order
  std::uint64_t gap_bytes = 0;     ///< bytes more in a domain far wider than its elements need

  /// Bytes in a domain without wide gaps.
  [[nodiscard]] std::uint64_t bytes() const noexcept { return search_bytes + pair_bytes; }
};

/// Plans the memory of a detection. `pairs` counts the contact pairs and those that must be decided
/// exactly, which on lattices that touch are all.
[[nodiscard]] ABUT_API MemoryPlan plan(std::uint64_t elements, PairCount pairs);

class Backend;

/// The contact pairs of one detection, in canonical order, in the memory of a device. They belong
/// to the detector, and are valid in the order of its stream until its next call.
class ABUT_API PairList {
 public:
  /// Address of the first pair, in the memory of the device.
  [[nodiscard]] const ContactPair* data() const noexcept { return pairs_; }
  /// Number of pairs.
  [[nodiscard]] PairCount size() const noexcept { return statistics_.contact_pairs; }
  /// True if there is no pair.
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  /// Statistics of the detection; peak_bytes are those of the device.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }
  /// Copies the pairs to the host, and waits for them.
  [[nodiscard]] abut::PairList to_host() const;

 private:
  friend class Detector;

  const ContactPair* pairs_ = nullptr;
  Statistics statistics_;
  Backend* backend_ = nullptr;
};

/// Detects the contacts of elements in the memory of one device.
///
/// Options mean what they mean for abut::Detector, except that pairs always come in canonical order
/// and that `threads` and `simd` mean nothing. What a device does not do yet throws
/// Error{wrong_usage} and says what to take instead: boxes, periodic domains, rules, quantities,
/// stored shifts, and algorithms other than `rows` and `automatic`.
class ABUT_API Detector {
 public:
  /// Makes a detector on a device. Throws Error{unavailable} where that is not there.
  explicit Detector(Options options = {}, Device device = on(0));
  /// Releases the memory, also that of the last list.
  ~Detector();

  /// Takes over another detector with its list.
  Detector(Detector&&) noexcept;
  /// Takes over another detector with its list.
  Detector& operator=(Detector&&) noexcept;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  /// Finds all contact pairs of elements whose columns lie in the memory of the device, aligned for
  /// their numbers. The list is valid until the next call. Throws what abut::find_contact_pairs
  /// throws.
  const PairList& find_contact_pairs(const ElementView& elements,
                                     const Domain& domain = Domain::open(), Stream stream = {});

  /// Counts the contact pairs without storing them.
  Statistics count_contact_pairs(const ElementView& elements, const Domain& domain = Domain::open(),
                                 Stream stream = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut::device
