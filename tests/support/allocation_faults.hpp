#pragma once

#include <cstddef>
#include <cstdint>

/// Watches, and on demand refuses, the memory that the program asks for: operator new, and the
/// aligned_alloc of page memory (wrapped by the linker, see CMakeLists.txt).
namespace abut::testing {

inline constexpr std::uint64_t never = ~std::uint64_t{0};

enum class Refuse { one, all_from_there_on };

/// While it lives, allocations are counted and the one with number `which` (from 0) is refused.
class AllocationFault {
 public:
  explicit AllocationFault(std::uint64_t which = never, Refuse how = Refuse::one);
  ~AllocationFault();
  AllocationFault(const AllocationFault&) = delete;
  AllocationFault& operator=(const AllocationFault&) = delete;

  /// Stops counting and refusing.
  void disarm();

  [[nodiscard]] std::uint64_t requests() const;
  [[nodiscard]] std::size_t largest_request() const;
};

/// Blocks allocated and not yet freed, in the whole program.
[[nodiscard]] std::int64_t live_blocks();

}  // namespace abut::testing
