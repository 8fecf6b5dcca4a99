#pragma once

#include <abut/algorithm.hpp>
#include <abut/export.hpp>
#include <abut/pair.hpp>
#include <abut/pair_rule.hpp>
#include <abut/progress.hpp>
#include <abut/quantity.hpp>
#include <abut/simd.hpp>

#include <cstdint>
#include <limits>

namespace abut {

/// Order of the pairs that are returned.
enum class Order {
  canonical,  ///< ascending by (first, second, shift): the same bytes from every algorithm
  as_found,   ///< the algorithm's own order, deterministic
};

/// Choice whether lists hold the image shift of each contact, for periodic domains.
enum class Shifts {
  none,    ///< no shifts; a pair is listed as often as it has images within reach
  stored,  ///< 12 bytes more a pair
};

/// Value of Options::max_pairs for no limit on the number of pairs.
inline constexpr PairCount unlimited_pairs = std::numeric_limits<PairCount>::max();

/// Value of Options::max_bytes for the memory of the machine; arrays that follow the extent of the
/// domain rather than the elements (heads of cells or rows) may take 1 GiB + 2 KiB per element.
inline constexpr std::uint64_t automatic_memory_bound = 0;

/// Options of a detection. Each has a default; set what you need.
struct Options {
  /// Algorithm that finds the pairs.
  Algorithm algorithm = Algorithm::automatic;
  /// Order of the pairs in a list.
  Order order = Order::canonical;

  /// Choice whether lists hold image shifts.
  Shifts shifts = Shifts::none;

  /// Quantities that lists hold of each contact: 8 bytes more for a number, 24 for a vector. Counts
  /// and visitors do not use them; see PairMeasurer for these.
  Quantities quantities = {};

  /// Distance from touching up to which elements are contact pairs, too; finite, >= 0, in the unit
  /// of the positions.
  double margin = 0.0;

  /// Rule that says which elements may pair; all, if it is empty.
  PairRule rule = {};

  /// Largest number of pairs. One more throws Error{limit_exceeded}.
  PairCount max_pairs = unlimited_pairs;

  /// Largest number of bytes that a detection may hold in its own buffers. It is checked before
  /// each allocation; Error{limit_exceeded} names the bytes needed.
  std::uint64_t max_bytes = automatic_memory_bound;

  /// Number of threads; 0 for OpenMP's default. Never more than elements nor than 1,024. The
  /// algorithms of the book always use one. Any number gives the same bytes.
  int threads = 0;

  /// Instruction set of the kernels of `rows`. One that this processor lacks throws
  /// Error{unavailable}.
  Simd simd = Simd::automatic;

  /// Function that is told how far a long detection is, and may cancel it.
  ProgressHook progress = {};
};

}  // namespace abut
