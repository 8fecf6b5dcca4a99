#include "device/device_request.hpp"
#include "device/search/search_settings.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/wrapper.hpp"

#include <abut/device.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {
namespace {

// Bytes of an element. Records of 16 bytes, keys of 8 and two heads of 4 stay; so do widths of
// boxes, 8, or radii, 4.
constexpr std::uint64_t sorted_bytes = 16 + 8 + 8 + 2 * 4;
/// Two counts of an element.
constexpr std::uint64_t count_bytes = 2 * 4;
/// Two counts of an item of larger elements, and what some of these take themselves.
constexpr std::uint64_t item_bytes = 2 * 8 + SearchSettings::bytes_of_coarse;
/// The lowest element of a stretch on three axes, where larger elements look for their cells. There
/// is one head then.
constexpr std::uint64_t stretch_bytes = 3 * 4 - 4;
/// A ghost, or how an element is moved.
constexpr std::uint64_t image_bytes = 8;
static_assert(sizeof(lattice::Ghost) >= sizeof(lattice::CellsMoved));
/// A radix sort keeps a number for each digit of 8 bits and tile of some thousand keys, 1 KiB a
/// tile; scans and selections keep less.
constexpr std::uint64_t keys_of_scratch_byte = 4;
constexpr std::uint64_t fixed_scratch_bytes = std::uint64_t{16} << 20;
/// A pair and its shift, the shift at its place, and a key and a number twice while they are
/// sorted.
constexpr std::uint64_t bytes_with_shift =
    sizeof(ContactPair) + sizeof(ImageShift) + 2 * (sizeof(std::uint64_t) + sizeof(std::uint32_t));
static_assert(2 * (sizeof(std::uint64_t) + sizeof(std::uint32_t)) >=
              sizeof(std::uint64_t) + sizeof(std::uint32_t) + sizeof(ImageShift));
/// What the host is told of the elements, ends of arrays, heads of few elements.
constexpr std::uint64_t fixed_bytes = 8192;

std::uint64_t bytes_of(const PairRule& rule) {
  std::uint64_t bytes = 0;
  if (rule.table != nullptr) bytes += rule.table->words().size_bytes();
  if (rule.exclusions != nullptr && rule.exclusions->size() > 0) {
    bytes += rule.exclusions->offsets().size_bytes() + rule.exclusions->partners().size_bytes();
  }
  return bytes;
}

}  // namespace

MemoryPlan plan(std::uint64_t elements, PairCount pairs, const PairRule& rule) {
  MemoryPlan plan;
  if (elements == 0) return plan;
  plan.search_bytes =
      elements * (sorted_bytes + count_bytes) + item_bytes * most_items_at_a_time + fixed_bytes;
  plan.pair_bytes = pairs * 2 * sizeof(ContactPair);
  plan.gap_bytes = elements * stretch_bytes;
  plan.scratch_bytes = (elements + pairs) / keys_of_scratch_byte + fixed_scratch_bytes;
  plan.image_bytes = elements * image_bytes;
  plan.far_image_bytes = elements * (sizeof(lattice::Ghost) - image_bytes);
  plan.long_reach_bytes = pairs * sizeof(lattice::GhostOf<std::int64_t>);
  plan.quantity_bytes = pairs * sizeof(double);
  plan.rule_bytes = bytes_of(rule);
  plan.shift_bytes = pairs * bytes_with_shift - plan.pair_bytes;
  return plan;
}

}  // namespace abut::device
