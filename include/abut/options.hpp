#pragma once

#include <abut/algorithm.hpp>
#include <abut/export.hpp>
#include <abut/pair.hpp>
#include <abut/pair_rule.hpp>
#include <abut/progress.hpp>
#include <abut/simd.hpp>

#include <cstdint>
#include <limits>

namespace abut {

/// Order of the pairs that are returned.
enum class Order {
  canonical,  ///< ascending by (first, second, shift): the same bytes from every algorithm
  as_found,   ///< as the algorithm meets them: deterministic, but its own
};

/// Whether a list of contacts holds the image shift of each, for periodic domains.
enum class Shifts {
  none,    ///< a pair of several images within reach is listed as often as it has such images
  stored,  ///< 12 bytes more a pair
};

/// What a neighbor list holds beside the numbers of the neighbors.
enum class NeighborData {
  none,
  distances,              ///< 8 bytes more a neighbor
  vectors,                ///< 24 bytes more a neighbor
  distances_and_vectors,  ///< both
};

/// No limit on the number of pairs.
inline constexpr PairCount unlimited_pairs = std::numeric_limits<PairCount>::max();

/// The memory of the machine; for arrays that follow the extent of the domain rather than the
/// elements (heads of cells or rows) 1 GiB + 2 KiB per element.
inline constexpr std::uint64_t automatic_memory_bound = 0;

struct Options {
  Algorithm algorithm = Algorithm::automatic;
  Order order = Order::canonical;

  Shifts shifts = Shifts::none;

  /// For neighbor lists.
  NeighborData neighbor_data = NeighborData::none;

  /// Elements within this distance of touching are contact pairs too; finite, >= 0, in the unit
  /// of the positions.
  double margin = 0.0;

  /// Which of the elements may pair; all, unless it says something.
  PairRule rule = {};

  /// One more pair than this throws Error{limit_exceeded}.
  PairCount max_pairs = unlimited_pairs;

  /// Bytes that a detection may hold in buffers of its own. Checked before each allocation:
  /// Error{limit_exceeded} names the bytes needed.
  std::uint64_t max_bytes = automatic_memory_bound;

  /// Number of threads, 0 for what OpenMP takes by default. The algorithms of the book use one
  /// whatever it says. Any number gives the same bytes.
  int threads = 0;

  /// Instruction set of the kernels of `rows`. One that this processor lacks throws
  /// Error{unavailable}.
  Simd simd = Simd::automatic;

  ProgressHook progress = {};
};

}  // namespace abut
