// The candidate loop in vectors, compiled once for each instruction set (Highway).
//
// The filter works in single precision. `slack` bounds the error of a computed distance, so that
//   d < r_i + r_j + margin - slack  is certainly a contact pair,
//   d > r_i + r_j + margin + slack  is certainly none,
// and what lies between is decided exactly on the original numbers
// (docs/derivations/tile_filter.md). Products are not fused with sums: the same lanes are undecided
// on every processor.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/tile_search_simd.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/tile_search.hpp"

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using NumberTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Numbers = hn::Vec<NumberTag>;
using Mask = hn::Mask<FloatTag>;

/// Far beyond every tile, yet with a finite square: never within reach.
constexpr float far_away = 1e18f;

/// The lanes of the mask, in order, then the others.
HWY_INLINE Numbers compress(Numbers values, Mask mask) {
  constexpr NumberTag numbers;
#if HWY_TARGET == HWY_AVX3
  return hn::Compress(values, hn::RebindMask(numbers, mask));
#else
  static_assert(hn::MaxLanes(FloatTag()) <= 8);
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(FloatTag(), mask, bits);
  const auto order = hn::PromoteTo(
      numbers, hn::LoadU(hn::Rebind<std::uint8_t, NumberTag>(), compress_table[bits[0]].data()));
  return hn::TableLookupLanes(values, hn::IndicesFromVec(numbers, order));
#endif
}

/// Candidates gathered contiguously.
template <int Dim, bool EqualRadii>
class SimdBlock {
 public:
  struct Element {
    float center[Dim];
    float reach;  ///< radius + margin, + the common radius where all are equal
    float slack;
    std::uint32_t number;
  };

  SimdBlock(const TileView& tile, SearchJob& job) : tile_(tile), job_(job) {}

