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
// abut::Simd names no level between scalar and sse4, so nothing could choose this one.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/tile_search.hpp"

#include <bit>

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

/// Candidates gathered contiguously. It works on copies of the job's pointers, which stay in
/// registers: the compiler must assume that any store of a vector changes what lies in memory.
template <int Dim, bool EqualRadii>
class SimdBlock {
 public:
  struct Element {
    float center[Dim];
    float outer;  ///< reach + slack and reach - slack: its own part, or all where radii are equal
    float inner;
    std::uint32_t number;
  };

  HWY_INLINE SimdBlock(const TileView& tile, SearchJob& job)
      : tile_(tile), job_(job), radius_(job.block[3]), number_(job.block_number) {
    for (int axis = 0; axis < Dim; ++axis) center_[axis] = job.block[axis];
    if constexpr (EqualRadii) {
      common_outer_ = outer(tile.common_radius, job.slack);
      common_inner_ = inner(tile.common_radius, job.slack);
    }
    take_room();
  }

  /// Tells the job what was found and done; nothing is met after it.
  HWY_INLINE void finish() {
    job_.filled = filled_;
    job_.candidate_tests += candidate_tests_;
  }

  [[nodiscard]] HWY_INLINE std::size_t size() const { return size_; }

  /// Copies a run behind what is there: whole vectors, the excess is overwritten later.
  HWY_INLINE void append(std::size_t begin, std::size_t end) {
    for (std::size_t k = 0; begin + k < end; k += lanes) {
      for (int axis = 0; axis < Dim; ++axis) {
        hn::StoreU(hn::LoadU(floats, tile_.center[axis] + begin + k), floats,
                   center_[axis] + size_ + k);
      }
      if constexpr (!EqualRadii) {
        hn::StoreU(hn::LoadU(floats, tile_.radius + begin + k), floats, radius_ + size_ + k);
      }
      hn::StoreU(hn::LoadU(numbers, tile_.number + begin + k), numbers, number_ + size_ + k);
    }
    size_ += end - begin;
  }

  /// Fills up the last vector with what is within reach of nothing.
  HWY_INLINE void close() {
    hn::StoreU(hn::Set(floats, far_away), floats, center_[0] + size_);
    if constexpr (!EqualRadii) hn::StoreU(hn::Zero(floats), floats, radius_ + size_);
  }

  HWY_INLINE Element element(std::size_t p) const {
    Element result;
    for (int axis = 0; axis < Dim; ++axis) result.center[axis] = center_[axis][p];
    result.outer = EqualRadii ? common_outer_ : outer(radius_[p], job_.slack);
    result.inner = EqualRadii ? common_inner_ : inner(radius_[p], job_.slack);
    result.number = number_[p];
    return result;
  }

  HWY_INLINE Element element_of(const Visitor& visitor) const {
    Element result;
    for (int axis = 0; axis < Dim; ++axis) result.center[axis] = visitor.center[axis];
    result.outer = outer(visitor.radius, visitor.slack);
    result.inner = inner(visitor.radius, visitor.slack);
    result.number = visitor.number;
    return result;
  }

  /// Tests the element against all candidates from `first` on. Vectors begin at multiples of their
  /// length, so that elements of one block take equally many turns, which the processor foresees.
  ///
  /// First as if the filter could decide everything: a loop without calls keeps all it needs in
  /// registers. Where it could not, what it found is forgotten and found again with care.
  HWY_INLINE void meet(const Element& element, std::size_t first) {
    if (first >= size_) return;
    candidate_tests_ += size_ - first;
    const std::size_t begin = first / lanes * lanes;
    const Mask wanted =
        hn::Ge(hn::Iota(floats, 0), hn::Set(floats, static_cast<float>(first - begin)));
    if (HWY_LIKELY(filled_ + size_ - begin + 2 * lanes <= capacity_)) {
      const std::size_t filled_before = filled_;
      const Ball ball(element);
      Filtered filtered = filter(ball, begin);
      filtered.hit = hn::And(filtered.hit, wanted);
      Mask undecided = hn::AndNot(filtered.sure, filtered.hit);
      push(ball, filtered.hit, begin);
      for (std::size_t q = begin + lanes; q < size_; q += lanes) {
        filtered = filter(ball, q);
        undecided = hn::Or(undecided, hn::AndNot(filtered.sure, filtered.hit));
        push(ball, filtered.hit, q);
      }
      if (HWY_LIKELY(hn::AllFalse(floats, undecided))) return;
      filled_ = filled_before;
    }
    // A copy, so that this block's own variables need no address.
    SimdBlock careful(*this);
    careful.meet_with_care(element, begin, wanted);
    filled_ = careful.filled_;
    pairs_ = careful.pairs_;
    capacity_ = careful.capacity_;
  }

