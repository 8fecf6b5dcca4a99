// The undecided ones among hits, included like simd_lanes-inl.hpp.

/// Notes the undecided ones among the hits, bits of which the first are written to `place` on.
template <class HitBits>
HWY_INLINE void note_undecided(HitBuffer& to, HitBits hits, HitBits undecided, std::size_t place) {
  for (; undecided != 0; undecided &= undecided - 1) {
    const HitBits below = (undecided & (HitBits{0} - undecided)) - 1;
    const std::size_t own = place + static_cast<std::size_t>(std::popcount(hits & below));
    to.undecided[to.undecided_count++] = static_cast<std::uint32_t>(own);
  }
}