  void clear() { size_ = 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Copies a run behind what is there: whole vectors, the excess is overwritten later.
  HWY_INLINE void append(std::size_t begin, std::size_t end) {
    for (std::size_t k = 0; begin + k < end; k += lanes) {
      for (int axis = 0; axis < Dim; ++axis) {
        hn::StoreU(hn::LoadU(floats, tile_.center[axis] + begin + k), floats,
                   job_.block[axis] + size_ + k);
      }
      if constexpr (!EqualRadii) {
        hn::StoreU(hn::LoadU(floats, tile_.radius + begin + k), floats, job_.block[3] + size_ + k);
      }
      hn::StoreU(hn::LoadU(numbers, tile_.number + begin + k), numbers,
                 job_.block_number + size_ + k);
    }
    size_ += end - begin;
  }

  /// Fills up the last vector with what is within reach of nothing.
  HWY_INLINE void close() {
    hn::StoreU(hn::Set(floats, far_away), floats, job_.block[0] + size_);
    if constexpr (!EqualRadii) hn::StoreU(hn::Zero(floats), floats, job_.block[3] + size_);
  }

  HWY_INLINE Element element(std::size_t p) const {
    Element result;
    for (int axis = 0; axis < Dim; ++axis) result.center[axis] = job_.block[axis][p];
    result.reach = reach_of(EqualRadii ? tile_.common_radius : job_.block[3][p]);
    result.slack = job_.slack;
    result.number = job_.block_number[p];
    return result;
  }

  HWY_INLINE Element element_of(const Visitor& visitor) const {
    Element result;
    for (int axis = 0; axis < Dim; ++axis) result.center[axis] = visitor.center[axis];
    result.reach = reach_of(visitor.radius);
    result.slack = visitor.slack;
    result.number = visitor.number;
    return result;
  }

  /// Tests the element against all candidates from `first` on.
  HWY_INLINE void meet(const Element& element, std::size_t first) {
    if (first >= size_) return;
    job_.candidate_tests += size_ - first;
    Floats center[Dim];
    for (int axis = 0; axis < Dim; ++axis) center[axis] = hn::Set(floats, element.center[axis]);
    const Floats outer = hn::Set(floats, element.reach + element.slack);
    const Floats inner = hn::Set(floats, element.reach - element.slack);
    const auto number = hn::Set(numbers, element.number);
    Floats farthest = hn::Mul(outer, outer);
    Floats nearest = hn::Max(inner, hn::Zero(floats));
    nearest = hn::Mul(nearest, nearest);

    for (std::size_t q = first; q < size_; q += lanes) {
      Floats difference = hn::Sub(center[0], hn::LoadU(floats, job_.block[0] + q));
      Floats distance_squared = hn::Mul(difference, difference);
      for (int axis = 1; axis < Dim; ++axis) {
        difference = hn::Sub(center[axis], hn::LoadU(floats, job_.block[axis] + q));
        distance_squared = hn::Add(distance_squared, hn::Mul(difference, difference));
      }
      if constexpr (!EqualRadii) {
        const Floats radius = hn::LoadU(floats, job_.block[3] + q);
        farthest = hn::Add(outer, radius);
        farthest = hn::Mul(farthest, farthest);
        nearest = hn::Max(hn::Add(inner, radius), hn::Zero(floats));
        nearest = hn::Mul(nearest, nearest);
      }
      Mask hit = hn::Le(distance_squared, farthest);
      const Mask undecided = hn::AndNot(hn::Lt(distance_squared, nearest), hit);
      if (HWY_UNLIKELY(!hn::AllFalse(floats, undecided))) {
        hit = settle(hit, undecided, element.number, q);
      }
      const Numbers partner = compress(hn::LoadU(numbers, job_.block_number + q), hit);
      hn::StoreInterleaved2(hn::Min(number, partner), hn::Max(number, partner), numbers,
                            reinterpret_cast<std::uint32_t*>(job_.pairs + job_.filled));
      job_.filled += hn::CountTrue(floats, hit);
      if (HWY_UNLIKELY(job_.filled + 2 * lanes > job_.capacity)) job_.flush(job_);
    }
  }

 private:
  HWY_INLINE float reach_of(float radius) const {
    return radius + job_.margin + (EqualRadii ? tile_.common_radius : 0.0f);
  }

  /// Decides the undecided lanes exactly.
  HWY_NOINLINE Mask settle(Mask hit, Mask undecided, std::uint32_t number, std::size_t q) {
    HWY_ALIGN std::uint8_t hits[8] = {};
    HWY_ALIGN std::uint8_t asked[8] = {};
    hn::StoreMaskBits(floats, hit, hits);
    hn::StoreMaskBits(floats, undecided, asked);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto bit = static_cast<std::uint8_t>(1u << (lane % 8));
      if ((asked[lane / 8] & bit) == 0) continue;
      if (!job_.decide(job_, number, job_.block_number[q + lane])) {
        hits[lane / 8] = static_cast<std::uint8_t>(hits[lane / 8] & ~bit);
      }
    }
    return hn::LoadMaskBits(floats, hits);
  }

  static constexpr FloatTag floats{};
  static constexpr NumberTag numbers{};
  const std::size_t lanes = hn::Lanes(floats);

  const TileView& tile_;
  SearchJob& job_;
  std::size_t size_ = 0;
};

#include "kernels/tile_search-inl.hpp"

#include "kernels/tile_search_variants-inl.hpp"

void search_tile(const TileView& tile, SearchJob& job, int dimensions) {
  search_with<SimdBlock>(tile, job, dimensions);
}

void visit_tile(const TileView& tile, SearchJob& job, int dimensions, const Visitor& visitor,
                std::span<const Run> runs) {
  visit_with<SimdBlock>(tile, job, dimensions, visitor, runs);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(search_tile);
HWY_EXPORT(visit_tile);

TileKernels simd_tile_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(search_tile)[chosen.GetIndex()],
          HWY_DISPATCH_TABLE(visit_tile)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
