// Lanes of single precision, of which sets are bits, included once for each instruction set into
// the namespace of a file of kernels that has included Highway, compress_table.hpp, <cstdint> and
// <cstring>: no include guard, and no includes.

/// Runs are short: wider vectors would be mostly empty.
using FloatTag = hn::CappedTag<float, 8>;
using NumberTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Numbers = hn::Vec<NumberTag>;
using Mask = hn::Mask<FloatTag>;
constexpr FloatTag floats{};
constexpr NumberTag numbers{};
constexpr std::size_t lanes = hn::MaxLanes(FloatTag());

/// All lanes that a vector has, for candidates that stand in long rows.
using WideTag = hn::ScalableTag<float>;
constexpr WideTag wide_floats{};
constexpr std::size_t wide_lanes = hn::MaxLanes(WideTag());

/// A lane is a bit.
using Bits = std::uint32_t;
constexpr Bits all_lanes = (1u << lanes) - 1;

template <class Tag>
HWY_INLINE Bits bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  if constexpr (hn::MaxLanes(Tag()) <= 8) return bits[0];
  static_assert(hn::MaxLanes(Tag()) <= 16);
  std::uint16_t of_all = 0;
  std::memcpy(&of_all, bits, sizeof(of_all));
  return of_all;
}

HWY_INLINE Bits bits_of(Mask mask) {
  return bits_of(floats, mask);
}

HWY_INLINE Bits wide_bits_of(hn::Mask<WideTag> mask) {
  return bits_of(wide_floats, mask);
}

/// The lanes of the set, in order, then the others.
HWY_INLINE Numbers compress(Numbers values, Bits set) {
  const auto order = hn::PromoteTo(
      numbers, hn::LoadU(hn::Rebind<std::uint8_t, NumberTag>(), compress_table[set].data()));
  return hn::TableLookupLanes(values, hn::IndicesFromVec(numbers, order));
}