 private:
  /// An element in all lanes.
  struct Ball {
    HWY_INLINE explicit Ball(const Element& element)
        : outer(hn::Set(floats, element.outer)),
          inner(hn::Set(floats, element.inner)),
          farthest(hn::Set(floats, element.outer * element.outer)),
          nearest(hn::Set(floats, element.inner < 0.0f ? 0.0f : element.inner * element.inner)),
          number(hn::Set(numbers, element.number)) {
      for (int axis = 0; axis < Dim; ++axis) {
        center[axis] = hn::Set(floats, element.center[axis]);
      }
    }

    Floats center[Dim];
    Floats outer;
    Floats inner;
    Floats farthest;  ///< squares, where all radii are equal
    Floats nearest;
    Numbers number;
  };

  struct Filtered {
    Mask hit;   ///< not certainly apart
    Mask sure;  ///< certainly within reach
  };

  HWY_INLINE Filtered filter(const Ball& ball, std::size_t q) const {
    Floats difference = hn::Sub(ball.center[0], hn::LoadU(floats, center_[0] + q));
    Floats distance_squared = hn::Mul(difference, difference);
    for (int axis = 1; axis < Dim; ++axis) {
      difference = hn::Sub(ball.center[axis], hn::LoadU(floats, center_[axis] + q));
      distance_squared = hn::Add(distance_squared, hn::Mul(difference, difference));
    }
    if constexpr (EqualRadii) {
      return {hn::Le(distance_squared, ball.farthest), hn::Lt(distance_squared, ball.nearest)};
    } else {
      const Floats radius = hn::LoadU(floats, radius_ + q);
      const Floats farthest = hn::Add(ball.outer, radius);
      const Floats nearest = hn::Max(hn::Add(ball.inner, radius), hn::Zero(floats));
      return {hn::Le(distance_squared, hn::Mul(farthest, farthest)),
              hn::Lt(distance_squared, hn::Mul(nearest, nearest))};
    }
  }

  /// Writes a pair for each lane of the mask, in order; a whole vector, the excess is overwritten.
  HWY_INLINE void push(const Ball& ball, Mask hit, std::size_t q) {
    if (few_hits_ && hn::AllFalse(floats, hit)) return;
    const Numbers partner = compress(hn::LoadU(numbers, number_ + q), hit);
    hn::StoreInterleaved2(hn::Min(ball.number, partner), hn::Max(ball.number, partner), numbers,
                          reinterpret_cast<std::uint32_t*>(pairs_ + filled_));
    filled_ += hn::CountTrue(floats, hit);
  }

  /// The same with exact decisions and room for any number of pairs.
  HWY_NOINLINE void meet_with_care(const Element& element, std::size_t begin, Mask wanted) {
    const Ball ball(element);
    for (std::size_t q = begin; q < size_; q += lanes) {
      Filtered filtered = filter(ball, q);
      filtered.hit = hn::And(filtered.hit, wanted);
      wanted = hn::MaskFromVec(hn::BitCast(floats, hn::Set(numbers, ~0u)));
      const Mask undecided = hn::AndNot(filtered.sure, filtered.hit);
      if (!hn::AllFalse(floats, undecided)) settle(filtered.hit, undecided, element.number, q);
      push(ball, filtered.hit, q);
      if (filled_ + 2 * lanes <= capacity_) continue;
      job_.filled = filled_;
      job_.flush(job_);
      take_room();
    }
  }

  /// Decides the undecided lanes exactly.
  void settle(Mask& hit, Mask undecided, std::uint32_t number, std::size_t q) {
    std::uint8_t hits[8] = {};
    std::uint8_t asked[8] = {};
    hn::StoreMaskBits(floats, hit, hits);
    hn::StoreMaskBits(floats, undecided, asked);
    for (unsigned rest = asked[0] | unsigned{asked[1]} << 8u; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      if (job_.decide(job_, number, number_[q + static_cast<std::size_t>(lane)])) continue;
      hits[lane / 8] = static_cast<std::uint8_t>(hits[lane / 8] & ~(1u << lane % 8));
    }
    hit = hn::LoadMaskBits(floats, hits);
  }

  [[nodiscard]] HWY_INLINE float outer(float radius, float slack) const {
    return radius + job_.margin + (EqualRadii ? tile_.common_radius : 0.0f) + slack;
  }
  [[nodiscard]] HWY_INLINE float inner(float radius, float slack) const {
    return radius + job_.margin + (EqualRadii ? tile_.common_radius : 0.0f) - slack;
  }

  HWY_INLINE void take_room() {
    pairs_ = job_.pairs;
    filled_ = job_.filled;
    capacity_ = job_.capacity;
  }

  static constexpr FloatTag floats{};
  static constexpr NumberTag numbers{};
  static constexpr std::size_t lanes = hn::MaxLanes(FloatTag());

  const TileView& tile_;
  SearchJob& job_;
  float* center_[Dim];
  float* radius_;
  float common_outer_ = 0.0f;
  float common_inner_ = 0.0f;
  std::uint32_t* number_;
  ContactPair* pairs_;
  std::size_t filled_;
  std::size_t capacity_;
  std::size_t size_ = 0;
  std::size_t candidate_tests_ = 0;
  /// Whether most vectors are without a hit, so that looking first pays.
  const bool few_hits_ = job_.few_hits;
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
