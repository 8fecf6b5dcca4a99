#pragma once

#include <abut/neighbor_list.hpp>
#include <abut/pair_list.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace abut::benchmarks {

/// Whether numbers have the same bits: 0.0 and -0.0 have not.
inline bool have_same_bits(std::span<const double> a, std::span<const double> b) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  return std::ranges::equal(a, b, {}, bits, bits);
}

inline bool same(const PairList& a, const PairList& b) {
  return std::ranges::equal(a.pairs(), b.pairs()) && std::ranges::equal(a.shifts(), b.shifts()) &&
         have_same_bits(a.gaps(), b.gaps());
}

inline bool same(const NeighborList& a, const NeighborList& b) {
  return std::ranges::equal(a.offsets(), b.offsets()) &&
         std::ranges::equal(a.neighbors(), b.neighbors()) &&
         std::ranges::equal(a.shifts(), b.shifts()) && have_same_bits(a.gaps(), b.gaps());
}

}  // namespace abut::benchmarks
