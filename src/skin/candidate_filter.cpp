// docs/derivations/skin.md has the bands.

#include "skin/candidate_filter.hpp"

#include "elements/lattice_of.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/sphere_predicate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace abut::skin {
namespace {

using kernels::CandidateVerdict;
using kernels::CandidateWords;
using kernels::QuantumSphere;

/// Slots, 4 MiB in all, that a cache holds: their partners are not asked for in time.
constexpr std::size_t slots_in_cache = std::size_t{1} << 18;

/// Returns a - b modulo 2^32, without overflow.
std::int32_t difference(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

/// Filters `count` candidates by the same operations as the kernels.
CandidateVerdict sift(const CandidateWords& words, std::size_t count) {
  CandidateVerdict verdict{0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    const QuantumSphere& a = words.slots[words.pairs[k].first];
    const QuantumSphere& b = words.slots[words.pairs[k].second];
    const QuantumSphere& image =
        words.images[words.image_of == nullptr ? std::size_t{0} : words.image_of[k]];
    float square = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto d = static_cast<float>(
          difference(difference(a.center[axis], b.center[axis]), image.center[axis]));
      square += d * d;
    }
    const auto reach =
        static_cast<float>(difference(difference(a.radius, ~b.radius), image.radius));
    const float outer = reach + kernels::quantum_slack;
    const float inner = std::max(reach - kernels::quantum_slack, 0.0f);
    const bool together = square < inner * inner * (1.0f - kernels::square_band);
    const bool near = square <= outer * outer * (1.0f + kernels::square_band);
    verdict.together |= std::uint64_t{together} << k;
    verdict.left_undecided |= std::uint64_t{near && !together} << k;
  }
  return verdict;
}

/// Calls body(axis, product) for all that a shift's lattice vector is summed from.
template <int Dim, class Body>
void for_each_product(const exact::Lattice& lattice, const ImageShift& shift, Body&& body) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    for (std::size_t k = 0; k < Dim; ++k) {
      body(axis, exact::numbers(shift)[k] * lattice.vectors[k][axis]);
    }
  }
}

template <int Dim>
double farthest_of(const exact::Lattice& lattice, std::span<const ImageShift> shifts) {
  double farthest = 0.0;
  for (const ImageShift& shift : shifts) {
    double sum = 0.0;
    for_each_product<Dim>(lattice, shift,
                          [&](std::size_t, double product) { sum += std::fabs(product); });
    farthest = std::max(farthest, sum);
  }
  return farthest;
}

/// Returns an upper bound, for the whole system, of any coordinate of a difference and any reach.
template <int Dim>
double largest_length(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing,
                      double farthest_image) {
  double half = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    half = std::max(half, 0.5 * now.bounds.upper[axis] - 0.5 * now.bounds.lower[axis]);
  }
  if (now.domain.is_periodic()) half = placing.magnitude();
  return half + farthest_image + now.largest_reach();
}

}  // namespace

template <int Dim>
Quanta<Dim>::Quanta(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing,
                    double farthest_image)
    : kernels_(kernels::candidate_kernels(now.simd)) {
  const double largest = largest_length(now, placing, farthest_image);
  if (!(largest > 0x1p-900 && largest < 0x1p900)) return;
  per_length_ = most * std::ldexp(0.5, -std::ilogb(largest));
  if (now.domain.is_periodic()) return;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    middle_[axis] = 0.5 * now.bounds.lower[axis] + 0.5 * now.bounds.upper[axis];
  }
}

template <int Dim>
void Quanta<Dim>::fill(const exact::Sphere<Dim>* spheres, const ElementIndex* numbers,
                       std::span<kernels::QuantumSphere> slots) const {
  if (slots.empty()) return;
  std::size_t k = 0;
  if constexpr (Dim == 3) {
    k = kernels_.fill({spheres->center,
                       numbers,
                       slots.size(),
                       slots.data(),
                       {middle_[0], middle_[1], middle_[2], 0.0},
                       per_length_,
                       most});
  }
  for (; k < slots.size(); ++k) slots[k] = of(spheres[numbers == nullptr ? k : numbers[k]]);
}

