#pragma once

#include <abut/device_lists.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/statistics.hpp>

#include <cstdint>
#include <functional>
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
/// handle the default stream. A stream must outlive the next call of the detector, or the detector:
/// memory that it keeps is released in the order of the stream of its last call.
struct Stream {
  void* handle = nullptr;  ///< handle of the runtime
};

/// Functions of the caller's that give memory of a device, in place of the runtime's pool: those of
/// CuPy or PyTorch, or of a program with a pool of its own. A detector calls them in the thread
/// that calls it, with the stream of the call.
struct Allocator {
  /// Returns memory for what is put into the stream from then on, aligned to 256 bytes; null if
  /// there is none, which becomes Error{limit_exceeded}.
  std::function<void*(std::uint64_t bytes, Stream stream)> allocate;
  /// Takes a block back, which work that is in the stream already may still use. Must not throw.
  std::function<void(void* block, std::uint64_t bytes, Stream stream)> release;
};

/// Most bytes that a detection holds in the memory of its device, beside the caller's arrays.
struct MemoryPlan {
  std::uint64_t search_bytes = 0;  ///< bytes of the search, from the number of elements
  std::uint64_t pair_bytes = 0;    ///< bytes of the list while it is brought into order
  std::uint64_t gap_bytes = 0;     ///< bytes more in a domain so wide that gaps are closed
  std::uint64_t image_bytes = 0;   ///< bytes more in a periodic domain
  /// Bytes more in a periodic domain where numbers of cells are too large for one word: of elements
  /// about a million cells out along each of three sides.
  std::uint64_t far_image_bytes = 0;
  /// Bytes more where shifts are stored, or gaps are measured in a periodic domain.
  std::uint64_t shift_bytes = 0;
  /// Bytes more where the reach is about as long as a periodic cell or longer.
  std::uint64_t long_reach_bytes = 0;
  std::uint64_t quantity_bytes = 0;  ///< bytes more where gaps are measured
  std::uint64_t rule_bytes = 0;      ///< bytes more of the table and the exclusions of a rule
  /// Scratch memory of sorts and scans: a bound by what is known of them, as only a device can
  /// tell.
  std::uint64_t scratch_bytes = 0;

  /// Bytes in an open domain without wide gaps, without scratch memory.
  [[nodiscard]] std::uint64_t bytes() const noexcept { return search_bytes + pair_bytes; }
};

/// Plans the memory of a detection. `pairs` counts the contact pairs, for a full neighbor list each
/// twice, and those that must be decided exactly, which on lattices that touch are all. `elements`
/// counts those of both sets, and in a periodic domain the ghosts, too, the images of elements near
/// its faces. Of a rule nothing is asked but the sizes of its table and its exclusions.
[[nodiscard]] ABUT_API MemoryPlan plan(std::uint64_t elements, PairCount pairs,
                                       const PairRule& rule = {});

/// Detects the contacts of elements in the memory of one device.
///
/// Options mean what they mean for abut::Detector, except that pairs always come in canonical order
/// and that `threads` and `simd` mean nothing. The arrays of a rule lie in the memory of the device
/// (RuleCopy brings them there), its table and its exclusions on the host, from where each call
/// copies them. What a device does not do yet throws Error{wrong_usage} and says what to take
/// instead: quantities other than gaps, and algorithms other than `rows` and `automatic`.
class ABUT_API Detector {
 public:
  /// Makes a detector on a device, with memory of its own or of an allocator. Throws
  /// Error{unavailable} where the device is not there, and Error{wrong_usage} where the allocator
  /// has only one of its two functions.
  explicit Detector(Options options = {}, Device device = on(0), Allocator allocator = {});
  /// Releases the memory, also that of the last list.
  ~Detector();

  /// Takes over another detector with its list.
  Detector(Detector&&) noexcept;
  /// Takes over another detector with its list.
  Detector& operator=(Detector&&) noexcept;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  /// Options of the next call.
  [[nodiscard]] const Options& options() const noexcept;
  /// Sets the options of the next call.
  void set_options(Options options);

  /// Finds all contact pairs of elements whose columns lie in the memory of the device, aligned for
  /// their numbers. The list is valid until the next call. Throws what abut::find_contact_pairs
  /// throws.
  const PairList& find_contact_pairs(const ElementView& elements,
                                     const Domain& domain = Domain::open(), Stream stream = {});

  /// Finds the contact pairs of two sets: element i of `first` and element j of `second`, in order
  /// of (i, j, image shift of j). The sets may have numbers of different types.
  const PairList& find_contact_pairs(const ElementView& first, const ElementView& second,
                                     const Domain& domain = Domain::open(), Stream stream = {});

  /// Builds a neighbor list: that of abut::build_neighbor_list. The list is valid until the next
  /// call.
  const NeighborList& build_neighbor_list(const ElementView& elements, const Domain& domain,
                                          NeighborListKind kind, Stream stream = {});

  /// Builds a neighbor list with one row for each element of `first` and indices of `second`.
  const NeighborList& build_neighbor_list(const ElementView& first, const ElementView& second,
                                          const Domain& domain = Domain::open(),
                                          Stream stream = {});

  /// Counts the contact pairs without storing them.
  Statistics count_contact_pairs(const ElementView& elements, const Domain& domain = Domain::open(),
                                 Stream stream = {});

  /// Counts the contact pairs of two sets without storing them.
  Statistics count_contact_pairs(const ElementView& first, const ElementView& second,
                                 const Domain& domain = Domain::open(), Stream stream = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut::device
