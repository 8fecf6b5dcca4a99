// docs/derivations/skin.md has the bands.

#include "skin/candidate_filter.hpp"

#include "elements/lattice_of.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/sphere_predicate.hpp"

#include <algorithm>
#include <array>
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
  const double half =
      now.domain.is_periodic() ? placing.magnitude() : now.bounds.largest_half_width();
  return half + farthest_image + now.largest_reach();
}

}  // namespace

template <int Dim>
Quanta<Dim> quanta_of_placed(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing,
                             std::span<const ImageShift> shifts) {
  const double farthest = farthest_of<Dim>(elements::lattice_of(now.domain), shifts);
  return Quanta<Dim>(largest_length(now, placing, farthest),
                     now.domain.is_periodic() ? std::array<double, Dim>{} : now.bounds.middle());
}

template <int Dim>
CandidateFilter<Dim>::CandidateFilter(const CallNow& now, const GivenSpheres<Dim>& spheres,
                                      const DisplacementTracker<Dim>& placing,
                                      const CandidateColumns& candidates, const Quanta<Dim>& quanta,
                                      Images& images)
    : now_(now),
      spheres_(spheres),
      placing_(placing),
      candidates_(candidates),
      lattice_(elements::lattice_of(now.domain)),
      quanta_(quanta),
      images_(images),
      kernels_(kernels::candidate_kernels(now.simd)) {
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
                               const QuantumSphere* slots, UndecidedCounts& undecided) const {
  const std::span<const SlotPair> pairs = candidates_.layout.candidates();
  const std::size_t first = 64 * first_word;
  const std::size_t count = std::min(pairs.size() - first, 64 * survivors.size());
  const bool partners_far = candidates_.layout.slot_count() > slots_in_cache;
  const auto words_from = [&](std::size_t k, std::size_t words) {
    return CandidateWords{pairs.data() + k,
                          slots,
                          images_.data(),
                          candidates_.shift_of == nullptr ? nullptr : candidates_.shift_of + k,
                          words,
                          partners_far ? (pairs.size() - k) / 64 : 0};
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
    survivors[word] = confirm(first + 64 * word, verdicts[word], undecided);
  }
}

/// Returns the candidates that are certainly together, and those undecided ones that the predicate
/// accepts on the caller's numbers.
template <int Dim>
std::uint64_t CandidateFilter<Dim>::confirm(std::size_t first, const CandidateVerdict& verdict,
                                            UndecidedCounts& undecided) const {
  std::uint64_t survivors = verdict.together;
  std::array<exact::Sphere<Dim>, 2> room;
  undecided.by_quanta += static_cast<std::uint64_t>(std::popcount(verdict.left_undecided));
  for (std::uint64_t rest = verdict.left_undecided; rest != 0; rest &= rest - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(rest));
    const ContactPair pair = candidates_.layout.pair_of(candidates_.layout.candidates()[first + k]);
    const exact::Sphere<Dim>& a = spheres_.find(pair.first, room[0]);
    const exact::Sphere<Dim>& b = spheres_.find(pair.second, room[1]);
    const bool touch =
        candidates_.shift_of == nullptr
            ? exact::within_reach(a, b, now_.margin, undecided.by_doubles)
            : exact::within_reach(a, b,
                                  placing_.shift_as_given(
                                      pair, candidates_.shifts[candidates_.shift_of[first + k]]),
                                  lattice_, now_.margin, undecided.by_doubles);
    survivors |= std::uint64_t{touch} << k;
  }
  return survivors;
}

template Quanta<2> quanta_of_placed(const ElementsNow<2>&, const DisplacementTracker<2>&,
                                    std::span<const ImageShift>);
template Quanta<3> quanta_of_placed(const ElementsNow<3>&, const DisplacementTracker<3>&,
                                    std::span<const ImageShift>);
template class CandidateFilter<2>;
template class CandidateFilter<3>;

}  // namespace abut::skin