template <int Dim>
CandidateFilter<Dim>::CandidateFilter(const ElementsNow<Dim>& now,
                                      const DisplacementTracker<Dim>& placing,
                                      const CandidateColumns& candidates, Images& images)
    : now_(now),
      placing_(placing),
      candidates_(candidates),
      lattice_(elements::lattice_of(now.domain)),
      images_(images),
      kernels_(kernels::candidate_kernels(now.simd)),
      quanta_(now, placing, farthest_of<Dim>(lattice_, candidates.shifts)) {
  fill_images();
}

template <int Dim>
void CandidateFilter<Dim>::fill_images() {
  images_.clear();
  const std::int32_t margin = quanta_.whole(now_.margin);
  for (const ImageShift& shift : candidates_.shifts) {
    std::array<double, 3> image{};
    for_each_product<Dim>(lattice_, shift,
                          [&](std::size_t axis, double product) { image[axis] += product; });
    images_.push_back(
        {{quanta_.whole(image[0]), quanta_.whole(image[1]), quanta_.whole(image[2])}, -margin});
  }
  if (images_.empty()) images_.push_back({{0, 0, 0}, -margin});
}

template <int Dim>
void CandidateFilter<Dim>::run(std::size_t first_word, std::span<std::uint64_t> survivors,
                               const QuantumSphere* slots, std::uint64_t& exact_decisions) const {
  const std::span<const SlotPair> pairs = candidates_.layout.candidates();
  const std::size_t first = 64 * first_word;
  const std::size_t count = std::min(pairs.size() - first, 64 * survivors.size());
  const auto words_from = [&](std::size_t k, std::size_t words) {
    return CandidateWords{pairs.data() + k,
                          slots,
                          images_.data(),
                          candidates_.shift_of == nullptr ? nullptr : candidates_.shift_of + k,
                          words,
                          candidates_.layout.slot_count() > slots_in_cache};
  };
  std::array<CandidateVerdict, words_of_run> verdicts;
  std::size_t done = quanta_.fit() ? kernels_.sift(words_from(first, count / 64), verdicts.data())
                                   : std::size_t{0};
  for (; 64 * done < count; ++done) {
    const std::size_t rest = std::min<std::size_t>(64, count - 64 * done);
    verdicts[done] = quanta_.fit() ? sift(words_from(first + 64 * done, 1), rest)
                                   : CandidateVerdict{0, ~std::uint64_t{0} >> (64 - rest)};
  }
  for (std::size_t word = 0; word < survivors.size(); ++word) {
    survivors[word] = confirm(first + 64 * word, verdicts[word], exact_decisions);
  }
}

/// Returns the candidates that are certainly together, and those undecided ones that the predicate
/// accepts on the caller's numbers.
template <int Dim>
std::uint64_t CandidateFilter<Dim>::confirm(std::size_t first, const CandidateVerdict& verdict,
                                            std::uint64_t& exact_decisions) const {
  std::uint64_t survivors = verdict.together;
  for (std::uint64_t rest = verdict.left_undecided; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(rest));
    const ContactPair pair = candidates_.layout.pair_of(candidates_.layout.candidates()[first + k]);
    const exact::Sphere<Dim>& a = now_.spheres[pair.first];
    const exact::Sphere<Dim>& b = now_.spheres[pair.second];
    const bool touch =
        candidates_.shift_of == nullptr
            ? exact::within_reach(a, b, now_.margin, exact_decisions)
            : exact::within_reach(a, b,
                                  placing_.shift_as_given(
                                      pair, candidates_.shifts[candidates_.shift_of[first + k]]),
                                  lattice_, now_.margin, exact_decisions);
    survivors |= std::uint64_t{touch} << k;
  }
  return survivors;
}

template class Quanta<2>;
template class Quanta<3>;
template class CandidateFilter<2>;
template class CandidateFilter<3>;

}  // namespace abut::skin
